// An ellipsoid for intersections with lines of sight.
#pragma once

#include <Eigen/Core>

#include "render/pixel_area.h"
#include "shapes/unit_sphere.h"
#include "shapes/views.h"

namespace poinsot {

// In axes u where the ellipsoid is the unit sphere about the origin, the line of sight of a pixel
// has direction d and moment m = o × d (Plücker coordinates), both affine in the pixel. It meets
// the sphere where |d|² - |m|² ≥ 0, at u = (d × m ∓ d √(|d|² - |m|²)) / |d|². Unlike a quadratic
// equation for the distance from the eye, this loses no digits for flat, thin or distant
// ellipsoids.
struct Quadric : UnitSphere {
    Eigen::Vector2d anchor_px;
    Eigen::Vector3d d0, dx, dy, m0, mx, my;  // all with the same scale
    Eigen::Vector3d gx, gy;                  // to_u·right/focal and to_u·down/focal
    Eigen::Vector3d depth_change;            // gradient of depth with respect to u
    double depth = 0.0;                      // of the centre
    Eigen::Vector3d eye_u;                   // the eye, or the direction towards it if orthographic
    Eigen::Vector2d narrow =
        Eigen::Vector2d::UnitX();  // direction in which the outline is narrowest
    double narrow_bend = -1.0;     // second derivative of |d|² - |m|² along it
    double presence = 1.0;         // of the ellipsoid
    double hiding = 1.0;           // opacity for objects behind it, including its presence
    double hiding_far = 1.0;       // the same for the far parts of curves on it
    double narrow_px = 1e9;        // smallest half-width of the outline
    double wide_px = 1e9;          // largest half-width
    bool seen = true;
    PixelPolygon outline;  // contains the ellipsoid's image; the whole view if it surrounds the eye
    PixelPolygon core;     // pixels entirely inside; corners correspond to those of `outline`; may
                           // be empty

    Quadric(const Ellipsoid& ellipsoid, const Projection& projection);

    // Row k of u = to_u·(X - centre): the vector, and the offset added to its product with X.
    Eigen::Vector3d to_u_row(int k) const { return to_u.row(k).transpose(); }
    double to_u_offset(int k) const { return -to_u.row(k).dot(centre); }
    // The cosine of the angle between normal and line of sight a tenth of a pixel inside the limb.
    double limb_cosine() const;
};

inline bool is_present(const Ellipsoid& ellipsoid) {
    return ellipsoid.opacity > 0.0 && ellipsoid.presence > 0.0;
}

}  // namespace poinsot
