// Draws opaque triangles with hidden-surface removal, with four samples per pixel, into a separate
// layer. Curves and arrows use the layer's depth for occlusion.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "render/context/light_format.h"
#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class MeshPass {
 public:
    explicit MeshPass(LightBits light);
    void begin_picture();
    // Determines the layer's position in the view, and adds the shadows of the meshes.
    void prepare(ViewScene& scene);
    // Binds the layer and draws the meshes into it.
    void draw_layer(const ViewScene& scene);
    // Draws the layer over the picture, and binds its depth for the following passes. Precondition:
    // a vertex array without attributes is bound.
    void draw(const ViewScene& scene) const;
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    // A program that draws triangles: in one colour, or with a picture.
    struct Drawer {
        explicit Drawer(const std::vector<std::string>& defines);
        Program program;
        GLint placement, normal_map, view, projection, look;
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
    // Make the textures and framebuffers of the layer.
    void make_multisampled();
    void make_side_by_side();
    // projection: of the view's layer.
    void draw_meshes(const ViewScene& scene, const glm::mat4& projection);
    void draw_mesh(const Drawer& drawer, const ViewScene& scene, const Mesh& mesh);

    LightFormat light_;
    Drawer plain_;
    std::optional<Drawer> pictured_;  // made for the first picture
    PolygonProgram over_;
    // In a desktop's OpenGL, the four samples of a pixel are in multisampled textures; in a
    // browser's four pictures are side by side in one texture, each displaced to one of the
    // samples.
    GlTexture samples_, depth_, resolved_;
    GlFramebuffer sampled_, single_;
    int width_px_ = 0, height_px_ = 0;
    std::unordered_map<std::uint64_t, Uploaded> uploads_;
    std::uint64_t picture_number_ = 0;
};

}  // namespace poinsot
