#include "render/plane_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/colour.h"

namespace poinsot {
namespace {

constexpr int n_bands = 32;

// As in shaders/shadow.vert.
constexpr int n_rings = 16;
constexpr int n_spokes = 48;

// The part of a plane that an ellipsoid shades: a web about the hub, out to a circle.
struct Shadow {
    Eigen::Vector3d hub;      // the point of the plane nearest to the ellipsoid
    Eigen::Vector3d centre;   // of the circle
    Eigen::Vector3d towards;  // the middle of the lamp, unit
    double side;              // of the plane on which the ellipsoid stands
    double radius;
};

Shadow shadow_of(const Plane& plane, const Quadric& caster, const Light& light) {
    Shadow shadow;
    const double height = plane.normal.dot(caster.centre - plane.centre);
    shadow.side = height < 0.0 ? -1.0 : 1.0;
    const Eigen::Vector3d up = shadow.side * plane.normal;
    const Eigen::Vector3d lean = caster.axes.transpose() * up;
    const Eigen::Vector3d lowest =
        caster.centre - caster.axes * lean / std::max(lean.norm(), 1e-12);
    const auto foot = [&](const Eigen::Vector3d& x) {
        return (x - plane.normal.dot(x - plane.centre) * plane.normal).eval();
    };
    shadow.hub = foot(lowest);
    // The lamp stands higher than the key light: a shadow near the touch is calmer than a long one.
    constexpr double raised = 0.8;
    const Eigen::Vector3d key = light.towards.normalized();
    shadow.towards = (key + (raised + std::max(0.0, -key.dot(up))) * up).normalized();
    const Eigen::Vector3d lee =
        foot(caster.centre -
             shadow.towards * (std::abs(height) / std::max(shadow.towards.dot(up), 0.3)));
    // Beyond two of its radii a sphere on the plane takes no more than a level.
    shadow.centre = 0.5 * (foot(caster.centre) + lee);
    shadow.radius = std::max(2.0 * caster.axes.colwise().norm().maxCoeff(),
                             1.2 * (shadow.centre - shadow.hub).norm());
    return shadow;
}

}  // namespace

BackgroundPass::BackgroundPass()
    : program_("background.vert", "background.frag"),
      picture_(program_.at("picture")),
      box_(program_.at("box")),
      bands_(program_.at("bands")) {}

void BackgroundPass::draw(const Drawing& drawing, const Background& background,
                          const PixelBox& box) const {
    if (background.alpha <= 0.0) return;
    program_.use();
    set_picture(picture_, drawing);
    std::array<Eigen::Vector4f, n_bands + 1> bands;
    const auto alpha = static_cast<float>(background.alpha);
    for (int k = 0; k <= n_bands; ++k)
        bands[static_cast<std::size_t>(k)] =
            alpha *
            linear_from_srgb(mixed(background.top, background.bottom, k / double{n_bands}), 1.0);
    glUniform4fv(bands_, n_bands + 1, bands[0].data());
    glUniform4f(box_, static_cast<float>(box.left), static_cast<float>(box.top),
                static_cast<float>(box.right), static_cast<float>(box.bottom));
    // What covers in full need not be mixed.
    if (background.alpha >= 1.0) glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (n_bands + 1));
    glEnable(GL_BLEND);
}

PixelPolygon disc_polygon(const ViewScene& scene, std::size_t plane) {
    const Plane& shape = scene.view->planes[plane];
    return disc_polygon(scene.projection, shape.centre, shape.along, across_of(shape),
                        shape.radius);
}

PlanePass::PlanePass() : program_("plane.frag", 6) {}

