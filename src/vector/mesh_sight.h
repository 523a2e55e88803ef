// A mesh as lines of sight meet it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vector/paper_flow.h"

namespace poinsot::vector {

// The triangles of a mesh on paper, in cells, so that those at a place are found at once.
class MeshSight {
 public:
    MeshSight(const Mesh& mesh, const Projection& projection);

    struct Triangle {
        Eigen::Vector3d corners[3];  // view axes
        Eigen::Vector2d paper[3];
        Eigen::Vector3d normal;  // outward, of the plane; not of unit length
        // Of the surface that it stands for: the mean of its corners'; likewise.
        Eigen::Vector3d shading_normal;
        bool before_eye = true;  // else none of its places on paper is known
        std::size_t first = 0;   // of its corners, in the mesh's lists
    };

    // Whether a triangle lies between the point and the eye. One that the point lies on does not:
    // what is nearer to it than a millionth of its depth counts as that.
    bool hides(const Eigen::Vector3d& point) const;

    // Numbers of all its triangles at a place of the paper, with their depths there.
    struct Crossing {
        std::uint32_t number = 0;
        double depth = 0.0;
    };
    void crossings(const Eigen::Vector2d& paper, std::vector<Crossing>& found) const;

    const Mesh& mesh() const { return mesh_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
    const std::vector<std::uint32_t>* cell_at(const Eigen::Vector2d& paper) const;
    // The depth at which the line of sight of a place of the paper crosses a triangle's plane;
    // infinite if it lies beside the triangle or along it.
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
