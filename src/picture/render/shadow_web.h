// The soft shadow of an ellipsoid on a plane, as triangles with a darkness at each corner. The sky
// light is darkest where they touch, and the key light is that of a wide lamp. Both are smooth
// except at the point of contact, so interpolation between rings around that point is accurate.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "render/pixel_area.h"
#include "render/quadric.h"
#include "render/tile_mask.h"
#include "shapes/views.h"

namespace poinsot {

struct ShadowWeb {
    static constexpr int n_rings = 16;  // around the hub, each with n_spokes corners; the first
                                        // ring is the hub
    static constexpr int n_spokes = 48;

    std::size_t plane = 0;  // of the view
    // Pixel x and y times the depth (orthographic: times 1), the depth, and the darkness: the
    // blocked share of the plane's light, including the plane's opacity. Ring by ring.
    std::vector<glm::vec4> corners;

    // Marks the tiles that the web may touch.
    void mark(const Projection& projection, TileMask& marks) const;
};

// The web covers the visible part of the shadow; it is empty if there is none.
ShadowWeb shadow_web(const Plane& plane, const Quadric& caster, const Light& light,
                     const Projection& projection);

}  // namespace poinsot
