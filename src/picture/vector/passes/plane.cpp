// Draws a plane's disc, which fades towards its rim, and its grid.
#include "vector/passes/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "shapes/soft_shadow.h"

namespace poinsot::vector {

namespace {

constexpr int n_levels = 8;

// A circle of the plane about its centre.
Conic circle_of(const Plane& plane, double radius) {
    return {plane.centre, radius * plane.along, radius * plane.normal.cross(plane.along)};
}

// The largest disc that is entirely in front of the eye, as a share of the plane's radius.
double share_before_eye(const Canvas& canvas, const Plane& plane) {
    if (!canvas.projection.perspective) return 1.0;
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    const double tilt = std::hypot(canvas.projection.forward.dot(plane.along),
                                   canvas.projection.forward.dot(across));
    const double room = canvas.projection.depth(plane.centre) - 2.0 * canvas.projection.near_depth;
    return std::clamp(room / std::max(tilt * plane.radius, 1e-12), 0.0, 1.0);
}

void fill_disc(const Canvas& canvas, const Plane& plane, double share) {
    const auto rim = picture_of(circle_of(plane, share * plane.radius), canvas.projection);
    const auto inner =
        picture_of(circle_of(plane, share * plane.fade_from * plane.radius), canvas.projection);
    if (!rim || !inner) return;
    RadialFade fade;
    fade.paper_from_circle = rim->paper_from_circle();
    // The projections of the discs in between shrink approximately about one point.
    const Eigen::Affine2d to_circle = fade.paper_from_circle.inverse();
    const Eigen::Vector2d inner_centre = to_circle * inner->centre;
    const Eigen::Matrix2d shrunk = to_circle.linear() * inner->paper_from_circle().linear();
    const double inner_radius = std::sqrt(std::abs(shrunk.determinant()));
    fade.focus = inner_centre / std::max(1.0 - inner_radius, 1e-6);
    if (fade.focus.norm() > 0.95) fade.focus *= 0.95 / fade.focus.norm();
    const Colour behind = canvas.behind(canvas.projection.place(plane.centre));
    const auto ink = [&](double radius) {
        return as_in_light(plane.colour, opacity_at(plane, radius), behind);
    };
    fade.stops.push_back({0.0, ink(0.0)});
    constexpr int n_stops = 8;
    for (int k = 0; k <= n_stops; ++k) {
        const double part = static_cast<double>(k) / n_stops;
        const double radius =
            plane.radius * share * (plane.fade_from + (1.0 - plane.fade_from) * part);
        fade.stops.push_back({inner_radius + (1.0 - inner_radius) * part, ink(radius)});
    }
    Fill fill;
    fill.path = canvas.path_of(*rim);
    fill.paint = std::move(fade);
    canvas.add(std::move(fill));
}

// Clips a segment to the part in front of the eye; returns false if there is none.
bool cut_before_eye(const Projection& projection, Eigen::Vector3d& a, Eigen::Vector3d& b) {
    if (!projection.perspective) return true;
    const double least = 2.0 * projection.near_depth;
    const double depth_a = projection.depth(a), depth_b = projection.depth(b);
    if (std::max(depth_a, depth_b) <= least) return false;
    const Eigen::Vector3d crossing = a + (least - depth_a) / (depth_b - depth_a) * (b - a);
    if (depth_a < least) a = crossing;
    if (depth_b < least) b = crossing;
    return true;
}

// The lines of the grid in pieces of uniform opacity.
class Grid {
 public:
    Grid(const Canvas& canvas, const Plane& plane)
        : canvas_(canvas),
          plane_(plane),
          plane_number_(static_cast<int>(&plane - canvas.view.planes.data())) {
        across_ = plane.normal.cross(plane.along);
        // Distances at which the opacity changes by one level.
        for (int k = 0; k <= n_levels; ++k) {
            const double part = static_cast<double>(k) / n_levels;
            radii_.push_back(plane.radius * (plane.fade_from + (1.0 - plane.fade_from) * part));
        }
    }

    void draw() {
        const double spacing = plane_.grid_spacing;
        const int n = static_cast<int>(std::min(plane_.radius / spacing, 500.0));
        for (int k = -n; k <= n; ++k) {
            add_line(plane_.along, across_, k * spacing);
            add_line(across_, plane_.along, k * spacing);
        }
        for (auto& [level, path] : paths_) {
            const double alpha = static_cast<double>(level) / n_shades;
            Stroke stroke;
            stroke.path = std::move(path);
            stroke.ink = as_in_light(plane_.grid_colour, alpha,
                                     canvas_.behind(canvas_.projection.place(plane_.centre)));
            // Without fills, the grid is the only thing that stands for the floor, and must not be
            // louder than the curves on it.
            stroke.width_pt = canvas_.has_fills() ? canvas_.line_pt(plane_.grid_px) : least_line_pt;
            stroke.round = false;
            canvas_.add(std::move(stroke));
        }
    }

