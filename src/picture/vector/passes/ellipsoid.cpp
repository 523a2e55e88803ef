// Draws an ellipsoid: its exact outline, its shading, its principal sections and rulings.
#include "vector/passes/ellipsoid.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace poinsot::vector {

namespace {

using std::numbers::pi;

bool is_present(const Ellipsoid& ellipsoid) {
    return ellipsoid.opacity > 0.0 && ellipsoid.presence > 0.0;
}

// The intersections of a line of sight with both surfaces; the outer normals are turned towards the
// eye.
struct Meeting {
    bool any = false;
    SurfacePoint front, back;
    double front_depth = 0.0, back_depth = 0.0;
};

Meeting meeting_of(const Projection& projection, const SphereSight& sphere,
                   const Eigen::Vector2d& at) {
    const Eigen::Vector3d origin = sphere.u(projection.ray_origin(at));
    const Eigen::Vector3d ray = projection.ray(at);
    const Eigen::Vector3d d = (sphere.to_u * ray).normalized();
    const Eigen::Vector3d moment = origin.cross(d);
    const double square = 1.0 - moment.squaredNorm();
    Meeting meeting;
    meeting.any = square >= 0.0;
    const double root = std::sqrt(std::max(square, 0.0));
    const Eigen::Vector3d nearest = d.cross(moment);
    const auto point = [&](double side) {
        const Eigen::Vector3d u = (nearest + side * root * d).normalized();
        return SurfacePoint{(-side * (sphere.to_u.transpose() * u)).normalized(),
                            -ray.normalized()};
    };
    meeting.front = point(-1.0);
    meeting.back = point(1.0);
    const auto depth = [&](double side) {
        return projection.depth(sphere.centre + sphere.axes * (nearest + side * root * d));
    };
    meeting.front_depth = depth(-1.0);
    meeting.back_depth = depth(1.0);
    return meeting;
}

// The light of a layer blended over light from below.
Eigen::Vector3d laid(const Layer& layer, const Eigen::Vector3d& under) {
    return layer.alpha * layer.light + (1.0 - layer.alpha) * under;
}

// The combined opacity of both surfaces.
double opacity_of(const Ellipsoid& ellipsoid, const Lights& lights, const Meeting& meeting) {
    const double front = outer_surface(ellipsoid, lights, meeting.front, 0.0).alpha;
    const double back = inner_surface(ellipsoid, lights, meeting.back, 0.0).alpha;
    return front + (1.0 - front) * back;
}

ShadedDisc lit_disc(const Canvas& canvas, std::size_t number, const PaperEllipse& outline) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
    const SphereSight& sphere = canvas.occluders.spheres()[number];
    // Where ellipsoids show through each other, light changes faster and needs more samples.
    const bool one = canvas.view.ellipsoids.size() == 1;
    const int n_rings = one ? 5 : 7, n_spokes = one ? 9 : 11;
    ShadedDisc disc;
    disc.paper_from_disc = outline.paper_from_circle();
    disc.n_rings = n_rings;
    disc.n_spokes = n_spokes;
    std::vector<Colour> wanted, behind;
    // All ellipsoids drawn so far, and this one.
    std::vector<std::size_t> all = canvas.ellipsoids;
    all.push_back(number);
    const double size_pt = std::sqrt(std::abs(disc.paper_from_disc.linear().determinant()));
    const double limb_radius = std::max(1.0 - 0.25 / std::max(size_pt, 1e-9), 0.95);
    double alpha = 0.0;
    for (int ring = 0; ring <= n_rings; ++ring) {
        for (int spoke = 0; spoke < n_spokes; ++spoke) {
            // The bright limb is narrower than half a point: its middle represents it.
            const double r = std::min(disc.radius(ring), limb_radius);
            const Eigen::Vector2d place =
                outline.centre + r * (outline.at(2.0 * pi * spoke / n_spokes) - outline.centre);
            behind.push_back(canvas.behind(place));
            wanted.push_back(
                encoded(through_ellipsoids(canvas, all, place, linear(canvas.ground(place)))));
            alpha +=
                opacity_of(ellipsoid, canvas.lights, meeting_of(canvas.projection, sphere, place));
        }
    }
    // One mean opacity, so that the disc is a single sheet; the colours compensate for it.
    disc.alpha = alpha / static_cast<double>(wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        disc.colours.push_back(colour_making(wanted[k], disc.alpha, behind[k]));
    return disc;
}

// The look of a line of the ellipsoid at a point of the paper, over the shading there.
Canvas::LineLook line_on(const Canvas& canvas, std::size_t number, const Eigen::Vector2d& at,
                         bool front, double opacity) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
    const Colour behind = canvas.behind(at);
    // Without shading, lines on the far side are paler, over nothing.
    if (canvas.shading == Shading::none)
        return {ellipsoid.line_colour, opacity * ellipsoid.presence * (front ? 1.0 : 0.35), behind};
    const Meeting meeting = meeting_of(canvas.projection, canvas.occluders.spheres()[number], at);
    const auto fore = [&](double lines) {
        return outer_surface(ellipsoid, canvas.lights, meeting.front, lines);
    };
    const auto back = [&](double lines) {
        return inner_surface(ellipsoid, canvas.lights, meeting.back, lines);
    };
    const Eigen::Vector3d under = linear(behind);
    const Eigen::Vector3d tone = laid(fore(0.0), laid(back(0.0), under));
    const Eigen::Vector3d inked =
        front ? laid(fore(1.0), laid(back(0.0), under)) : laid(fore(0.0), laid(back(1.0), under));
    return {encoded(inked), opacity, encoded(tone)};
}

