// What an ellipsoid takes from the light of a plane, as a web of triangles with a darkness at each
// corner. Sky: most where they touch; key light: softly, as from a wide lamp. Both are smooth but
// at the touch, so a web of rings about it, interpolated, serves.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "render/pixel_area.h"
#include "render/quadric.h"
#include "render/tile_mask.h"
#include "shapes/views.h"

namespace poinsot {

struct ShadowWeb {
    static constexpr int n_rings = 12;  // about the hub, each of n_spokes corners; the first is it
    static constexpr int n_spokes = 48;

    std::size_t plane = 0;  // of the view
    // Pixel x and y times the depth (orthographic: times 1), the depth, and the darkness: the
    // share of the plane's light that is taken, its opacity considered. Ring by ring.
    std::vector<Eigen::Vector4f> corners;

    // Marks the tiles that the web may touch.
    void mark(const Projection& projection, TileMask& marks) const;
};

// The web reaches as far as the darkness can be seen; it is empty where there is none.
ShadowWeb shadow_web(const Plane& plane, const Quadric& caster, const Light& light,
                     const Projection& projection);

}  // namespace poinsot
