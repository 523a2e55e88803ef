#include "vector/mesh_sight.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::vector {

namespace {

bool holds(const MeshSight::Triangle& t, const Eigen::Vector2d& at) {
    const double a = cross(t.paper[1] - t.paper[0], at - t.paper[0]);
    const double b = cross(t.paper[2] - t.paper[1], at - t.paper[1]);
    const double c = cross(t.paper[0] - t.paper[2], at - t.paper[2]);
    return (a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0);
}

}  // namespace

MeshSight::MeshSight(const Mesh& mesh, const Projection& projection)
    : mesh_(mesh), projection_(projection) {
    const auto& positions = mesh.geometry->positions;
    Eigen::Vector2d low(1e300, 1e300), high(-1e300, -1e300);
    const Eigen::Matrix3d turned = mesh.placement.linear().inverse().transpose();
    for (std::size_t k = 0; k + 2 < positions.size(); k += 3) {
        Triangle triangle;
        triangle.first = k;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.corners[i] = mesh.placement * positions[k + i].cast<double>();
            triangle.before_eye = triangle.before_eye &&
                                  (!projection.perspective ||
                                   projection.depth(triangle.corners[i]) > projection.near_depth);
        }
        triangle.normal = (triangle.corners[1] - triangle.corners[0])
                              .cross(triangle.corners[2] - triangle.corners[0]);
        const auto& normals = mesh.geometry->normals;
        triangle.shading_normal = triangle.normal;
        for (std::size_t i = 0; i < 3; ++i) {
            const bool has_one = k + i < normals.size() && normals[k + i].norm() > 1e-6f;
            triangle.corner_normals[i] =
                has_one ? (turned * normals[k + i].cast<double>()).eval() : triangle.normal;
        }
        if (k + 2 < normals.size()) {
            const Eigen::Vector3f mean = normals[k] + normals[k + 1] + normals[k + 2];
            if (mean.norm() > 1e-6f) triangle.shading_normal = turned * mean.cast<double>();
        }
        if (!triangle.before_eye) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.paper[i] = projection.place(triangle.corners[i]);
            low = low.cwiseMin(triangle.paper[i]);
            high = high.cwiseMax(triangle.paper[i]);
        }
        triangles_.push_back(triangle);
    }
    if (triangles_.empty()) return;
    // About one triangle per cell.
    constexpr double most_cells = 4e6;
    const double n_cells = std::clamp(static_cast<double>(triangles_.size()), 16.0, most_cells);
    const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
    cell_pt_ = std::max(std::sqrt(size.x() * size.y() / n_cells), size.maxCoeff() / n_cells);
    corner_ = low;
    n_columns_ = static_cast<int>(size.x() / cell_pt_) + 1;
    n_rows_ = static_cast<int>(size.y() / cell_pt_) + 1;
    cells_.resize(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_));
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
        const Triangle& t = triangles_[k];
        const auto column = [&](double x) {
            return std::clamp(static_cast<int>((x - low.x()) / cell_pt_), 0, n_columns_ - 1);
        };
        const auto row = [&](double y) {
            return std::clamp(static_cast<int>((y - low.y()) / cell_pt_), 0, n_rows_ - 1);
        };
        const auto [x0, x1] = std::minmax({t.paper[0].x(), t.paper[1].x(), t.paper[2].x()});
        const auto [y0, y1] = std::minmax({t.paper[0].y(), t.paper[1].y(), t.paper[2].y()});
        for (int j = row(y0); j <= row(y1); ++j)
            for (int i = column(x0); i <= column(x1); ++i)
                cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(n_columns_) +
                       static_cast<std::size_t>(i)]
                    .push_back(static_cast<std::uint32_t>(k));
    }
}

const std::vector<std::uint32_t>* MeshSight::cell_at(const Eigen::Vector2d& paper) const {
    const Eigen::Vector2d in = (paper - corner_) / cell_pt_;
    if (!(in.x() >= 0.0 && in.y() >= 0.0 && in.x() < n_columns_ && in.y() < n_rows_))
        return nullptr;
    return &cells_[static_cast<std::size_t>(in.y()) * static_cast<std::size_t>(n_columns_) +
                   static_cast<std::size_t>(in.x())];
}

double MeshSight::depth_at(const Triangle& t, const Eigen::Vector2d& paper) const {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    if (!holds(t, paper)) return nowhere;
    const Eigen::Vector3d origin = projection_.ray_origin(paper), ray = projection_.ray(paper);
    const double descent = t.normal.dot(ray);
    if (descent == 0.0) return nowhere;
    const double there = t.normal.dot(t.corners[0] - origin) / descent;
    // The component of the ray along the view's axis is 1, so its parameter is the depth.
    return projection_.perspective ? there : projection_.depth(origin + there * ray);
}

bool MeshSight::hides(const Eigen::Vector3d& point) const {
    if (cells_.empty()) return false;
    const double depth = projection_.depth(point);
    if (projection_.perspective && depth <= projection_.near_depth) return false;
    const Eigen::Vector2d at = projection_.place(point);
    const auto* cell = cell_at(at);
    if (cell == nullptr) return false;
    const double touching = 1e-6 * (projection_.perspective ? depth : 1.0);
    return std::any_of(cell->begin(), cell->end(), [&](std::uint32_t k) {
        return depth_at(triangles_[k], at) < depth - touching;
    });
}

void MeshSight::crossings(const Eigen::Vector2d& paper, std::vector<Crossing>& found) const {
    const auto* cell = cells_.empty() ? nullptr : cell_at(paper);
    if (cell == nullptr) return;
    for (const std::uint32_t k : *cell)
        if (const double depth = depth_at(triangles_[k], paper); std::isfinite(depth))
            found.push_back({k, depth});
}

}  // namespace poinsot::vector