// Whether a span of a line stays inside the outline by this margin.
bool is_within(const Canvas& canvas, const PaperEllipse& outline, const Track& track,
               const Canvas::ConstantColourSpan& part, double margin_pt) {
    constexpr int n = 8;
    const double shorter = outline.paper_from_circle().linear().jacobiSvd().singularValues()[1];
    for (int k = 0; k <= n; ++k) {
        const double s = part.from + (part.to - part.from) * k / n;
        const Eigen::Vector2d at = canvas.projection.place(track.flow(s).position);
        if (outline.radius_of(at) > 1.0 - margin_pt / shorter) return false;
    }
    return true;
}

// A line on the surface.
struct SurfaceLine {
    Conic conic;
    double first = 0.0, last = 2.0 * pi;  // of the conic's parameter
    double width_pt = 1.0;
    std::function<double(double)> opacity_at;
    bool also_behind = false;  // whether its part on the far side is drawn
};

// Strokes a line on the surface: its part on the near side and its part on the far side.
void stroke_line(const Canvas& canvas, std::size_t number, const PaperEllipse& outline,
                 const SurfaceLine& line) {
    const Conic& conic = line.conic;
    const double first = line.first, last = line.last;
    const SphereSight& sphere = canvas.occluders.spheres()[number];
    // On the near side α + β cos s + γ sin s > 0, which is one interval about the maximum.
    const auto facing = [&](const Eigen::Vector3d& v) {
        return (sphere.to_u * v).dot(sphere.eye_u);
    };
    const double alpha = sphere.before_limb(sphere.u(conic.centre));
    const double beta = facing(conic.cosine_axis), gamma = facing(conic.sine_axis);
    const double swing = std::hypot(beta, gamma), middle = std::atan2(gamma, beta);
    const double reach = std::acos(std::clamp(-alpha / std::max(swing, 1e-300), -1.0, 1.0));
    std::vector<double> cuts{first, last};
    for (int turn = -2; turn <= 2; ++turn)
        for (const double s : {middle - reach, middle + reach})
            if (first < s + 2.0 * pi * turn && s + 2.0 * pi * turn < last)
                cuts.push_back(s + 2.0 * pi * turn);
    std::sort(cuts.begin(), cuts.end());
    const Track track = track_of(conic, first, last);
    for (std::size_t k = 1; k < cuts.size(); ++k) {
        if (cuts[k] - cuts[k - 1] < 1e-9) continue;
        const double s = 0.5 * (cuts[k - 1] + cuts[k]);
        const bool front = alpha + beta * std::cos(s) + gamma * std::sin(s) > 0.0;
        if (!front && !line.also_behind) continue;
        if (canvas.projection.perspective &&
            canvas.projection.depth(conic.at(s)) <= canvas.projection.near_depth)
            continue;
        const auto look_at = [&](double t) {
            return line_on(canvas, number, canvas.projection.place(conic.at(t)), front,
                           line.opacity_at(t));
        };
        constexpr double unseen = 0.15, faintest = 0.1, faint = 0.25;
        const double step = (cuts[k] - cuts[k - 1]) / 200.0;
        for (Canvas::ConstantColourSpan& part :
             canvas.constant_colour_spans(track, cuts[k - 1], cuts[k], look_at)) {
            while (part.from < part.to && line.opacity_at(part.from) < unseen) part.from += step;
            while (part.from < part.to && line.opacity_at(part.to) < unseen) part.to -= step;
            if (!(part.from < part.to)) continue;
            if (part.ink.alpha < faintest) continue;
            // Lines lie on the surface: clip their width where the surface ends.
            const bool clips = canvas.shading != Shading::none && part.ink.alpha > faint &&
                               !is_within(canvas, outline, track, part, 0.5 * line.width_pt);
            if (clips) canvas.add(canvas.clip_to(outline, true));
            Stroke stroke;
            stroke.path = canvas.path_of(track, part.from, part.to, conic_tolerance_pt);
            stroke.ink = part.ink;
            stroke.width_pt = line.width_pt;
            stroke.round = false;
            canvas.add(std::move(stroke));
            if (clips) canvas.add(ClipEnd{});
        }
    }
}

