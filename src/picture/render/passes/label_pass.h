// Draws typeset text from a texture atlas that caches recently used masks.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

// Coverage of a mask and of its halo, reach_px wide, on a mask larger by `margin` on each side: row
// by row, coverage and halo alternating.
std::vector<std::uint8_t> with_halo(const GlyphMask& mask, double reach_px, int margin);

// The position of a label in the picture.
struct PlacedLabel {
    explicit PlacedLabel(const Label& label);
    bool operator==(const PlacedLabel& other) const;

    std::uint64_t mask;
    Eigen::Vector2d top_left_px;
    Colour colour, halo_colour;
    std::vector<Colour> inks;
    double halo_px, opacity;
    PixelBox box;
};

class LabelPass {
 public:
    LabelPass();
    // Uploads the masks that the picture needs.
    void begin_picture(const Drawing& drawing);
    // Draws the labels for which `wanted` returns true, in order. Precondition: a vertex array
    // without attributes is bound.
    void draw(const ViewScene& scene, const std::function<bool(const PlacedLabel&)>& wanted) const;
    // The labels of all views of the picture.
    static std::vector<PlacedLabel> placed(const Drawing& drawing);

 private:
    // The place of a mask with its halo in the texture.
    struct Slot {
        int x = 0, y = 0, width = 0, height = 0;
        int margin = 0;
    };
    // All of which the texels depend on: another halo, however near, has its own slot.
    struct Key {
        std::uint64_t mask;
        double halo_reach;
        bool operator==(const Key&) const = default;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const {
            return static_cast<std::size_t>(key.mask * 0x9E3779B97F4A7C15u) ^
                   std::hash<double>()(key.halo_reach);
        }
    };
    static Key key_of(const Label& label);
    // The size of a slot, without its position.
    static Slot slot_of(const Label& label);
    bool place(const Label& label);
    void empty_texture(int width_px, int height_px);

    PolygonProgram program_;
    GlTexture texture_;
    int width_px_ = 0, height_px_ = 0;
    int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;
    std::unordered_map<Key, Slot, KeyHash> slots_;
};

}  // namespace poinsot
