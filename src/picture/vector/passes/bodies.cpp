// Draws bodies made of triangles.
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

}  // namespace poinsot::vector
