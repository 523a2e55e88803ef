// Draws pictures on faces: the lit face with its picture in perspective, in pixels of 300 per inch.
#include "vector/passes/face_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace poinsot::vector {

namespace {

constexpr double px_per_pt = 300.0 / 72.0;
// Samples per side of a pixel.
constexpr int fewest_looks = 2, most_looks = 8;

// A triangle that faces the eye, with its texture coordinates.
struct SeenTriangle {
    const MeshSight::Triangle* triangle = nullptr;
    Eigen::Vector2d places[3];

    bool covers(const Eigen::Vector2d& at) const {
        const auto& p = triangle->paper;
        const double a = cross(p[1] - p[0], at - p[0]), b = cross(p[2] - p[1], at - p[1]),
                     c = cross(p[0] - p[2], at - p[2]);
        return (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
    }
    // The texture coordinates of a point of the triangle's plane.
    Eigen::Vector2d place(const Eigen::Vector3d& point) const {
        const auto& c = triangle->corners;
        const Eigen::Vector3d& n = triangle->normal;
        const double whole = n.squaredNorm();
        const double first = n.dot((c[1] - point).cross(c[2] - point)) / whole;
        const double second = n.dot((c[2] - point).cross(c[0] - point)) / whole;
        return first * places[0] + second * places[1] + (1.0 - first - second) * places[2];
    }
};

std::vector<SeenTriangle> seen_triangles(const Canvas& canvas, const MeshSight& body) {
    std::vector<SeenTriangle> seen;
    for (const MeshSight::Triangle& triangle : body.triangles()) {
        if (triangle.normal.dot(canvas.projection.towards_eye(triangle.corners[0])) <= 0.0)
            continue;
        SeenTriangle& one = seen.emplace_back();
        one.triangle = &triangle;
        for (std::size_t k = 0; k < 3; ++k)
            one.places[k] = body.mesh().geometry->places[triangle.first + k].cast<double>();
    }
    return seen;
}

Colour colour_at(const SurfacePicture& picture, const Eigen::Vector2d& place) {
    const auto step = [](double at, int n) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(at * n), 0, n - 1));
    };
    const std::size_t column = step(place.x(), picture.width_px);
    const std::size_t row = step(place.y(), picture.height_px);
    const std::uint8_t* rgb =
        picture.rgb.data() + 3 * (row * static_cast<std::size_t>(picture.width_px) + column);
    return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
}

std::uint8_t byte_of(double part) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
}

// The light of a visible sample of a face, and its position in the pixel.
struct Look {
    Eigen::Vector3d light = Eigen::Vector3d::Zero();
    int n_seen = 0;
};

void look_at(const Canvas& canvas, const SurfacePicture& picture,
             const std::vector<SeenTriangle>& seen, const IsHidden& is_hidden,
             const Eigen::Vector2d& at, Look& look) {
    const auto found = std::find_if(seen.begin(), seen.end(),
                                    [&at](const SeenTriangle& one) { return one.covers(at); });
    if (found == seen.end()) return;
    const MeshSight::Triangle& triangle = *found->triangle;
    const Eigen::Vector3d point =
        canvas.projection.on_plane(at, triangle.corners[0], triangle.normal);
    if (is_hidden(point)) return;
    const Eigen::Vector3d to_eye = canvas.projection.towards_eye(point).normalized();
    look.light += mesh_surface(colour_at(picture, found->place(point)), canvas.lights,
                               {triangle.shading_normal.normalized(), to_eye});
    ++look.n_seen;
}

}  // namespace

void draw_face_picture(const Canvas& canvas, const MeshSight& body, const IsHidden& is_hidden) {
    const Mesh& mesh = body.mesh();
    const SurfacePicture& picture = mesh.geometry->picture;
    if (picture.rgb.empty() || mesh.geometry->places.size() != mesh.geometry->positions.size())
        return;
    const std::vector<SeenTriangle> seen = seen_triangles(canvas, body);
    if (seen.empty()) return;
    Eigen::Vector2d low(1e300, 1e300), high(-1e300, -1e300);
    for (const SeenTriangle& one : seen)
        for (const Eigen::Vector2d& corner : one.triangle->paper) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    // Parts outside the view are not drawn.
    low = low.cwiseMax(canvas.projection.corner);
    high = high.cwiseMin(canvas.projection.corner + canvas.projection.size);
    if (!(low.x() < high.x() && low.y() < high.y())) return;

    Picture drawn;
    drawn.corner_pt = low;
    drawn.raster.width = static_cast<int>(std::ceil((high.x() - low.x()) * px_per_pt));
    drawn.raster.height = static_cast<int>(std::ceil((high.y() - low.y()) * px_per_pt));
    drawn.size_pt = Eigen::Vector2d(drawn.raster.width, drawn.raster.height) / px_per_pt;
    const double finer = std::max(picture.width_px, picture.height_px) /
                         static_cast<double>(std::max(drawn.raster.width, drawn.raster.height));
    const int n_looks = std::clamp(static_cast<int>(std::ceil(finer)), fewest_looks, most_looks);
    drawn.raster.rgba.reserve(4 * static_cast<std::size_t>(drawn.raster.width) *
                              static_cast<std::size_t>(drawn.raster.height));
    for (int y = 0; y < drawn.raster.height; ++y)
        for (int x = 0; x < drawn.raster.width; ++x) {
            Look look;
            for (int j = 0; j < n_looks; ++j)
                for (int i = 0; i < n_looks; ++i) {
                    const Eigen::Vector2d in_pixel((i + 0.5) / n_looks, (j + 0.5) / n_looks);
                    look_at(canvas, picture, seen, is_hidden,
                            low + (Eigen::Vector2d(x, y) + in_pixel) / px_per_pt, look);
                }
            const Colour colour =
                look.n_seen > 0 ? encoded(Eigen::Vector3d(look.light / look.n_seen)) : Colour{};
            const double part = mesh.opacity * look.n_seen / (n_looks * n_looks);
            for (const double value : {colour.r, colour.g, colour.b, part})
                drawn.raster.rgba.push_back(byte_of(value));
        }
    canvas.add(std::move(drawn));
}

}  // namespace poinsot::vector
