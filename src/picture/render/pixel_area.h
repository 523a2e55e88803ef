// The pixels that a shape may cover: x right, y down, pixel centres at half-integers.
#pragma once

#include <Eigen/Core>
#include <array>
#include <glm/vec2.hpp>
#include <span>

#include "shapes/pixel_box.h"
#include "shapes/projection.h"

namespace poinsot {

// A convex polygon in pixels, drawn as a triangle fan.
struct PixelPolygon {
    static constexpr int most_corners = 16;
    std::array<glm::vec2, most_corners> corners;
    int n_corners = 0;
    PixelBox box;
    void add(const Eigen::Vector2d& corner);
    std::span<const glm::vec2> added() const {
        return std::span(corners).first(static_cast<std::size_t>(n_corners));
    }
};

PixelPolygon polygon_of(const PixelBox& box);

// The bounding box of a sphere in the picture; the whole view if the sphere extends behind the eye.
PixelBox ball_box(const Projection& projection, const Eigen::Vector3d& centre, double radius);

// Coordinates on a plane as a homogeneous linear map of (x, y, 1), (x, y) = pixel - anchor_px:
// along and across, divided by the third component, which is positive where the plane is in front
// of the eye.
struct PlaneMap {
    Eigen::Vector2d anchor_px;
    Eigen::Matrix3d plane_from_pixel;
    bool edge_on = false;  // the plane is seen as a line: nothing to draw
};

// A polygon around a disc in the picture; the whole view if the disc extends behind the eye.
PixelPolygon disc_polygon(const Projection& projection, const Eigen::Vector3d& centre,
                          const Eigen::Vector3d& along, const Eigen::Vector3d& across,
                          double radius);

PlaneMap map_of(const Projection& projection, const Eigen::Vector3d& centre,
                const Eigen::Vector3d& along, const Eigen::Vector3d& across);

}  // namespace poinsot
