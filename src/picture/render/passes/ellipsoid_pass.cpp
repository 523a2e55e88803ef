#include "render/passes/ellipsoid_pass.h"

#include <algorithm>
#include <string>

#include "render/passes/colour.h"

namespace poinsot {

EllipsoidPass::Variant::Variant(int n_members, bool rim)
    : program("ellipsoid.frag", 3 + 15 * n_members,
              {"MEMBERS " + std::to_string(n_members), rim ? "RIM 1" : "RIM 0"}, "ellipsoid.vert",
              rim ? 1 : 3),
      sights(program.at("sights")) {}

void EllipsoidPass::Variant::use(const Projection& p) const {
    program.Program::use();
    // The line of sight at pixel 0, and its derivatives in x and y.
    const Eigen::Vector3d sight = p.ray(Eigen::Vector2d::Zero());
    set_uniform(sights, std::array<glm::vec3, 3>{to_glm(sight),
                                                 to_glm(p.ray(Eigen::Vector2d::UnitX()) - sight),
                                                 to_glm(p.ray(Eigen::Vector2d::UnitY()) - sight)});
}

const EllipsoidPass::Variant& EllipsoidPass::variant_of(int n_members) {
    auto& variant = variants_[static_cast<std::size_t>(n_members - 1)];
    if (!variant) variant.emplace(n_members, true);
    return *variant;
}

void EllipsoidPass::draw(const ViewScene& scene) {
    // Farthest first; each group includes all ellipsoids whose outlines overlap.
    order_.clear();
    for (int k = 0; k < scene.n_quadrics(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (scene.quadrics[i].seen && is_present(scene.view->ellipsoids[i])) order_.push_back(k);
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
    const Projection& p = scene.projection;
    Constants constants;
    scene.add_light(constants);
    constants.add(p.near_depth, p.perspective ? 1.0 : 0.0, 1.0 / p.focal, 0.0);
    PixelBox box;
    for (int k = 0; k < n_members; ++k) {
        const auto i = static_cast<std::size_t>(members[k]);
        const Ellipsoid& shape = scene.view->ellipsoids[i];
        const Quadric& q = scene.quadrics[i];
        scene.add_quadric(constants, i);
        constants.add(q.gx, shape.ruling_px);
        constants.add(q.gy, shape.ruling_px > 0.0 ? shape.ruling_opacity : 0.0);
        // The normal is u divided by the half-axes; its factors get the scale of d.
        const double scale = 1.0 / (q.to_u * p.ray(q.anchor_px)).norm();
        constants.add(scale * (q.to_u * scene.view->light.towards.normalized()), shape.n_meridians);
        constants.add(scale * (q.to_u * scene.up()), shape.n_parallels);
        const Eigen::Vector3d half_axes = q.axes.colwise().norm();
        constants.add(scale * scale * half_axes.cwiseAbs2().cwiseInverse(), shape.presence);
        constants.add(linear_from_srgb(shape.colour, shape.opacity));
        constants.add(linear_from_srgb(shape.line_colour, shape.section_px));
        constants.add(linear_from_srgb(shape.contour_colour, shape.contour_px));
        box.add({q.outline.box.left, q.outline.box.top});
        box.add({q.outline.box.right, q.outline.box.bottom});
    }
    const Quadric& first = scene.quadrics[static_cast<std::size_t>(members[0])];
    const Variant& variant = variant_of(n_members);
    variant.use(p);
    if (n_members > 1) {
        variant.program.draw(polygon_of(box.within(box_of(p))), constants, *scene.drawing);
    } else if (first.core.n_corners == 0) {
        variant.program.draw(first.outline, constants, *scene.drawing);
    } else {
        variant.program.draw_ring(first.outline, first.core, constants, *scene.drawing);
        if (!core_) core_.emplace(1, false);
        core_->use(p);
        core_->program.draw(first.core, constants, *scene.drawing);
    }
}

}  // namespace poinsot
