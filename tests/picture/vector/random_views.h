// Views of random ellipsoids and planes, near and far, round and flat.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "shapes/views.h"
#include "vector/occluders.h"

namespace poinsot::vector {

class RandomViews {
 public:
    explicit RandomViews(unsigned seed) : random_(seed) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Eigen::Vector3d direction() {
        std::normal_distribution<double> normal;
        return Eigen::Vector3d(normal(random_), normal(random_), normal(random_)).normalized();
    }
    Eigen::Matrix3d axes() {
        return Eigen::Quaterniond(Eigen::AngleAxisd(between(0.0, 6.0), direction()))
            .toRotationMatrix();
    }

    // A view of 160 × 120 mm. Every third camera is near and every fifth orthographic; every fourth
    // ellipsoid is nearly a disc, every seventh nearly a needle.
    View view(int k) {
        View view;
        view.width_px = 1890;
        view.height_px = 1417;
        Ellipsoid ellipsoid;
        Eigen::Vector3d sizes(between(0.3, 1.0), between(0.3, 1.0), between(0.3, 1.0));
        if (k % 4 == 0) sizes[0] = between(1e-3, 1e-2);
        if (k % 7 == 0) sizes[0] = sizes[1] = between(1e-3, 1e-2);
        ellipsoid.half_axes = axes() * sizes.asDiagonal();
        ellipsoid.centre = 0.2 * direction();
        view.ellipsoids.push_back(ellipsoid);
        Plane plane;
        plane.normal = direction();
        plane.along = plane.normal.unitOrthogonal();
        plane.centre = between(-0.8, 0.8) * plane.normal;
        plane.fade_from = 0.999;
        plane.radius = 1e6;
        view.planes.push_back(plane);
        view.camera.target = 0.1 * direction();
        view.camera.eye =
            view.camera.target + (k % 3 == 0 ? 1.6 : between(3.0, 12.0)) * direction();
        view.camera.vertical_field_rad = k % 3 == 0 ? 1.2 : 0.6;
        view.camera.orthographic = k % 5 == 0;
        view.camera.height_units = 3.0;
        return view;
    }

    Conic conic() {
        Conic conic;
        const Eigen::Matrix3d frame = axes();
        conic.centre = between(0.0, 0.6) * direction();
        conic.cosine_axis = between(0.2, 1.2) * frame.col(0);
        conic.sine_axis = between(0.2, 1.2) * frame.col(1);
        return conic;
    }

 private:
    std::mt19937_64 random_;
};

constexpr double print_pt_per_px = 72.0 / 300.0;
constexpr double um(double pt) { return pt * 25400.0 / 72.0; }

}  // namespace poinsot::vector
