// Draws bodies made of triangles, and cones.
#include "vector/passes/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "error/error.h"
#include "vector/gradients.h"
#include "vector/passes/ellipsoid.h"
#include "vector/passes/face_picture.h"

namespace poinsot::vector {

namespace {

using std::numbers::pi;

constexpr int n_places = 7;

using Bodies = std::span<const MeshSight>;

// Whether a body hides what lies behind it: another body, or another part of itself.
bool covers(const MeshSight& body, const MeshSight& other) {
    return &body == &other || body.mesh().opacity >= 1.0;
}

// A triangle and its data for filling.
struct Facet {
    const MeshSight::Triangle* triangle = nullptr;
    std::array<Colour, 3> colours{};  // of the corners
    bool faces = false;
    double depth = 0.0;                // of its centre
    int n_hidden = 0;                  // number of its hidden sample points
    std::vector<std::size_t> hides{};  // numbers of the triangles that it hides at a sample point
    int rank = 0;                      // greater than the rank of each visible triangle that hides
                                       // it

    bool is_seen() const { return faces && n_hidden < n_places; }
};

Colour lit_colour(const Canvas& canvas, const Mesh& mesh, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& normal) {
    return encoded(
        mesh_surface(mesh.colour, canvas.lights,
                     {normal.normalized(), canvas.projection.towards_eye(at).normalized()}));
}

// The normal of the smooth surface at a point of a triangle.
Eigen::Vector3d normal_at(const MeshSight::Triangle& triangle, const Eigen::Vector3d& point) {
    const auto& c = triangle.corners;
    const Eigen::Vector3d& n = triangle.normal;
    const double whole = std::max(n.squaredNorm(), 1e-300);
    const double first = n.dot((c[1] - point).cross(c[2] - point)) / whole;
    const double second = n.dot((c[2] - point).cross(c[0] - point)) / whole;
    const Eigen::Vector3d normal = first * triangle.corner_normals[0].normalized() +
                                   second * triangle.corner_normals[1].normalized() +
                                   (1.0 - first - second) * triangle.corner_normals[2].normalized();
    return normal.norm() > 1e-6 ? normal : n;
}

Facet facet_of(const Canvas& canvas, const Mesh& mesh, const MeshSight::Triangle& triangle) {
    const Eigen::Vector3d middle =
        (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
    const Eigen::Vector3d to_eye = canvas.projection.towards_eye(middle).normalized();
    Facet facet;
    facet.triangle = &triangle;
    facet.faces = triangle.normal.dot(to_eye) > 0.0;
    facet.depth = canvas.projection.depth(middle);
    if (canvas.shading == Shading::none) {
        facet.colours.fill(canvas.behind(triangle.paper[0]));
        return facet;
    }
    const auto colour_at = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
        return under_sheets(canvas, at, lit_colour(canvas, mesh, at, normal));
    };
    for (std::size_t k = 0; k < 3 && facet.faces; ++k)
        facet.colours[k] = colour_at(triangle.corners[k], triangle.corner_normals[k]);
    return facet;
}

// Sample points of a triangle: its centre, and points near its corners and sides.
std::array<Eigen::Vector3d, n_places> places_of(const MeshSight::Triangle& triangle) {
    constexpr double inset = 0.03;
    const auto& c = triangle.corners;
    const Eigen::Vector3d middle = (c[0] + c[1] + c[2]) / 3.0;
    std::array<Eigen::Vector3d, n_places> places{middle};
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d side = 0.5 * (c[k] + c[(k + 1) % 3]);
        places[2 * k + 1] = c[k] + inset * (middle - c[k]);
        places[2 * k + 2] = side + inset * (middle - side);
    }
    return places;
}

// Edges for a line drawing: where the surface turns away from the eye, boundaries, and sharp edges.
std::vector<std::array<Eigen::Vector3d, 2>> drawn_edges(const Projection& projection,
                                                        const MeshSight& mesh) {
    constexpr double sharp_cosine = 0.8;
    struct Edge {
        int n_triangles = 0, n_facing = 0;
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        bool is_sharp = false;
        std::array<Eigen::Vector3d, 2> ends;
    };
    using Key = std::array<double, 6>;
    std::map<Key, Edge> edges;
    for (const MeshSight::Triangle& triangle : mesh.triangles()) {
        const Eigen::Vector3d normal = triangle.normal.normalized();
        const bool faces = normal.dot(projection.towards_eye(triangle.corners[0])) > 0.0;
        for (int k = 0; k < 3; ++k) {
            Eigen::Vector3d a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
            if (std::lexicographical_compare(b.data(), b.data() + 3, a.data(), a.data() + 3))
                std::swap(a, b);
            Edge& edge = edges[{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}];
            if (edge.n_triangles++ == 0)
                edge.normal = normal;
            else if (edge.normal.dot(normal) < sharp_cosine)
                edge.is_sharp = true;
            edge.n_facing += faces ? 1 : 0;
            edge.ends = {a, b};
        }
    }
    std::vector<std::array<Eigen::Vector3d, 2>> drawn;
    for (const auto& [key, edge] : edges)
        if (edge.n_facing > 0 &&
            (edge.is_sharp || edge.n_triangles == 1 || edge.n_facing < edge.n_triangles))
            drawn.push_back(edge.ends);
    return drawn;
}

void draw_edges(const Canvas& canvas, const MeshSight& body) {
    constexpr double width_pt = 0.7;
    Stroke stroke;
    stroke.ink = {encoded(0.15 * linear(body.mesh().colour)), body.mesh().opacity};
    stroke.width_pt = width_pt;
    for (const auto& [a, b] : drawn_edges(canvas.projection, body)) {
        Track track;
        track.flow = [from = a, run = Eigen::Vector3d(b - a)](double s) {
            return CurveFlow{from + s * run, run};
        };
        track.knots = {0.0, 1.0};
        for (const Span& span : canvas.occluders.spans(track, {}))
            if (span.cover.clear > 0.5) {
                stroke.path.move(canvas.projection.place(track.flow(span.from).position));
                stroke.path.line(canvas.projection.place(track.flow(span.to).position));
            }
    }
    if (!stroke.path.steps.empty()) canvas.add(std::move(stroke));
}

// All triangles of all bodies in order, with the triangles that each one hides at its sample
// points.
std::vector<Facet> facets_of(const Canvas& canvas, Bodies bodies) {
    std::vector<Facet> facets;
    std::vector<std::size_t> first;  // of each body
    for (const MeshSight& body : bodies) {
        first.push_back(facets.size());
        for (const MeshSight::Triangle& triangle : body.triangles())
            facets.push_back(facet_of(canvas, body.mesh(), triangle));
    }
    std::vector<MeshSight::Crossing> crossings;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (std::size_t k = 0; k < bodies[b].triangles().size(); ++k) {
            const std::size_t own = first[b] + k;
            if (!facets[own].faces) continue;
            for (const Eigen::Vector3d& place : places_of(*facets[own].triangle)) {
                const double depth = canvas.projection.depth(place);
                const double touching = 1e-6 * (canvas.projection.perspective ? depth : 1.0);
                bool hidden = false;
                for (std::size_t other = 0; other < bodies.size(); ++other) {
                    crossings.clear();
                    bodies[other].crossings(canvas.projection.place(place), crossings);
                    for (const MeshSight::Crossing& there : crossings) {
                        const std::size_t number = first[other] + there.number;
                        // On a closed surface, the near side hides the far side.
                        if (!facets[number].faces) continue;
                        if (there.depth < depth - touching && covers(bodies[other], bodies[b])) {
                            hidden = true;
                            facets[number].hides.push_back(own);
                        } else if (there.depth > depth + touching &&
                                   covers(bodies[b], bodies[other])) {
                            facets[own].hides.push_back(number);
                        }
                    }
                }
                facets[own].n_hidden += hidden ? 1 : 0;
            }
        }
    return facets;
}

// Assigns the ranks after those of all triangles that hide a triangle. In a cycle of mutual hiding,
// the nearest triangle comes first.
void rank(std::vector<Facet>& facets) {
    std::vector<std::size_t> waits(facets.size(), 0);  // number of unranked triangles that hide
                                                       // each one
    for (const Facet& facet : facets)
        for (const std::size_t farther : facet.hides) ++waits[farther];
    std::vector<std::size_t> by_depth(facets.size());
    std::iota(by_depth.begin(), by_depth.end(), 0);
    std::stable_sort(by_depth.begin(), by_depth.end(), [&](std::size_t a, std::size_t b) {
        return facets[a].depth < facets[b].depth;
    });
    std::vector<bool> ranked(facets.size(), false);
    std::vector<std::size_t> ready;
    for (std::size_t k = 0; k < facets.size(); ++k)
        if (waits[k] == 0) ready.push_back(k);
    for (std::size_t next = 0; next < facets.size() || !ready.empty();) {
        if (ready.empty()) ready.push_back(by_depth[next++]);
        const std::size_t nearer = ready.back();
        ready.pop_back();
        if (ranked[nearer]) continue;
        ranked[nearer] = true;
        const int above = facets[nearer].rank + (facets[nearer].is_seen() ? 1 : 0);
        for (const std::size_t farther : facets[nearer].hides) {
            if (ranked[farther]) continue;
            facets[farther].rank = std::max(facets[farther].rank, above);
            if (--waits[farther] == 0) ready.push_back(farther);
        }
    }
}

void fill_bodies(const Canvas& canvas, Bodies bodies) {
    std::vector<Facet> facets = facets_of(canvas, bodies);
    rank(facets);
    // Triangles that do not hide each other are filled together, the highest rank first.
    std::vector<ShadedTriangle> shaded;
    for (const Facet& facet : facets) {
        if (!facet.is_seen()) continue;
        ShadedTriangle& triangle = shaded.emplace_back();
        std::copy_n(facet.triangle->paper, 3, triangle.corners);
        std::copy_n(facet.colours.begin(), 3, triangle.colours);
        triangle.layer = -facet.rank;
    }
    constexpr std::size_t most_fills = 500;
    for (Fill& fill : gradient_fills(shaded, least_shade, most_fills)) canvas.add(std::move(fill));
}

struct ConeAxes {
    explicit ConeAxes(const Cone& cone) : axis(cone.axis.normalized()) {
        const Eigen::Vector3d across = cone.reference - cone.reference.dot(axis) * axis;
        first = across.norm() > 1e-9 ? Eigen::Vector3d(across.normalized()) : axis.unitOrthogonal();
        second = axis.cross(first);
        constexpr double least = 1e-3;
        radius = cone.length * std::tan(std::clamp(cone.half_angle_rad, least, 0.5 * pi - least));
    }
    Eigen::Vector3d first, second, axis;
    double radius = 0.0;  // of the rim
};

// The colour of a cone at a point of the paper, with the colour behind it.
struct ConeSeen {
    int n_sheets = 0;
    ColourOver look;
};

ConeSeen seen_at(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                 const Eigen::Vector2d& at) {
    // Intersects the line of sight o + t d with the cone: across² = (slope along)², with `along` up
    // to that of the rim.
    const double slope = axes.radius / cone.length;
    const Eigen::Vector3d o = canvas.projection.ray_origin(at) - cone.apex;
    const Eigen::Vector3d d = canvas.projection.ray(at);
    const double o_along = o.dot(axes.axis), d_along = d.dot(axes.axis);
    const double a = d.squaredNorm() - (1.0 + slope * slope) * d_along * d_along;
    const double b = o.dot(d) - (1.0 + slope * slope) * o_along * d_along;
    const double c = o.squaredNorm() - (1.0 + slope * slope) * o_along * o_along;
    const double square = b * b - a * c;
    ConeSeen seen;
    seen.look.behind = canvas.behind(at);
    if (square < 0.0 || std::abs(a) < 1e-12) return seen;
    const double root = std::sqrt(square);
    std::array<double, 2> meetings{(-b - root) / a, (-b + root) / a};
    std::sort(meetings.begin(), meetings.end(), std::greater<>());
    Eigen::Vector3d light = linear(seen.look.behind);
    for (const double t : meetings) {
        const Eigen::Vector3d x = o + t * d;
        const double along = x.dot(axes.axis);
        if (along <= 0.0 || along >= cone.length) continue;
        ++seen.n_sheets;
        const Eigen::Vector3d outward =
            (x - (1.0 + slope * slope) * along * axes.axis).normalized();
        const Eigen::Vector3d to_eye = -d.normalized();
        const double side = outward.dot(to_eye) < 0.0 ? -1.0 : 1.0;
        const Layer layer = cone_surface(cone, canvas.lights, {side * outward, to_eye});
        const Cover cover = canvas.occluders.at(cone.apex + x, {});
        const double alpha = layer.alpha * (cover.clear + (1.0 - cover.clear) * cover.transmitted);
        light += alpha * (layer.light - light);
    }
    seen.look.wanted = encoded(light);
    return seen;
}

// The outline of the view's only ellipsoid, across which the look of a cone changes; nothing if
// there are several.
std::optional<PaperEllipse> only_outline(const Canvas& canvas) {
    if (canvas.view.ellipsoids.size() != 1) return std::nullopt;
    const auto limb = limb_of(canvas.occluders.spheres()[0]);
    return limb ? picture_of(*limb, canvas.projection) : std::nullopt;
}

// Fills the region inside the rim, where a line of sight meets one sheet, and the region between
// rim and apex, where it meets both; each with one ink that is right on average.
void fill_sheets(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                 const PaperEllipse& rim, Path hull) {
    constexpr int n = 32;
    const std::optional<PaperEllipse> outline = only_outline(canvas);
    const Eigen::Vector2d apex = canvas.projection.place(cone.apex);
    const Eigen::Vector2d reach = (rim.a.cwiseAbs2() + rim.b.cwiseAbs2()).cwiseSqrt();
    const Eigen::Vector2d low = apex.cwiseMin(rim.centre - reach);
    const Eigen::Vector2d step = (apex.cwiseMax(rim.centre + reach) - low) / n;
    std::array<std::array<std::vector<ColourOver>, 2>, 2> looks;  // by outline and number of sheets
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Eigen::Vector2d at = low + step.cwiseProduct(Eigen::Vector2d(i + 0.5, j + 0.5));
            const ConeSeen seen = seen_at(canvas, cone, axes, at);
            if (seen.n_sheets == 0) continue;
            const bool within = outline && outline->radius_of(at) < 1.0;
            looks[within ? 1 : 0][seen.n_sheets == 2 ? 1 : 0].push_back(seen.look);
        }
    Path within_rim = canvas.path_of(rim);
    Path between = std::move(hull);
    if (!between.steps.empty()) between.add(within_rim);
    const bool is_split = !(looks[0][0].empty() && looks[0][1].empty()) &&
                          !(looks[1][0].empty() && looks[1][1].empty());
    for (const bool within : {false, true}) {
        const auto& [one, both] = looks[within ? 1 : 0];
        if (one.empty() && both.empty()) continue;
        if (is_split) canvas.add(canvas.clip_to(*outline, within));
        if (!both.empty() && !between.steps.empty()) canvas.add(Fill{between, ink_for(both), true});
        if (!one.empty()) canvas.add(Fill{within_rim, ink_for(one), false});
        if (is_split) canvas.add(ClipEnd{});
    }
}

