#include "vector/occluders.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "numerics/bracketed_root.h"
#include "shapes/soft_shadow.h"

namespace poinsot::vector {

namespace {

// A fading plane is drawn in this number of opacity levels.
constexpr int n_plane_levels = 8;

// The distance from the plane's centre at which the line of sight of a point crosses the plane.
double crossing_distance(const Projection& projection, const Plane& plane,
                         const Eigen::Vector3d& point) {
    const Eigen::Vector3d towards = projection.towards_eye(point);
    const double rise = plane.normal.dot(towards);
    const double height = plane.normal.dot(point - plane.centre);
    if (std::abs(rise) < 1e-12 * towards.norm()) return 1e12;
    return (point - (height / rise) * towards - plane.centre).norm();
}

// The distance of a point in front of a plane, towards the eye.
double before_plane(const Projection& projection, const Plane& plane,
                    const Eigen::Vector3d& point) {
    const double eye_side = projection.perspective ? plane.normal.dot(projection.eye - plane.centre)
                                                   : -plane.normal.dot(projection.forward);
    const double height = plane.normal.dot(point - plane.centre);
    return eye_side < 0.0 ? -height : height;
}

double level(double opacity) { return std::round(opacity * n_plane_levels) / n_plane_levels; }

// Finds the roots of a function in an interval, including places where it touches zero.
class RootFinder {
 public:
    RootFinder(const std::function<double(double)>& function, std::vector<double>& roots)
        : function_(function), roots_(roots) {}

    // Searches between ascending parameters that are dense enough to resolve sign changes.
    void search(std::span<const double> at) {
        std::vector<double> value;
        for (const double s : at) value.push_back(function_(s));
        for (std::size_t k = 1; k < at.size(); ++k) {
            if ((value[k - 1] < 0.0) != (value[k] < 0.0))
                root(at[k - 1], at[k]);
            else if (k + 1 < at.size() && nears_zero(value[k - 1], value[k], value[k + 1]))
                search_pair(at[k - 1], at[k + 1], value[k] < 0.0);
        }
        // Two roots may lie close to either end.
        if (at.size() < 2) return;
        const std::size_t last = at.size() - 1;
        if (is_same_side(value[0], value[1]) && std::abs(value[0]) < std::abs(value[1]))
            search_pair(at[0], at[1], value[0] < 0.0);
        if (is_same_side(value[last - 1], value[last]) &&
            std::abs(value[last]) < std::abs(value[last - 1]))
            search_pair(at[last - 1], at[last], value[last] < 0.0);
    }

 private:
    static bool is_same_side(double a, double b) { return (a < 0.0) == (b < 0.0) && a != b; }
    static bool nears_zero(double before, double here, double after) {
        return (before < 0.0) == (here < 0.0) && (here < 0.0) == (after < 0.0) &&
               std::abs(here) <= std::abs(before) && std::abs(here) <= std::abs(after) &&
               !(here == before && here == after);
    }
    void root(double low, double high) { roots_.push_back(bracketed_root(function_, low, high)); }

    // Golden section search for the point nearest to zero, and the roots on both sides if the
    // function crosses zero there.
    void search_pair(double low, double high, bool below) {
        const double sign = below ? -1.0 : 1.0;
        double a = low, b = high;
        constexpr double golden = 0.38196601125010515;
        double c = a + golden * (b - a), d = b - golden * (b - a);
        double at_c = sign * function_(c), at_d = sign * function_(d);
        for (int k = 0; k < 48; ++k) {
            if (at_c < at_d) {
                b = d, d = c, at_d = at_c;
                c = a + golden * (b - a);
                at_c = sign * function_(c);
            } else {
                a = c, c = d, at_c = at_d;
                d = b - golden * (b - a);
                at_d = sign * function_(d);
            }
            if (std::min(at_c, at_d) < 0.0) {
                const double crossed = at_c < at_d ? c : d;
                if (sign * function_(low) > 0.0) root(low, crossed);
                if (sign * function_(high) > 0.0) root(crossed, high);
                return;
            }
        }
    }

