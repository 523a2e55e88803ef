#include "render/view_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace poinsot {
namespace {

using Vec4 = std::array<float, 4>;

// Mirrors of the std140 structures of shaders/view.glsl.
struct QuadricBlock {
    Vec4 d0, dx, dy, m0, mx, my, depth, gx, gy, eye, narrow;
    std::array<Vec4, 3> to_u;
};
struct FlatBlock {
    Vec4 normal, centre, look;
};
struct ViewBlock {
    Vec4 picture, lens, eye, right, down, forward, light, sky;
    std::array<int, 4> counts;
    std::array<QuadricBlock, max_quadrics> quadrics;
    std::array<FlatBlock, max_flats> flats;
};

Vec4 packed(const Eigen::Vector3d& v, double w = 0.0) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(w)};
}

QuadricBlock packed(const Quadric& q, double opacity, bool perspective) {
    constexpr double narrow_below_px = 1.5;
    // Facing grows as the square root of the distance from the limb.
    const double facing_step = std::clamp(std::sqrt(0.2 / std::max(q.narrow_px, 1e-6)), 1e-3, 0.5);
    QuadricBlock block;
    block.d0 = packed(q.d0, q.anchor_px.x());
    block.dx = packed(q.dx, q.anchor_px.y());
    block.dy = packed(q.dy, opacity);
    block.m0 = packed(q.m0, q.narrow_bend);
    block.mx = packed(q.mx, facing_step);
    block.my = packed(q.my);
    block.depth = packed(q.depth_change, q.depth);
    block.gx = packed(q.gx);
    block.gy = packed(q.gy);
    block.eye = packed(q.eye_u, perspective ? 1.0 : 0.0);
    block.narrow = packed({q.narrow.x(), q.narrow.y(), q.narrow_px < narrow_below_px ? 1.0 : 0.0});
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d row = q.to_u.row(k).transpose();
        block.to_u[static_cast<std::size_t>(k)] = packed(row, -row.dot(q.centre));
    }
    return block;
}

FlatBlock packed(const Plane& plane, const Eigen::Vector3d& eye_or_direction, bool perspective) {
    const double offset = -plane.normal.dot(plane.centre);
    const double eye_height = plane.normal.dot(eye_or_direction) + (perspective ? offset : 0.0);
    return {packed(plane.normal, offset), packed(plane.centre, plane.radius),
            packed({plane.opacity, plane.fade_from, eye_height < 0.0 ? -1.0 : 1.0})};
}

Vec4 picture_of(const Drawing& drawing) {
    const auto width = static_cast<float>(drawing.width_px);
    const auto height = static_cast<float>(drawing.height_px);
    return {width, height, 1.0f / width, 1.0f / height};
}

ViewBlock block_of(const Drawing& drawing, const ViewScene& scene) {
    const View& view = *scene.view;
    const Projection& p = scene.projection;
    ViewBlock block{};
    block.picture = picture_of(drawing);
    block.lens =
        packed({p.centre_px.x(), p.centre_px.y(), 1.0 / p.focal_px}, p.perspective ? 1.0 : 0.0);
    block.eye = packed(p.eye, p.near_depth);
    block.right = packed(p.right);
    block.down = packed(p.down);
    block.forward = packed(p.forward);
    block.light = packed(view.light.towards.normalized(), view.light.key);
    // The sky is above the plane that the body stands on, or at the top of the picture.
    const Eigen::Vector3d up =
        view.planes.empty() ? view.camera.up.normalized() : view.planes.front().normal;
    block.sky = packed(up, view.light.sky);
    block.counts = {scene.n_quadrics(), scene.n_flats(), view.meshes.empty() ? 0 : 1, 0};
    for (int k = 0; k < scene.n_quadrics(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        block.quadrics[i] = packed(scene.quadrics[i], view.ellipsoids[i].opacity, p.perspective);
    }
    for (int k = 0; k < scene.n_flats(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        block.flats[i] = packed(view.planes[i], p.perspective ? p.eye : Eigen::Vector3d(-p.forward),
                                p.perspective);
    }
    return block;
}

}  // namespace

Eigen::Vector3d across_of(const Plane& plane) { return plane.normal.cross(plane.along); }

int ViewScene::n_quadrics() const {
    return std::min(max_quadrics, static_cast<int>(quadrics.size()));
}

int ViewScene::n_flats() const { return std::min(max_flats, static_cast<int>(maps.size())); }

void ViewScene::prepare(const View& shown) {
    view = &shown;
    projection = Projection(shown);
    quadrics.clear();
    for (const Ellipsoid& ellipsoid : shown.ellipsoids)
        quadrics.emplace_back(ellipsoid, projection);
    maps.clear();
    before_solids.clear();
    for (const Plane& plane : shown.planes) {
        maps.push_back(map_of(projection, plane.centre, plane.along, across_of(plane)));
        // A plane is drawn over the ellipsoids if most of them lie on its far side.
        const double eye_side = projection.perspective
                                    ? plane.normal.dot(projection.eye - plane.centre)
                                    : -plane.normal.dot(projection.forward);
        double far_side = 0.0;
        for (const Ellipsoid& ellipsoid : shown.ellipsoids)
            far_side += plane.normal.dot(ellipsoid.centre - plane.centre) * eye_side < 0.0 ? 1 : -1;
        before_solids.push_back(far_side > 0.0);
    }
}

ViewBlocks::ViewBlocks() : buffer_(GlBuffer::make()) {
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    stride_ = (sizeof(ViewBlock) + step - 1) / step * step;
}

void ViewBlocks::upload(const Drawing& drawing, const std::vector<ViewScene>& scenes) {
    // A picture without views still has a size.
    bytes_.assign(stride_ * std::max<std::size_t>(1, scenes.size()), 0);
    const Vec4 picture = picture_of(drawing);
    std::memcpy(bytes_.data(), &picture, sizeof picture);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
        const ViewBlock block = block_of(drawing, scenes[k]);
        std::memcpy(bytes_.data() + k * stride_, &block, sizeof block);
    }
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes_.size()), bytes_.data(),
                 GL_STREAM_DRAW);
}

void ViewBlocks::bind(std::size_t view) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, 0, buffer_.id(), static_cast<GLintptr>(view * stride_),
                      static_cast<GLsizeiptr>(sizeof(ViewBlock)));
}

}  // namespace poinsot