void stroke_track(const Canvas& canvas, const Track& track, const Colour& colour, double opacity,
                  double width_pt) {
    for (const Span& span : canvas.occluders.spans(track, {})) {
        const double shown =
            opacity * (span.cover.clear + (1.0 - span.cover.clear) * span.cover.transmitted);
        if (shown < 1e-3) continue;
        Stroke stroke;
        stroke.path = canvas.path_of(track, span.from, span.to, conic_tolerance_pt);
        const Eigen::Vector3d middle = track.flow(0.5 * (span.from + span.to)).position;
        stroke.ink = as_in_light(colour, shown, canvas.behind(canvas.projection.place(middle)));
        stroke.width_pt = width_pt;
        stroke.round = false;
        canvas.add(std::move(stroke));
    }
}

// The rim of a cone and the two generators along which its surface turns away from the eye, in the
// cone's colour.
void draw_cone_contour(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                       const Conic& rim) {
    const Projection& projection = canvas.projection;
    const Colour colour = contour_colour(cone.colour, canvas.ground(projection.place(cone.apex)));
    const double width_pt = std::max(canvas.line_pt(cone.rim_px), contour_pt);
    stroke_track(canvas, track_of(rim, 0.0, 2.0 * pi), colour, cone.presence, width_pt);
    // The normal at the angle s is cos s first + sin s second - slope axis; on the contour it is
    // perpendicular to the line of sight.
    const Eigen::Vector3d sight = projection.towards_eye(cone.apex);
    const double first = sight.dot(axes.first), second = sight.dot(axes.second);
    const double swing = std::hypot(first, second);
    const double needed = axes.radius / cone.length * sight.dot(axes.axis);
    if (!(std::abs(needed) < swing)) return;  // the eye sees into the cone, or along its axis
    const double middle = std::atan2(second, first), reach = std::acos(needed / swing);
    for (const double angle : {middle - reach, middle + reach}) {
        const Eigen::Vector3d run = rim.at(angle) - cone.apex;
        Track track;
        track.flow = [apex = cone.apex, run](double s) { return CurveFlow{apex + s * run, run}; };
        track.knots = {0.0, 1.0};
        stroke_track(canvas, track, colour, cone.presence, width_pt);
    }
}

}  // namespace

