#include "render/passes/label_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "error/error.h"
#include "render/passes/colour.h"

namespace poinsot {
namespace {

constexpr int first_width_px = 1024, first_height_px = 256;

// The width of the halo, in pixels of the mask.
double halo_reach(const Label& label) { return std::max(label.halo_px, 0.0) / label.mask->samples; }

// The margin around the mask for its halo, in pixels of the mask.
int margin_of(const Label& label) { return static_cast<int>(std::ceil(halo_reach(label))) + 1; }

// All samples of each pixel whose centre is on the mask or its margin.
PixelBox box_of(const Label& label) {
    const int n = label.mask->samples;
    const double margin_px = n * margin_of(label) + 0.5 * (n - 1);
    PixelBox box;
    box.add(label.top_left_px, margin_px);
    box.add(label.top_left_px + Eigen::Vector2d(label.mask->width_px(), label.mask->height_px()),
            margin_px);
    return box;
}

bool shows(const Label& label) {
    return label.mask != nullptr && label.mask->width > 0 && label.mask->height > 0 &&
           label.opacity > 0.0;
}

bool is_inner(const GlyphMask& mask, int x, int y) {
    if (x == 0 || y == 0 || x + 1 == mask.width || y + 1 == mask.height) return false;
    const std::uint8_t* at = mask.coverage.data() +
                             static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + x;
    return at[-1] == 255 && at[1] == 255 && at[-mask.width] == 255 && at[mask.width] == 255;
}

}  // namespace

PlacedLabel::PlacedLabel(const Label& label)
    : mask(label.mask->id),
      top_left_px(label.top_left_px),
      colour(label.colour),
      halo_colour(label.halo_colour),
      inks(label.inks),
      halo_px(label.halo_px),
      opacity(label.opacity),
      box(box_of(label)) {}

bool PlacedLabel::operator==(const PlacedLabel& other) const {
    return mask == other.mask && top_left_px == other.top_left_px && colour == other.colour &&
           inks == other.inks && halo_colour == other.halo_colour && halo_px == other.halo_px &&
           opacity == other.opacity;
}

std::vector<std::uint8_t> with_halo(const GlyphMask& mask, double reach_px, int margin) {
    const int width = mask.width + 2 * margin, height = mask.height + 2 * margin;
    std::vector<std::uint8_t> texels(3 * static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
    // The halo has full strength up to half its width, then falls smoothly to zero.
    struct Brush {
        int x, y;
        double weight;
    };
    std::vector<Brush> brush;
    for (int y = -margin; y <= margin && reach_px > 0.0; ++y) {
        for (int x = -margin; x <= margin; ++x) {
            const double t =
                std::clamp((reach_px + 0.5 - std::hypot(x, y)) / (0.5 * reach_px + 0.5), 0.0, 1.0);
            if (t > 0.0) brush.push_back({x, y, t * t * (3.0 - 2.0 * t)});
        }
    }
    std::vector<double> halo(texels.size() / 3, 0.0);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                static_cast<std::size_t>(x);
            const std::uint8_t covered = mask.coverage[at];
            if (covered == 0) continue;
            const auto middle =
                static_cast<std::size_t>(y + margin) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x + margin);
            texels[3 * middle] = covered;
            if (!mask.tints.empty()) texels[3 * middle + 2] = mask.tints[at];
            if (brush.empty()) continue;
            halo[middle] = std::max(halo[middle], 1.0 * covered);
            // A pixel surrounded by full pixels is never the nearest one to a pixel outside.
            if (is_inner(mask, x, y)) continue;
            for (const Brush& b : brush) {
                double& there = halo[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) +
                                                              b.y * width + b.x)];
                there = std::max(there, covered * b.weight);
            }
        }
    }
    for (std::size_t k = 0; k < halo.size(); ++k)
        texels[3 * k + 1] = static_cast<std::uint8_t>(std::lround(halo[k]));
    return texels;
}

LabelPass::LabelPass() : program_("label.frag", 4 + static_cast<int>(most_inks)) {}

LabelPass::Key LabelPass::key_of(const Label& label) { return {label.mask->id, halo_reach(label)}; }