 private:
    static constexpr int n_shades = 16;

    void add_line(const Eigen::Vector3d& direction, const Eigen::Vector3d& side, double offset) {
        std::vector<double> ends;
        for (auto radius = radii_.rbegin(); radius != radii_.rend(); ++radius)
            if (std::abs(offset) < *radius) ends.push_back(-chord(*radius, offset));
        const std::size_t n = ends.size();
        for (std::size_t k = n; k-- > 0;) ends.push_back(-ends[k]);
        for (std::size_t k = 1; k < ends.size(); ++k)
            add_piece(direction, side, offset, ends[k - 1], ends[k]);
    }
    static double chord(double radius, double offset) {
        return std::sqrt(std::max(radius * radius - offset * offset, 0.0));
    }
    void add_piece(const Eigen::Vector3d& direction, const Eigen::Vector3d& side, double offset,
                   double from, double to) {
        const Eigen::Vector3d foot = plane_.centre + offset * side;
        Eigen::Vector3d a = foot + from * direction, b = foot + to * direction;
        if (!cut_before_eye(canvas_.projection, a, b)) return;
        const Eigen::Vector3d middle = 0.5 * (a + b);
        // Lines closer than a few pixels would merge into a uniform tone.
        const Eigen::Vector2d here = canvas_.projection.place(middle);
        const Eigen::Vector2d next = canvas_.projection.place(middle + plane_.grid_spacing * side);
        const Eigen::Vector2d along =
            (canvas_.projection.place(b) - canvas_.projection.place(a)).normalized();
        const Eigen::Vector2d apart = next - here;
        const double apart_px = std::abs(apart.x() * along.y() - apart.y() * along.x()) /
                                canvas_.projection.units_per_px;
        const double t = std::clamp((apart_px - 3.0) / 11.0, 0.0, 1.0);
        const double alpha =
            opacity_at(plane_, std::hypot(offset, 0.5 * (from + to))) * t * t * (3.0 - 2.0 * t);
        const int level = static_cast<int>(std::lround(alpha * n_shades));
        if (level == 0) return;
        Path& path = paths_[level];
        for (const auto& [from_share, to_share] : shown_parts(a, b)) {
            const Eigen::Vector2d begin = canvas_.projection.place(a + from_share * (b - a)),
                                  end = canvas_.projection.place(a + to_share * (b - a));
            if (path.steps.empty() || path.steps.back().to != begin) path.move(begin);
            path.line(end);
        }
    }
    // A body without fills hides the grid by ending it at the outline: lines across the body would
    // be taken for lines on it.
    std::vector<std::pair<double, double>> shown_parts(const Eigen::Vector3d& a,
                                                       const Eigen::Vector3d& b) const {
        if (canvas_.has_fills()) return {{0.0, 1.0}};
        Track track;
        track.flow = [a, b](double s) { return CurveFlow{a + s * (b - a), b - a}; };
        track.knots = {0.0, 1.0};
        std::vector<std::pair<double, double>> parts;
        constexpr double half = 0.5;
        for (const Span& span : canvas_.occluders.spans(track, {-1, plane_number_}))
            if (span.cover.before_bodies > half) parts.emplace_back(span.from, span.to);
        return parts;
    }

    const Canvas& canvas_;
    const Plane& plane_;
    int plane_number_;  // of the view
    Eigen::Vector3d across_;
    std::vector<double> radii_;
    std::map<int, Path> paths_;
};

}  // namespace

bool is_before_solids(const Canvas& canvas, const Plane& plane) {
    const Projection& projection = canvas.projection;
    const double eye_side = projection.perspective ? plane.normal.dot(projection.eye - plane.centre)
                                                   : -plane.normal.dot(projection.forward);
    double far_side = 0.0;
    for (const Ellipsoid& ellipsoid : canvas.view.ellipsoids)
        far_side += plane.normal.dot(ellipsoid.centre - plane.centre) * eye_side < 0.0 ? 1.0 : -1.0;
    return far_side > 0.0;
}

void draw_plane(const Canvas& canvas, const Plane& plane) {
    if (plane.opacity <= 0.0 || plane.radius <= 0.0) return;
    const double share = share_before_eye(canvas, plane);
    if (share > 0.0 && canvas.has_fills()) fill_disc(canvas, plane, share);
    // With bodies in `picture` shading, the grid is part of the pixels.
    if (canvas.shading == Shading::picture && !canvas.view.meshes.empty()) return;
    if (plane.grid_px > 0.0 && plane.grid_spacing > 0.0) Grid(canvas, plane).draw();
}

}  // namespace poinsot::vector