// Strokes meridians and parallels about the third axis. Where they are dense they fade, as on the
// screen (ruled_apart in lines.glsl).
void stroke_rulings(const Canvas& canvas, std::size_t number, const PaperEllipse& outline) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
    const SphereSight& sphere = canvas.occluders.spheres()[number];
    const Eigen::Vector3d a = sphere.axes.col(0), b = sphere.axes.col(1), c = sphere.axes.col(2);
    const double ruling_pt = canvas.line_pt(ellipsoid.ruling_px);
    if (!(ruling_pt > 0.0 && ellipsoid.ruling_opacity > 0.0)) return;
    const auto opacity = [&](double longitude, double latitude, double per_meridian,
                             double per_parallel) {
        const Eigen::Vector3d out = std::cos(longitude) * a + std::sin(longitude) * b;
        const Eigen::Vector3d east =
            std::cos(latitude) * (std::cos(longitude) * b - std::sin(longitude) * a);
        const Eigen::Vector3d north = std::cos(latitude) * c - std::sin(latitude) * out;
        const Eigen::Vector3d at =
            sphere.centre + std::cos(latitude) * out + std::sin(latitude) * c;
        const double px = per_meridian > 0.0
                              ? spacing_px(canvas.projection, at, north, per_meridian * east)
                              : spacing_px(canvas.projection, at, east, per_parallel * north);
        return ellipsoid.ruling_opacity * std::clamp(0.1 * px - 0.4, 0.0, 1.0);
    };
    for (int k = 0; k < ellipsoid.n_meridians; ++k) {
        const double step = 2.0 * pi / ellipsoid.n_meridians, longitude = step * k;
        const Conic meridian{sphere.centre, std::cos(longitude) * a + std::sin(longitude) * b, c};
        stroke_line(canvas, number, outline,
                    {.conic = meridian,
                     .first = -0.5 * pi,
                     .last = 0.5 * pi,
                     .width_pt = ruling_pt,
                     .opacity_at = [&](double latitude) {
                         return opacity(longitude, latitude, step, 0.0);
                     }});
    }
    for (int k = 1; k <= ellipsoid.n_parallels; ++k) {
        const double step = pi / (ellipsoid.n_parallels + 1), latitude = step * k - 0.5 * pi;
        const Conic parallel{sphere.centre + std::sin(latitude) * c, std::cos(latitude) * a,
                             std::cos(latitude) * b};
        stroke_line(canvas, number, outline,
                    {.conic = parallel, .width_pt = ruling_pt, .opacity_at = [&](double longitude) {
                         return opacity(longitude, latitude, 0.0, step);
                     }});
    }
}

void stroke_sections(const Canvas& canvas, std::size_t number, const PaperEllipse& outline) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
    if (!(ellipsoid.section_px > 0.0)) return;
    const SphereSight& sphere = canvas.occluders.spheres()[number];
    const Eigen::Vector3d a = sphere.axes.col(0), b = sphere.axes.col(1), c = sphere.axes.col(2);
    const double section_pt = canvas.line_pt(ellipsoid.section_px);
    for (const Conic& section :
         {Conic{sphere.centre, a, b}, Conic{sphere.centre, b, c}, Conic{sphere.centre, c, a}})
        stroke_line(canvas, number, outline,
                    {.conic = section,
                     .width_pt = section_pt,
                     .opacity_at = [](double) { return 1.0; },
                     .also_behind = true});
}

PaperInk contour_ink(const Canvas& canvas, const Ellipsoid& ellipsoid,
                     const Eigen::Vector2d& centre) {
    if (canvas.shading != Shading::none) return {ellipsoid.contour_colour, ellipsoid.presence};
    const bool has_lines = ellipsoid.section_px > 0.0 || ellipsoid.ruling_px > 0.0;
    const Colour colour = has_lines ? ellipsoid.line_colour : ellipsoid.colour;
    return {contour_colour(colour, canvas.ground(centre)), ellipsoid.presence};
}

