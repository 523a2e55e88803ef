#include "render/view_scene.h"

#include <algorithm>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "render/to_glm.h"

namespace poinsot {

Eigen::Vector3d across_of(const Plane& plane) { return plane.normal.cross(plane.along); }

glm::dmat4 MeshLayer::projection(const Projection& of_view, const glm::dvec2& shift_px) const {
    // The sides of the layer at depth 1.
    const glm::dvec2 corner_px = glm::dvec2(left, top) + shift_px;
    const glm::dvec2 first = (corner_px - to_glm(of_view.centre)) / of_view.focal;
    const glm::dvec2 last = first + glm::dvec2(width, height) / of_view.focal;
    if (!of_view.perspective)
        return glm::ortho(first.x, last.x, -first.y, -last.y, nearest, farthest);
    return glm::frustum(nearest * first.x, nearest * last.x, -nearest * first.y, -nearest * last.y,
                        nearest, farthest);
}

glm::dmat4 ViewScene::camera_from_view() const {
    const glm::dvec3 eye = to_glm(projection.eye);
    return glm::lookAt(eye, eye + to_glm(projection.forward), -to_glm(projection.down));
}

int ViewScene::n_quadrics() const {
    return std::min(max_quadrics, static_cast<int>(quadrics.size()));
}

Solids ViewScene::solids() const {
    return {n_quadrics(), std::min(max_flats, static_cast<int>(maps.size())),
            mesh_layer.width > 0 ? 1 : 0};
}

std::vector<std::string> Solids::defines() const {
    return {"N_QUADRICS " + std::to_string(n_quadrics), "N_FLATS " + std::to_string(n_flats),
            "N_MESHES " + std::to_string(n_meshes)};
}

void ViewScene::prepare(const Drawing& whole, const View& shown) {
    drawing = &whole;
    view = &shown;
    projection = Projection(shown);
    mesh_layer = MeshLayer{};
    quadrics.clear();
    for (const Ellipsoid& ellipsoid : shown.ellipsoids)
        quadrics.emplace_back(ellipsoid, projection);
    casters.clear();
    for (std::size_t k = 0; k < quadrics.size(); ++k)
        if (shown.ellipsoids[k].casts_shadow && is_present(shown.ellipsoids[k]))
            casters.push_back(quadrics[k]);
    maps.clear();
    before_solids.clear();
    for (const Plane& plane : shown.planes) {
        maps.push_back(map_of(projection, plane.centre, plane.along, across_of(plane)));
        // A plane is drawn over the ellipsoids if most of them are on its far side.
        const double eye_side = projection.perspective
                                    ? plane.normal.dot(projection.eye - plane.centre)
                                    : -plane.normal.dot(projection.forward);
        double far_side = 0.0;
        for (const Ellipsoid& ellipsoid : shown.ellipsoids)
            far_side += plane.normal.dot(ellipsoid.centre - plane.centre) * eye_side < 0.0 ? 1 : -1;
        before_solids.push_back(far_side > 0.0);
    }
}

void ViewScene::add_view(Constants& constants) const {
    const Projection& p = projection;
    constants.add(p.centre.x(), p.centre.y(), 1.0 / p.focal, p.perspective ? 1.0 : 0.0);
    constants.add(p.eye, p.near_depth);
    constants.add(p.right);
    constants.add(p.down);
    constants.add(p.forward);
}

Eigen::Vector3d ViewScene::up() const {
    return view->planes.empty() ? view->camera.up.normalized() : view->planes.front().normal;
}

void ViewScene::add_light(Constants& constants) const {
    constants.add(view->light.towards.normalized(), view->light.key);
    constants.add(up(), view->light.sky);
}

void ViewScene::add_quadric(Constants& constants, std::size_t ellipsoid) const {
    const Quadric& q = quadrics[ellipsoid];
    // Both edges of such a narrow outline may lie in the same pixel.
    constexpr double narrow_below_px = 1.5;
    const bool narrow = q.narrow_px < narrow_below_px;
    constants.add(q.d0, q.anchor_px.x());
    constants.add(q.dx, q.anchor_px.y());
    constants.add(q.dy, q.hiding);
    constants.add(q.m0, q.narrow.x());
    constants.add(q.mx, q.narrow.y());
    constants.add(q.my, narrow ? q.narrow_bend : 0.0);
    constants.add(q.depth_change, q.depth);
}

void ViewScene::add_solids(Constants& constants) const {
    for (int k = 0; k < n_quadrics(); ++k) add_quadric(constants, static_cast<std::size_t>(k));
    for (int k = 0; k < solids().n_flats; ++k) {
        const Plane& plane = view->planes[static_cast<std::size_t>(k)];
        const double offset = -plane.normal.dot(plane.centre);
        const double eye_height = projection.perspective ? plane.normal.dot(projection.eye) + offset
                                                         : -plane.normal.dot(projection.forward);
        constants.add(plane.normal, offset);
        constants.add(plane.centre, plane.radius);
        constants.add(plane.opacity, plane.fade_from, eye_height < 0.0 ? -1.0 : 1.0, 0.0);
    }
    if (mesh_layer.width > 0) {
        constants.add(mesh_layer.left, mesh_layer.top, mesh_layer.width, mesh_layer.height);
        // The layer's depth buffer holds offset + slope/depth, orthographic: offset + slope·depth.
        const glm::dmat4 clip = mesh_layer.projection(projection);
        const double constant = projection.perspective ? -clip[2][2] : clip[3][2];
        const double factor = projection.perspective ? clip[3][2] : -clip[2][2];
        constants.add(0.5 + 0.5 * constant, 0.5 * factor, mesh_layer.opacity, 0.0);
    }
}

}  // namespace poinsot