void draw_meshes(const Canvas& canvas) {
    if (canvas.shading == Shading::picture) return;
    const Bodies bodies = canvas.occluders.meshes();
    constexpr std::size_t most_triangles = 20'000;
    for (const MeshSight& body : bodies)
        if (const std::size_t n = body.mesh().geometry->positions.size() / 3; n > most_triangles)
            throw InputError(fmt::format(
                "a body of {} triangles: as vectors at most {} can be drawn; take a simpler "
                "mesh, or --shading picture",
                n, most_triangles));
    fill_bodies(canvas, bodies);
    for (const MeshSight& body : bodies) {
        if (canvas.shading == Shading::none) draw_edges(canvas, body);
        if (canvas.has_fills())
            draw_face_picture(canvas, body, [&](const Eigen::Vector3d& point) {
                return std::any_of(bodies.begin(), bodies.end(), [&](const MeshSight& other) {
                    return covers(other, body) && other.hides(point);
                });
            });
    }
}

std::optional<BodySeen> body_at(const Canvas& canvas, const Eigen::Vector2d& at) {
    std::optional<BodySeen> seen;
    std::vector<MeshSight::Crossing> crossings;
    for (const MeshSight& body : canvas.occluders.meshes()) {
        crossings.clear();
        body.crossings(at, crossings);
        for (const MeshSight::Crossing& there : crossings) {
            if (seen && there.depth >= seen->depth) continue;
            const MeshSight::Triangle& triangle = body.triangles()[there.number];
            const Eigen::Vector3d point =
                canvas.projection.on_plane(at, triangle.corners[0], triangle.normal);
            seen = {lit_colour(canvas, body.mesh(), point, normal_at(triangle, point)),
                    there.depth};
        }
    }
    return seen;
}