// Zero if there is none.
double contour_width_pt(const Canvas& canvas, const Ellipsoid& ellipsoid) {
    if (canvas.shading != Shading::none) return canvas.line_pt(ellipsoid.contour_px);
    // Without shading every surface has a contour, also one without lines of its own; that of a
    // surface that is hardly there is thinner. Sections may be drawn as separate curves.
    constexpr double faint = 0.25;
    const double px = ellipsoid.section_px > 0.0 ? ellipsoid.section_px : ellipsoid.ruling_px;
    return std::max(canvas.line_pt(1.5 * px),
                    ellipsoid.opacity < faint ? least_line_pt : contour_pt);
}

}  // namespace

Eigen::Vector3d through_ellipsoids(const Canvas& canvas, const std::vector<std::size_t>& numbers,
                                   const Eigen::Vector2d& at, const Eigen::Vector3d& under,
                                   double depth) {
    std::vector<std::pair<double, Layer>> surfaces;  // by depth
    surfaces.reserve(2 * numbers.size());
    for (const std::size_t number : numbers) {
        const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
        if (!is_present(ellipsoid)) continue;
        const Meeting meeting =
            meeting_of(canvas.projection, canvas.occluders.spheres()[number], at);
        if (!meeting.any) continue;
        surfaces.emplace_back(meeting.front_depth,
                              outer_surface(ellipsoid, canvas.lights, meeting.front, 0.0));
        surfaces.emplace_back(meeting.back_depth,
                              inner_surface(ellipsoid, canvas.lights, meeting.back, 0.0));
    }
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    Eigen::Vector3d light = under;
    for (const auto& [nearer, layer] : surfaces)
        if (nearer < depth) light = laid(layer, light);
    return light;
}

void light_sheets(Canvas& canvas, const std::vector<std::size_t>& order) {
    for (const std::size_t number : order) {
        if (is_present(canvas.view.ellipsoids[number]))
            if (const auto limb = limb_of(canvas.occluders.spheres()[number]))
                if (const auto outline = picture_of(*limb, canvas.projection)) {
                    LitSheet sheet{number, *outline, {}};
                    if (canvas.has_fills()) sheet.disc = lit_disc(canvas, number, *outline);
                    canvas.sheets.push_back(std::move(sheet));
                }
        canvas.ellipsoids.push_back(number);
    }
    canvas.ellipsoids.clear();
}

Colour under_sheets(const Canvas& canvas, const Eigen::Vector3d& point, const Colour& colour) {
    if (canvas.sheets.empty() || !canvas.has_fills()) return colour;
    const Eigen::Vector2d at = canvas.projection.place(point);
    std::vector<std::size_t> numbers;
    for (const LitSheet& sheet : canvas.sheets) numbers.push_back(sheet.number);
    Colour needed = encoded(
        through_ellipsoids(canvas, numbers, at, linear(colour), canvas.projection.depth(point)));
    for (auto sheet = canvas.sheets.rbegin(); sheet != canvas.sheets.rend(); ++sheet) {
        const Eigen::Vector2d in_disc = sheet->disc.paper_from_disc.inverse() * at;
        if (in_disc.norm() >= 1.0 || sheet->disc.alpha >= 1.0) continue;
        // The drawn colour under the sheet gives the needed colour over it: that is the needed
        // ink's `colour`.
        needed = colour_making(needed, 1.0 - sheet->disc.alpha, sheet->disc.at(in_disc));
    }
    return needed;
}

void draw_ellipsoid(const Canvas& canvas, const LitSheet& sheet) {
    const std::size_t number = sheet.number;
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[number];
    const PaperEllipse* const outline = &sheet.outline;
    if (canvas.shading == Shading::tone) {
        Fill fill;
        fill.path = canvas.path_of(*outline);
        fill.paint = sheet.disc;
        canvas.add(std::move(fill));
    } else if (canvas.shading == Shading::none) {
        // Lines on the far side are paler, as seen through the surface.
        Fill veil;
        veil.path = canvas.path_of(*outline);
        veil.paint =
            PaperInk{canvas.behind(outline->centre), ellipsoid.opacity * ellipsoid.presence};
        canvas.add(std::move(veil));
    }
    stroke_rulings(canvas, number, *outline);
    stroke_sections(canvas, number, *outline);
    const double width_pt = contour_width_pt(canvas, ellipsoid);
    if (!(width_pt > 0.0)) return;
    Stroke stroke;
    stroke.path = canvas.path_of(*outline);
    stroke.ink = contour_ink(canvas, ellipsoid, outline->centre);
    stroke.width_pt = width_pt;
    canvas.add(std::move(stroke));
}

}  // namespace poinsot::vector
