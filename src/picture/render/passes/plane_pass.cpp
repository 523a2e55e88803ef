#include "render/passes/plane_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/passes/colour.h"

namespace poinsot {
namespace {

constexpr int n_bands = 32;

}  // namespace

BackgroundPass::BackgroundPass()
    : program_("background.vert", "background.frag"),
      projection_(program_.at("projection")),
      box_(program_.at("box")),
      bands_(program_.at("bands")) {}

void BackgroundPass::draw(const Drawing& drawing, const Background& background,
                          const PixelBox& box) const {
    if (background.alpha <= 0.0) return;
    program_.use();
    set_uniform(projection_, projection_of(drawing));
    std::array<glm::vec4, n_bands + 1> bands;
    const auto alpha = static_cast<float>(background.alpha);
    for (int k = 0; k <= n_bands; ++k)
        bands[static_cast<std::size_t>(k)] =
            alpha *
            linear_from_srgb(mixed(background.top, background.bottom, k / double{n_bands}), 1.0);
    set_uniform(bands_, bands);
    set_uniform(box_, glm::vec4(box.left, box.top, box.right, box.bottom));
    // An opaque background needs no blending.
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
    if (map.edge_on || polygon.box.within(box_of(scene.projection)).empty()) return;
    Constants constants;
    constants.add(map.plane_from_pixel.col(0), map.anchor_px.x());
    constants.add(map.plane_from_pixel.col(1), map.anchor_px.y());
    constants.add(map.plane_from_pixel.col(2), 1.0 / shape.grid_spacing);
    constants.add(shape.radius, shape.fade_from, shape.opacity, shape.grid_px);
    constants.add(linear_from_srgb(shape.colour, 1.0));
    constants.add(linear_from_srgb(shape.grid_colour, 1.0));
    program_.draw(polygon, constants, *scene.drawing);
}

ShadowPass::ShadowPass()
    : program_("shadow.vert", "shadow.frag"),
      projection_(program_.at("projection")),
      tint_(program_.at("deepest")),
      vertex_array_(GlVertexArray::make()),
      corners_(GlBuffer::make()),
      indices_(GlBuffer::make()) {
    constexpr int n_rings = ShadowWeb::n_rings, n_spokes = ShadowWeb::n_spokes;
    std::vector<std::uint16_t> indices;
    for (int ring = 0; ring < n_rings; ++ring) {
        for (int spoke = 0; spoke < n_spokes; ++spoke) {
            const int next = (spoke + 1) % n_spokes;
            const auto at = [](int i, int j) {
                return static_cast<std::uint16_t>(i * n_spokes + j);
            };
            // The innermost ring is a single point.
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
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
}

void ShadowPass::prepare(ViewScene& scene) {
    scene.shadows.clear();
    for (std::size_t plane = 0; plane < scene.view->planes.size(); ++plane) {
        for (const Quadric& caster : scene.casters) {
            ShadowWeb web =
                shadow_web(scene.view->planes[plane], caster, scene.view->light, scene.projection);
            if (web.corners.empty()) continue;
            web.plane = plane;
            scene.shadows.push_back(std::move(web));
        }
    }
}

void ShadowPass::draw(const ViewScene& scene, std::size_t plane) const {
    for (const ShadowWeb& web : scene.shadows) {
        if (web.plane != plane) continue;
        program_.use();
        set_uniform(projection_, projection_of(*scene.drawing));
        // A dark shade of the plane's own colour looks calmer than black.
        const glm::vec3 tint = 0.06f * linear_from_srgb(scene.view->planes[plane].grid_colour);
        set_uniform(tint_, glm::vec4(tint, 1.0f));
        glBindVertexArray(vertex_array_.id());
        glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
        glBufferData(GL_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(web.corners.size() * sizeof(glm::vec4)),
                     web.corners.data(), GL_STREAM_DRAW);
        glDrawElements(GL_TRIANGLES, n_indices_, GL_UNSIGNED_SHORT, nullptr);
    }
}

void ShadowPass::mark(const ViewScene& scene, TileMask& marks) const {
    for (const ShadowWeb& web : scene.shadows) web.mark(scene.projection, marks);
}

}  // namespace poinsot
