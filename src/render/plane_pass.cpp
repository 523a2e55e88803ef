#include "render/plane_pass.h"

#include <array>

#include "render/colour.h"

namespace poinsot {
namespace {

constexpr int n_bands = 32;

void set_map(GLint location, const Eigen::Matrix3d& map) {
    const Eigen::Matrix3f values = map.cast<float>();
    glUniformMatrix3fv(location, 1, GL_FALSE, values.data());
}

void set_anchor(GLint location, const PlaneMap& map) {
    glUniform2f(location, static_cast<float>(map.anchor_px.x()),
                static_cast<float>(map.anchor_px.y()));
}

void set_disc(GLint location, const Plane& plane) {
    glUniform4f(location, static_cast<float>(plane.radius), static_cast<float>(plane.fade_from),
                static_cast<float>(plane.opacity), static_cast<float>(plane.grid_px));
}

void draw_polygon(GLint corners, const PixelPolygon& polygon) {
    glUniform2fv(corners, polygon.n_corners, polygon.corners[0].data());
    glDrawArrays(GL_TRIANGLE_FAN, 0, polygon.n_corners);
}

// How far from the plane's disc the ellipsoid's shadow reaches, as a ball about its foot.
double shadow_reach(const Ellipsoid& ellipsoid) {
    constexpr double radii = 5.0;
    return radii * ellipsoid.half_axes.colwise().norm().maxCoeff();
}

}  // namespace

BackgroundPass::BackgroundPass()
    : program_("background.vert", "background.frag"),
      box_(program_.at("box")),
      bands_(program_.at("bands")),
      alpha_(program_.at("alpha")) {}

void BackgroundPass::draw(const Background& background, const PixelBox& box) const {
    if (background.alpha <= 0.0) return;
    program_.use();
    std::array<Eigen::Vector3f, n_bands + 1> bands;
    for (int k = 0; k <= n_bands; ++k)
        bands[static_cast<std::size_t>(k)] =
            linear_from_srgb(mixed(background.top, background.bottom, k / double{n_bands}));
    glUniform3fv(bands_, n_bands + 1, bands[0].data());
    glUniform4f(box_, static_cast<float>(box.left), static_cast<float>(box.top),
                static_cast<float>(box.right), static_cast<float>(box.bottom));
    glUniform1f(alpha_, static_cast<float>(background.alpha));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (n_bands + 1));
}

PixelBox disc_box(const ViewScene& scene, std::size_t plane) {
    const Plane& shape = scene.view->planes[plane];
    return scene.projection.ball_box(shape.centre, shape.radius).within(scene.projection.box);
}

PixelBox shadow_box(const ViewScene& scene, std::size_t plane) {
    const Plane& shape = scene.view->planes[plane];
    PixelBox box;
    for (const Ellipsoid& caster : scene.view->ellipsoids) {
        if (!caster.casts_shadow) continue;
        const double height = shape.normal.dot(caster.centre - shape.centre);
        const PixelBox ball =
            scene.projection.ball_box(caster.centre - height * shape.normal, shadow_reach(caster));
        if (ball.empty()) continue;
        box.add({ball.left, ball.top});
        box.add({ball.right, ball.bottom});
    }
    return box.within(disc_box(scene, plane));
}

PlanePass::PlanePass()
    : program_("polygon.vert", "plane.frag"),
      corners_(program_.at("corners")),
      map_(program_.at("plane_from_pixel")),
      anchor_(program_.at("anchor")),
      disc_(program_.at("disc")),
      colour_(program_.at("colour")),
      grid_colour_(program_.at("grid_colour")) {}

void PlanePass::draw(const ViewScene& scene, std::size_t plane) const {
    const Plane& shape = scene.view->planes[plane];
    const PlaneMap& map = scene.maps[plane];
    const PixelBox box = disc_box(scene, plane);
    if (map.edge_on || box.empty()) return;
    program_.use();
    set_map(map_, map.plane_from_pixel);
    set_anchor(anchor_, map);
    set_disc(disc_, shape);
    const Eigen::Vector3f colour = linear_from_srgb(shape.colour);
    const Eigen::Vector3f grid = linear_from_srgb(shape.grid_colour);
    glUniform4f(colour_, colour.x(), colour.y(), colour.z(),
                static_cast<float>(1.0 / shape.grid_spacing));
    glUniform3fv(grid_colour_, 1, grid.data());
    draw_polygon(corners_, polygon_of(box));
}

ShadowPass::ShadowPass()
    : program_("polygon.vert", "shadow.frag"),
      corners_(program_.at("corners")),
      map_(program_.at("plane_from_pixel")),
      anchor_(program_.at("anchor")),
      disc_(program_.at("disc")),
      tint_(program_.at("tint")),
      n_casters_(program_.at("n_casters")),
      sphere_map_(program_.at("sphere_from_pixel")),
      normal_(program_.at("normal_u")),
      light_(program_.at("light_u")) {}

void ShadowPass::draw(const ViewScene& scene, std::size_t plane) const {
    const Plane& shape = scene.view->planes[plane];
    const PlaneMap& map = scene.maps[plane];
    const PixelBox box = shadow_box(scene, plane);
    if (map.edge_on || box.empty()) return;

    std::array<Eigen::Matrix3f, max_quadrics> sphere_maps;
    std::array<Eigen::Vector3f, max_quadrics> normals, lights;
    std::size_t n_casters = 0;
    for (std::size_t k = 0; k < scene.quadrics.size() && n_casters < max_quadrics; ++k) {
        if (!scene.view->ellipsoids[k].casts_shadow) continue;
        const Quadric& q = scene.quadrics[k];
        // The side of the plane on which the ellipsoid stands is the lit one.
        const double side = shape.normal.dot(q.centre - shape.centre) < 0.0 ? -1.0 : 1.0;
        Eigen::Matrix3d sphere_from_plane;
        sphere_from_plane << q.to_u * shape.along, q.to_u * across_of(shape),
            q.to_u * (shape.centre - q.centre);
        sphere_maps[n_casters] = (sphere_from_plane * map.plane_from_pixel).cast<float>();
        normals[n_casters] = (side * q.axes.transpose() * shape.normal).normalized().cast<float>();
        lights[n_casters] = (q.to_u * scene.view->light.towards).normalized().cast<float>();
        ++n_casters;
    }
    if (n_casters == 0) return;

    program_.use();
    set_map(map_, map.plane_from_pixel);
    set_anchor(anchor_, map);
    set_disc(disc_, shape);
    // A deep shade of the plane's own colour is calmer than black.
    const Eigen::Vector3f tint = 0.06f * linear_from_srgb(shape.grid_colour);
    glUniform3fv(tint_, 1, tint.data());
    const auto n = static_cast<GLsizei>(n_casters);
    glUniform1i(n_casters_, n);
    glUniformMatrix3fv(sphere_map_, n, GL_FALSE, sphere_maps[0].data());
    glUniform3fv(normal_, n, normals[0].data());
    glUniform3fv(light_, n, lights[0].data());
    draw_polygon(corners_, polygon_of(box));
}

}  // namespace poinsot
