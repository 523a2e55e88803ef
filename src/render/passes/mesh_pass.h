// Opaque triangles with hidden surfaces removed, drawn with four samples a pixel into a layer of
// their own; its depth tells the curves and arrows what they are behind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class MeshPass {
 public:
    MeshPass();
    void begin_picture();
    // Says where the view's layer will lie, and adds the shadows that its meshes cast.
    void prepare(ViewScene& scene);
    // Draws the meshes into the layer, which it binds.
    void draw_layer(const ViewScene& scene);
    // Puts the layer over the picture, and binds its depth for the passes that follow.
    // Precondition: a vertex array without attributes is bound.
    void draw(const ViewScene& scene) const;
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    // What draws triangles: in a colour, or with a picture.
    struct Drawer {
        explicit Drawer(const std::vector<std::string>& defines);
        Program program;
        GLint picture, constants, placement, normal_map, depth_map, look;
    };
    struct Uploaded {
        GlBuffer buffer, places;
        GlVertexArray vertex_array;
        GlTexture picture;
        GLsizei n_vertices = 0;
        Eigen::AlignedBox3d box;
        std::uint64_t last_picture = 0;
    };
    Uploaded& uploaded(const MeshGeometry& geometry);
    void resize(int width_px, int height_px);
    // Makes a drawer current for the view's layer.
    static void begin_view(const Drawer& drawer, const ViewScene& scene);
    void draw_mesh(const Drawer& drawer, const ViewScene& scene, const Mesh& mesh);

    Drawer plain_;
    std::optional<Drawer> pictured_;  // once there is a picture
    PolygonProgram over_;
    GlTexture samples_, depth_, resolved_;
    GlFramebuffer sampled_, single_;
    int width_px_ = 0, height_px_ = 0;
    std::unordered_map<std::uint64_t, Uploaded> uploads_;
    std::uint64_t picture_number_ = 0;
};

}  // namespace poinsot
