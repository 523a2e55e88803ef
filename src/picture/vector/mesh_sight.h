// Intersections of lines of sight with a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vector/paper_flow.h"

namespace poinsot::vector {

// The triangles of a mesh on paper, in a grid of cells for fast search by place.
class MeshSight {
 public:
    MeshSight(const Mesh& mesh, const Projection& projection);

    struct Triangle {
        Eigen::Vector3d corners[3];  // view axes
        Eigen::Vector2d paper[3];
        Eigen::Vector3d normal;  // outward normal of the plane; not of unit length
        // The normal of the smooth surface: the mean of the corners' normals; not of unit length.
        Eigen::Vector3d shading_normal;
        Eigen::Vector3d corner_normals[3];  // of the smooth surface; not of unit length
        bool before_eye = true;             // if false, its places on paper are unknown
        std::size_t first = 0;              // of its corners, in the mesh's lists
    };

    // Whether a triangle lies between the point and the eye. Triangles within a millionth of the
    // point's depth count as containing the point and do not hide it.
    bool hides(const Eigen::Vector3d& point) const;

    // The numbers of all triangles at a point of the paper, with their depths there.
    struct Crossing {
        std::uint32_t number = 0;
        double depth = 0.0;
    };
    void crossings(const Eigen::Vector2d& paper, std::vector<Crossing>& found) const;

    const Mesh& mesh() const { return mesh_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
    const std::vector<std::uint32_t>* cell_at(const Eigen::Vector2d& paper) const;
    // The depth at which the line of sight through a point of the paper crosses the triangle's
    // plane; infinite if the line misses the triangle or is parallel to it.
    double depth_at(const Triangle& triangle, const Eigen::Vector2d& paper) const;

    const Mesh& mesh_;
    const Projection& projection_;
    std::vector<Triangle> triangles_;
    Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
    double cell_pt_ = 1.0;
    int n_columns_ = 0, n_rows_ = 0;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace poinsot::vector