void draw_cone(const Canvas& canvas, const Cone& cone) {
    if (!(cone.opacity > 0.0 && cone.presence > 0.0 && cone.length > 0.0)) return;
    const ConeAxes axes(cone);
    const Eigen::Vector3d middle = cone.apex + cone.length * axes.axis;
    const Conic rim{middle, axes.radius * axes.first, axes.radius * axes.second};
    const auto ellipse = picture_of(rim, canvas.projection);
    const Projection& projection = canvas.projection;
    if (!ellipse ||
        (projection.perspective && projection.depth(cone.apex) <= projection.near_depth))
        return;
    if (canvas.shading == Shading::none) {
        draw_cone_contour(canvas, cone, axes, rim);
        return;
    }
    const Eigen::Vector2d apex = projection.place(cone.apex);

    if (canvas.has_fills()) {
        // Rim and apex, and the region between them.
        const Eigen::Vector2d from_rim = ellipse->paper_from_circle().inverse() * apex;
        const double apart = from_rim.norm();
        Path hull;
        if (apart > 1.0) {
            const double towards = std::atan2(from_rim.y(), from_rim.x());
            const double touch = std::acos(1.0 / apart);
            const double from = towards + touch, to = towards + 2.0 * pi - touch;
            hull.add(arc_of(*ellipse, from, to,
                            std::max(2, static_cast<int>(std::ceil((to - from) / 0.7)))));
            hull.line(apex);
            hull.close();
        }
        fill_sheets(canvas, cone, axes, *ellipse, std::move(hull));
    }
    const ConeLines lines = cone_lines();
    const Colour dark = encoded(lines.tone * linear(cone.colour));
    if (cone.rim_px > 0.0)
        stroke_track(canvas, track_of(rim, 0.0, 2.0 * pi), dark, lines.rim_opacity * cone.presence,
                     canvas.line_pt(cone.rim_px));
    for (int k = 0; k < cone.n_rulings; ++k) {
        const double angle = cone.phase_rad + 2.0 * pi * k / cone.n_rulings;
        const Eigen::Vector3d end = rim.at(angle);
        const Eigen::Vector3d run = end - cone.apex;
        // Towards the apex the lines become dense and fade, as on the screen: they end where half
        // the opacity is left.
        constexpr double half_left_px = 9.0;
        const Eigen::Vector3d along_rim =
            std::cos(angle) * rim.sine_axis - std::sin(angle) * rim.cosine_axis;
        const double apart_px =
            spacing_px(projection, end, run, 2.0 * pi / cone.n_rulings * along_rim);
        if (!(apart_px > half_left_px)) continue;
        Track track;
        track.flow = [apex_at = cone.apex, run](double s) {
            return CurveFlow{apex_at + s * run, run};
        };
        track.knots = {half_left_px / apart_px, 1.0};
        stroke_track(canvas, track, dark, lines.generator_opacity * cone.presence,
                     canvas.line_pt(0.6 * cone.rim_px));
    }
}

}  // namespace poinsot::vector
