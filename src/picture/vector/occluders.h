// Visibility of points and curves behind the solids of a view, and the places where it changes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <span>
#include <vector>

#include "shapes/unit_sphere.h"
#include "vector/mesh_sight.h"
#include "vector/paper_flow.h"

namespace poinsot::vector {

// The visibility of a point: each object between the point and the eye reduces it, as in
// shaders/occlusion.glsl.
struct Cover {
    double clear = 1.0;        // visible share
    double transmitted = 1.0;  // share of light that the hiding objects transmit
    // The same shares with bodies alone, and with planes alone, whose two shares are equal.
    double before_bodies = 1.0, through_bodies = 1.0, through_planes = 1.0;
    bool operator==(const Cover&) const = default;
};

// The visible share of what only planes cover, where hidden objects are dashed or omitted: planes
// are glass, which dims what is behind it to three quarters at most.
double seen_through_planes(const Cover& cover);

// An ellipsoid for intersections with lines of sight.
struct SphereSight : UnitSphere {
    SphereSight(const Ellipsoid& ellipsoid, const Projection& projection);

    Eigen::Vector3d u(const Eigen::Vector3d& point) const { return to_u * (point - centre); }
    // Positive outside the surface.
    double outside(const Eigen::Vector3d& u) const { return u.squaredNorm() - 1.0; }
    // Positive where the line of sight meets the surface.
    double within_outline(const Eigen::Vector3d& u) const;
    // Positive on the eye's side of the plane through the circle of tangency (the polar plane of
    // the eye).
    double before_limb(const Eigen::Vector3d& u) const;
    bool hides(const Eigen::Vector3d& u) const;

    Eigen::Vector3d eye_u;    // the eye, or the unit direction towards it
    bool perspective = true;  // whether eye_u is the eye
    bool surrounds_eye = false;
    double hiding = 1.0;      // the opacity for objects behind it
    double hiding_far = 1.0;  // the same for the far parts of curves on it
};

// A curve whose visibility is computed: position by parameter, and knots (ascending) between which
// it is smooth.
struct Track {
    std::function<CurveFlow(double)> flow;
    std::vector<double> knots;
};

// The solids of the view that an object is part of, by number; −1: none.
struct Membership {
    int ellipsoid = -1, plane = -1;
    std::vector<bool> lies_on{};  // by ellipsoid: other ellipsoids on which the object lies, where
                                  // two meet

    bool is_on(std::size_t sphere) const {
        return ellipsoid == static_cast<int>(sphere) ||
               (sphere < lies_on.size() && lies_on[sphere]);
    }
};

// A part [from, to] of a track with constant cover.
struct Span {
    double from = 0.0, to = 0.0;
    Cover cover;
};

class Occluders {
 public:
    Occluders(const View& view, const Projection& projection);

    Cover at(const Eigen::Vector3d& point, const Membership& of) const;
    // Divides the track in front of the eye into spans of constant cover. The ends of the spans are
    // computed as roots of the conditions above, and of those for planes and meshes.
    std::vector<Span> spans(const Track& track, const Membership& of) const;

    std::span<const SphereSight> spheres() const { return spheres_; }
    std::span<const MeshSight> meshes() const { return meshes_; }

 private:
    using Condition = std::function<double(const Eigen::Vector3d&)>;
    std::vector<Condition> conditions(const Membership& of) const;
    // Adds parameters so that neighbours are at most a quarter of a point apart on paper, half the
    // width of the thinnest line: meshes may change the visibility at any place.
    std::vector<double> closer(const Track& track, std::span<const double> places) const;
    // The ellipsoids on which all sampled points of a track lie, within the deviation of its form.
    std::vector<bool> lies_on(const Track& track, std::span<const double> places) const;

    const View& view_;
    const Projection& projection_;
    std::vector<SphereSight> spheres_;
    std::vector<MeshSight> meshes_;
};

}  // namespace poinsot::vector