void LabelPass::empty_texture(int width_px, int height_px) {
    slots_.clear();
    shelf_x_ = shelf_y_ = shelf_height_ = 0;
    if (width_px == width_px_ && height_px == height_px_) return;
    width_px_ = width_px;
    height_px_ = height_px;
    texture_ = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width_px, height_px, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

LabelPass::Slot LabelPass::slot_of(const Label& label) {
    Slot slot;
    // The empty margin is wider than the drawn part: the centre of a pixel may lie one texel
    // outside the drawn part, filtering reaches another half texel, and texels further out may
    // contain masks of earlier pictures.
    slot.margin = margin_of(label) + 2;
    slot.width = label.mask->width + 2 * slot.margin;
    slot.height = label.mask->height + 2 * slot.margin;
    return slot;
}

bool LabelPass::place(const Label& label) {
    const Key key = key_of(label);
    if (slots_.contains(key)) return true;
    Slot slot = slot_of(label);
    // Shelf packing: from the top, filled from the left.
    if (shelf_x_ + slot.width > width_px_) {
        shelf_x_ = 0;
        shelf_y_ += shelf_height_;
        shelf_height_ = 0;
    }
    if (slot.width > width_px_ || shelf_y_ + slot.height > height_px_) return false;
    slot.x = shelf_x_;
    slot.y = shelf_y_;
    shelf_x_ += slot.width;
    shelf_height_ = std::max(shelf_height_, slot.height);
    const std::vector<std::uint8_t> texels = with_halo(*label.mask, halo_reach(label), slot.margin);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, slot.x, slot.y, slot.width, slot.height, GL_RGB,
                    GL_UNSIGNED_BYTE, texels.data());
    slots_.emplace(key, slot);
    return true;
}

void LabelPass::begin_picture(const Drawing& drawing) {
    const auto place_all = [&] {
        for (const View& view : drawing.views)
            for (const Label& label : view.labels)
                if (shows(label) && !place(label)) return false;
        return true;
    };
    int widest_px = 0;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels)
            if (shows(label)) widest_px = std::max(widest_px, slot_of(label).width);
    if (widest_px == 0) return;
    GLint largest_side_px = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest_side_px);
    // At least as wide as the widest label: a caption is wide and low.
    int width_px = std::max(width_px_, first_width_px);
    while (width_px < widest_px && width_px < largest_side_px) width_px *= 2;
    const int least_height_px = std::max(height_px_, first_height_px);
    if (width_px != width_px_) empty_texture(width_px, least_height_px);
    if (place_all()) return;
    // If the texture is full, removes the masks of earlier pictures, then grows.
    for (int height_px = least_height_px; height_px <= largest_side_px; height_px *= 2) {
        empty_texture(width_px, height_px);
        if (place_all()) return;
    }
    throw InputError(
        fmt::format("the labels of one picture do not fit into a texture of {0}x{0} pixels; "
                    "make them fewer or smaller",
                    largest_side_px));
}

void LabelPass::draw(const ViewScene& scene,
                     const std::function<bool(const PlacedLabel&)>& wanted) const {
    for (const Label& label : scene.view->labels) {
        if (!shows(label) || !wanted(PlacedLabel(label))) continue;
        const Slot& slot = slots_.at(key_of(label));
        // In 1/256 of a pixel of the mask, which the shader represents exactly anywhere in the
        // texture.
        const int n = label.mask->samples;
        const Eigen::Vector2d corner = (256.0 / n * label.top_left_px).array().round() / 256.0;
        const Eigen::Vector2d to_texel =
            Eigen::Vector2d(slot.x + slot.margin, slot.y + slot.margin) - corner;
        Constants constants;
        constants.add(to_texel.x(), to_texel.y(), 0.0, 0.0);
        constants.add(linear_from_srgb(label.colour, label.opacity));
        constants.add(linear_from_srgb(label.halo_colour, 1.0));
        constants.add(1.0 / n, 0.0, 0.0, 0.0);
        for (std::size_t k = 0; k < most_inks; ++k)
            constants.add(
                linear_from_srgb(k < label.inks.size() ? label.inks[k] : label.colour, 1.0));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture_.id());
        program_.draw(polygon_of(box_of(label)), constants, *scene.drawing);
    }
}

std::vector<PlacedLabel> LabelPass::placed(const Drawing& drawing) {
    std::vector<PlacedLabel> labels;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels)
            if (shows(label)) labels.emplace_back(label);
    return labels;
}

}  // namespace poinsot
