// What the solids of a view hide, and where along a curve that changes.
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

// Nothing between a point and the eye leaves it clear; each thing takes its share, as in
// shaders/occlusion.glsl.
struct Cover {
    double clear = 1.0;        // share in which it is seen
    double transmitted = 1.0;  // share of light that what hides it lets through
    bool operator==(const Cover&) const = default;
};

// An ellipsoid as lines of sight meet it.
struct SphereSight : UnitSphere {
    SphereSight(const Ellipsoid& ellipsoid, const Projection& projection);

    Eigen::Vector3d u(const Eigen::Vector3d& point) const { return to_u * (point - centre); }
    // Above 0 outside the surface.
    double outside(const Eigen::Vector3d& u) const { return u.squaredNorm() - 1.0; }
    // Above 0 where the line of sight meets the surface.
    double within_outline(const Eigen::Vector3d& u) const;
    // Above 0 on the eye's side of the plane through the outline's circle of touch (the pole of
    // which is the eye).
    double before_limb(const Eigen::Vector3d& u) const;
    bool hides(const Eigen::Vector3d& u) const;

    Eigen::Vector3d eye_u;    // the eye, or the unit direction towards it
    bool perspective = true;  // whether it is the eye
    bool surrounds_eye = false;
    double hiding = 1.0;  // how opaque it is to what it hides
};

// A curve to be seen: its place by a parameter, and knots (ascending) between which it is smooth.
struct Track {
    std::function<CurveFlow(double)> flow;
    std::vector<double> knots;
};

// Of which solids of the view something is a part, by number; −1: none.
struct Membership {
    int ellipsoid = -1, plane = -1;
    std::vector<bool> lies_on{};  // by ellipsoid: what lies on others, too, where they meet

    bool is_on(std::size_t sphere) const {
        return ellipsoid == static_cast<int>(sphere) ||
               (sphere < lies_on.size() && lies_on[sphere]);
    }
};

// A part of a track that is covered evenly: [from, to].
struct Span {
    double from = 0.0, to = 0.0;
    Cover cover;
};

class Occluders {
 public:
    Occluders(const View& view, const Projection& projection);

    Cover at(const Eigen::Vector3d& point, const Membership& of) const;
    // The whole track in spans before the eye, each as long as its cover stays. Where it changes is
    // solved for: roots of the conditions above, and of those of planes and meshes.
    std::vector<Span> spans(const Track& track, const Membership& of) const;

    std::span<const SphereSight> spheres() const { return spheres_; }
    std::span<const MeshSight> meshes() const { return meshes_; }

 private:
    using Condition = std::function<double(const Eigen::Vector3d&)>;
    std::vector<Condition> conditions(const Membership& of) const;
    // Places of a track with others between, so that neighbours are a quarter of a point apart on
    // paper, half the width of the thinnest line: what hides by its triangles may do so however
    // often.
    std::vector<double> closer(const Track& track, std::span<const double> places) const;
    // On which ellipsoids all places of a track lie, within what its form is off.
    std::vector<bool> lies_on(const Track& track, std::span<const double> places) const;

    const View& view_;
    const Projection& projection_;
    std::vector<SphereSight> spheres_;
    std::vector<MeshSight> meshes_;
};

}  // namespace poinsot::vector