    const std::function<double(double)>& function_;
    std::vector<double>& roots_;
};

}  // namespace

double seen_through_planes(const Cover& cover) {
    constexpr double least = 0.75;  // distinguishable from what lies above the plane
    return cover.through_planes +
           (1.0 - cover.through_planes) * std::max(least, cover.through_planes);
}

SphereSight::SphereSight(const Ellipsoid& ellipsoid, const Projection& projection)
    : UnitSphere(ellipsoid),
      perspective(projection.perspective),
      hiding(ellipsoid.opacity * ellipsoid.presence),
      hiding_far(ellipsoid.hides_far_curves ? ellipsoid.presence : hiding) {
    eye_u = perspective ? u(projection.eye) : (to_u * -projection.forward).normalized();
    surrounds_eye = perspective && eye_u.norm() <= 1.0;
}

double SphereSight::within_outline(const Eigen::Vector3d& u) const {
    // |d|² − |m|² of the line of sight with moment m and direction d, for a unit direction.
    if (!perspective) return 1.0 - u.cross(eye_u).squaredNorm();
    const Eigen::Vector3d d = u - eye_u;
    return 1.0 - u.cross(eye_u).squaredNorm() / std::max(d.squaredNorm(), 1e-300);
}

double SphereSight::before_limb(const Eigen::Vector3d& u) const {
    return perspective ? u.dot(eye_u) - 1.0 : u.dot(eye_u);
}

bool SphereSight::hides(const Eigen::Vector3d& u) const {
    // A point that touches the surface from outside is within rounding of it.
    constexpr double rounding = 1e-9;
    if (surrounds_eye) return false;
    if (outside(u) < -rounding) return true;
    return within_outline(u) > rounding && before_limb(u) < -rounding;
}

Occluders::Occluders(const View& view, const Projection& projection)
    : view_(view), projection_(projection) {
    for (const Ellipsoid& ellipsoid : view.ellipsoids) spheres_.emplace_back(ellipsoid, projection);
    for (const Mesh& mesh : view.meshes)
        if (mesh.geometry != nullptr && mesh.opacity > 0.0) meshes_.emplace_back(mesh, projection);
}

Cover Occluders::at(const Eigen::Vector3d& point, const Membership& of) const {
    Cover cover;
    for (std::size_t k = 0; k < spheres_.size(); ++k) {
        const SphereSight& sphere = spheres_[k];
        if (!(sphere.hiding > 0.0)) continue;
        const Eigen::Vector3d u = sphere.u(point);
        const bool own = of.is_on(k);
        const bool hidden =
            own ? !sphere.surrounds_eye && sphere.before_limb(u) < 0.0 : sphere.hides(u);
        if (!hidden) continue;
        // A fading ellipsoid hides less of what lies behind it.
        const double hiding = own ? sphere.hiding_far : sphere.hiding;
        cover.before_bodies *= 1.0 - std::clamp(4.0 * hiding, 0.0, 1.0);
        cover.through_bodies *= 1.0 - hiding;
    }
    for (std::size_t k = 0; k < view_.planes.size(); ++k) {
        const Plane& plane = view_.planes[k];
        if (of.plane == static_cast<int>(k) || before_plane(projection_, plane, point) > -1e-9)
            continue;
        const double opacity =
            level(opacity_at(plane, crossing_distance(projection_, plane, point)));
        cover.through_planes *= 1.0 - opacity;
    }
    for (const MeshSight& mesh : meshes_) {
        if (!mesh.hides(point)) continue;
        cover.before_bodies = 0.0;
        cover.through_bodies *= 1.0 - mesh.mesh().opacity;
    }
    cover.clear = cover.before_bodies * cover.through_planes;
    cover.transmitted = cover.through_bodies * cover.through_planes;
    return cover;
}

std::vector<Occluders::Condition> Occluders::conditions(const Membership& of) const {
    std::vector<Condition> all;
    if (projection_.perspective)
        all.emplace_back([this](const Eigen::Vector3d& x) {
            return projection_.depth(x) - projection_.near_depth;
        });
    for (std::size_t k = 0; k < spheres_.size(); ++k) {
        const SphereSight& sphere = spheres_[k];
        if (!(sphere.hiding > 0.0) || sphere.surrounds_eye) continue;
        all.emplace_back(
            [&sphere](const Eigen::Vector3d& x) { return sphere.before_limb(sphere.u(x)); });
        if (of.is_on(k)) continue;
        all.emplace_back(
            [&sphere](const Eigen::Vector3d& x) { return sphere.outside(sphere.u(x)); });
        all.emplace_back(
            [&sphere](const Eigen::Vector3d& x) { return sphere.within_outline(sphere.u(x)); });
    }
    for (std::size_t k = 0; k < view_.planes.size(); ++k) {
        if (of.plane == static_cast<int>(k)) continue;
        const Plane& plane = view_.planes[k];
        all.emplace_back([this, &plane](const Eigen::Vector3d& x) {
            return before_plane(projection_, plane, x);
        });
        // Distances at which the opacity changes by one level.
        for (int step = 0; step < n_plane_levels; ++step) {
            const double there = (step + 0.5) / n_plane_levels;
            if (there >= plane.opacity) break;
            double near = plane.fade_from * plane.radius, far = plane.radius;
            for (int k2 = 0; k2 < 60; ++k2) {
                const double middle = 0.5 * (near + far);
                (opacity_at(plane, middle) > there ? near : far) = middle;
            }
            all.emplace_back([this, &plane, near](const Eigen::Vector3d& x) {
                return before_plane(projection_, plane, x) > 0.0
                           ? 1.0
                           : crossing_distance(projection_, plane, x) - near;
            });
        }
    }
    return all;
}

std::vector<double> Occluders::closer(const Track& track, std::span<const double> places) const {
    constexpr double apart_pt = 0.25;
    constexpr double most = 4096.0;  // samples between two places, since a curve may be long
    const auto lies_before = [this](const Eigen::Vector3d& x) {
        return !projection_.perspective || projection_.depth(x) > projection_.near_depth;
    };
    std::vector<double> all{places[0]};
    Eigen::Vector3d last = track.flow(places[0]).position;
    for (std::size_t k = 1; k < places.size(); ++k) {
        const Eigen::Vector3d here = track.flow(places[k]).position;
        double n = 1.0;
        if (lies_before(last) && lies_before(here))
            n = std::clamp(
                std::ceil((projection_.place(here) - projection_.place(last)).norm() / apart_pt),
                1.0, most);
        for (double i = 1.0; i < n; ++i)
            all.push_back(places[k - 1] + (places[k] - places[k - 1]) * i / n);
        all.push_back(places[k]);
        last = here;
    }
    return all;
}

std::vector<bool> Occluders::lies_on(const Track& track, std::span<const double> places) const {
    constexpr double most_off = 2e-5;  // of the radius: a few micrometres on paper
    std::vector<bool> all;
    for (const SphereSight& sphere : spheres_)
        all.push_back(std::all_of(places.begin(), places.end(), [&](double s) {
            return std::abs(sphere.outside(sphere.u(track.flow(s).position))) < most_off;
        }));
    return all;
}

std::vector<Span> Occluders::spans(const Track& track, const Membership& part_of) const {
    std::vector<double> breaks;
    if (track.knots.size() < 2) return {};
    const double first = track.knots.front(), last = track.knots.back();
    // Enough samples that no two roots of a condition lie between two of them undetected, except
    // for pairs near a touching point, which are searched.
    const int n = std::clamp(static_cast<int>(128 / track.knots.size()), 2, 64);
    std::vector<double> places{first};
    for (std::size_t k = 1; k < track.knots.size(); ++k)
        for (int i = 1; i <= n; ++i)
            places.push_back(i == n ? track.knots[k]
                                    : track.knots[k - 1] +
                                          (track.knots[k] - track.knots[k - 1]) * i / n);
    // A curve of intersection of two ellipsoids lies on both: rounding errors must not put it
    // behind either.
    Membership of = part_of;
    of.lies_on = lies_on(track, places);
    for (const Condition& condition : conditions(of)) {
        const std::function<double(double)> along = [&](double s) {
            return condition(track.flow(s).position);
        };
        RootFinder(along, breaks).search(places);
    }
    if (!meshes_.empty()) {
        const std::vector<double> close = closer(track, places);
        for (const MeshSight& mesh : meshes_) {
            const std::function<double(double)> along = [&](double s) {
                return mesh.hides(track.flow(s).position) ? -1.0 : 1.0;
            };
            RootFinder(along, breaks).search(close);
        }
    }
    breaks.push_back(first);
    breaks.push_back(last);
    std::sort(breaks.begin(), breaks.end());
    // Two computations of the same break may differ in the last digits.
    const double same = 1e-13 * std::max(std::abs(first), std::abs(last));
    breaks.erase(std::unique(breaks.begin(), breaks.end(),
                             [same](double a, double b) { return b - a <= same; }),
                 breaks.end());

    std::vector<Span> spans;
    for (std::size_t k = 1; k < breaks.size(); ++k) {
        const double from = breaks[k - 1], to = breaks[k];
        const Eigen::Vector3d middle = track.flow(0.5 * (from + to)).position;
        if (projection_.perspective && projection_.depth(middle) <= projection_.near_depth)
            continue;
        const Cover cover = at(middle, of);
        if (!spans.empty() && spans.back().to == from && spans.back().cover == cover)
            spans.back().to = to;
        else
            spans.push_back({from, to, cover});
    }
    return spans;
}

}  // namespace poinsot::vector