void PlanePass::draw(const ViewScene& scene, std::size_t plane) const {
    const Plane& shape = scene.view->planes[plane];
    const PlaneMap& map = scene.maps[plane];
    const PixelPolygon polygon = disc_polygon(scene, plane);
    if (map.edge_on || polygon.box.within(scene.projection.box).empty()) return;
    Constants constants;
    constants.add(map.plane_from_pixel.col(0), map.anchor_px.x());
    constants.add(map.plane_from_pixel.col(1), map.anchor_px.y());
    constants.add(map.plane_from_pixel.col(2), 1.0 / shape.grid_spacing);
    constants.add(shape.radius, shape.fade_from, shape.opacity, shape.grid_px);
    constants.add4(linear_from_srgb(shape.colour, 1.0));
    constants.add4(linear_from_srgb(shape.grid_colour, 1.0));
    program_.draw(polygon, constants, *scene.drawing);
}

ShadowPass::ShadowPass()
    : program_("shadow.vert", "shadow.frag"),
      picture_(program_.at("picture")),
      constants_(program_.at("constants")),
      to_u_(program_.at("to_u")),
      tint_(program_.at("deepest")),
      vertex_array_(GlVertexArray::make()),
      indices_(GlBuffer::make()) {
    std::vector<std::uint16_t> indices;
    for (int ring = 0; ring < n_rings; ++ring) {
        for (int spoke = 0; spoke < n_spokes; ++spoke) {
            const int next = (spoke + 1) % n_spokes;
            const auto at = [](int i, int j) {
                return static_cast<std::uint16_t>(i * n_spokes + j);
            };
            // The innermost ring is a point.
            if (ring > 0)
                indices.insert(indices.end(),
                               {at(ring, spoke), at(ring, next), at(ring + 1, next)});
            indices.insert(indices.end(),
                           {at(ring, spoke), at(ring + 1, next), at(ring + 1, spoke)});
        }
    }
    n_indices_ = static_cast<GLsizei>(indices.size());
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)), indices.data(),
                 GL_STATIC_DRAW);
}

void ShadowPass::draw(const ViewScene& scene, std::size_t plane) const {
    const Plane& shape = scene.view->planes[plane];
    for (const Quadric& q : scene.casters) {
        const Shadow shadow = shadow_of(shape, q, scene.view->light);
        Constants constants;
        scene.add_view(constants);
        scene.add_light(constants);
        constants.add(shadow.hub, shadow.radius);
        constants.add(shape.along);
        constants.add(across_of(shape));
        constants.add(shape.centre, shape.radius);
        constants.add(shape.opacity, shape.fade_from, 0.0, 0.0);
        constants.add((shadow.side * q.axes.transpose() * shape.normal).normalized());
        constants.add((q.to_u * shadow.towards).normalized());
        const Eigen::Vector3d off = shadow.centre - shadow.hub;
        constants.add(shape.along.dot(off), across_of(shape).dot(off), 0.0, 0.0);
        Constants to_u;
        for (int row = 0; row < 3; ++row) to_u.add(q.to_u_row(row), q.to_u_offset(row));
        program_.use();
        set_picture(picture_, *scene.drawing);
        glUniform4fv(constants_, constants.size(), constants.from(0));
        glUniform4fv(to_u_, to_u.size(), to_u.from(0));
        // A deep shade of the plane's own colour is calmer than black.
        const Eigen::Vector4f tint = linear_from_srgb(shape.grid_colour, 1.0);
        glUniform4f(tint_, 0.06f * tint[0], 0.06f * tint[1], 0.06f * tint[2], 1.0f);
        glBindVertexArray(vertex_array_.id());
        glDrawElements(GL_TRIANGLES, n_indices_, GL_UNSIGNED_SHORT, nullptr);
    }
}

void ShadowPass::mark(const ViewScene& scene, std::size_t plane, TileMask& marks) const {
    const Plane& shape = scene.view->planes[plane];
    for (const Quadric& q : scene.casters) {
        const Shadow shadow = shadow_of(shape, q, scene.view->light);
        marks.mark(disc_polygon(scene.projection, shadow.centre, shape.along, across_of(shape),
                                shadow.radius),
                   scene.projection.box);
    }
}

}  // namespace poinsot
