#include "render/ellipsoid_pass.h"

#include <algorithm>
#include <string>

#include "render/colour.h"

namespace poinsot {

EllipsoidPass::Variant::Variant(int n_members)
    : program("polygon.vert", "ellipsoid.frag", {"MEMBERS " + std::to_string(n_members)}),
      corners(program.at("corners")),
      members(program.at("members")),
      colours(program.at("colours")),
      line_colours(program.at("line_colours")),
      rulings(program.at("rulings")) {}

void EllipsoidPass::draw(const ViewScene& scene) {
    // Farthest first; each group takes in all that its outline touches.
    order_.clear();
    for (int k = 0; k < scene.n_quadrics(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (scene.quadrics[i].seen && scene.view->ellipsoids[i].opacity > 0.0) order_.push_back(k);
    }
    const auto quadric = [&](int k) -> const Quadric& {
        return scene.quadrics[static_cast<std::size_t>(k)];
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return quadric(a).depth > quadric(b).depth; });
    for (std::size_t first = 0; first < order_.size();) {
        std::size_t end = first + 1;
        PixelBox box = quadric(order_[first]).outline.box;
        for (std::size_t k = end; k < order_.size() && end - first < most_members; ++k) {
            const PixelBox& other = quadric(order_[k]).outline.box;
            if (box.within(other).empty()) continue;
            box.add({other.left, other.top});
            box.add({other.right, other.bottom});
            std::rotate(order_.begin() + static_cast<std::ptrdiff_t>(end),
                        order_.begin() + static_cast<std::ptrdiff_t>(k),
                        order_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            ++end;
            k = end - 1;
        }
        draw_group(scene, order_.data() + first, static_cast<int>(end - first));
        first = end;
    }
}

void EllipsoidPass::draw_group(const ViewScene& scene, const int* members, int n_members) {
    auto& variant = variants_[static_cast<std::size_t>(n_members - 1)];
    if (!variant) variant.emplace(n_members);
    std::array<Eigen::Vector4f, most_members> colours, line_colours, rulings;
    PixelBox box;
    for (int k = 0; k < n_members; ++k) {
        const Ellipsoid& shape = scene.view->ellipsoids[static_cast<std::size_t>(members[k])];
        const auto i = static_cast<std::size_t>(k);
        colours[i] = linear_from_srgb(shape.colour, 1.0);
        line_colours[i] = linear_from_srgb(shape.line_colour, shape.section_px);
        rulings[i] =
            Eigen::Vector4d(shape.ruling_px, shape.ruling_px > 0.0 ? shape.ruling_opacity : 0.0,
                            shape.n_meridians, shape.n_parallels)
                .cast<float>();
        const PixelBox& outline = scene.quadrics[static_cast<std::size_t>(members[k])].outline.box;
        box.add({outline.left, outline.top});
        box.add({outline.right, outline.bottom});
    }
    const PixelPolygon polygon = n_members == 1
                                     ? scene.quadrics[static_cast<std::size_t>(members[0])].outline
                                     : polygon_of(box.within(scene.projection.box));
    variant->program.use();
    glUniform1iv(variant->members, n_members, members);
    glUniform4fv(variant->colours, n_members, colours[0].data());
    glUniform4fv(variant->line_colours, n_members, line_colours[0].data());
    glUniform4fv(variant->rulings, n_members, rulings[0].data());
    glUniform2fv(variant->corners, polygon.n_corners, polygon.corners[0].data());
    glDrawArrays(GL_TRIANGLE_FAN, 0, polygon.n_corners);
}

}  // namespace poinsot
