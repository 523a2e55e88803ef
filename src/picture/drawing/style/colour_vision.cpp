#include "drawing/style/colour_vision.h"

#include <algorithm>
#include <cmath>

#include "numerics/srgb.h"

namespace poinsot {

namespace {

Eigen::Vector3d linear(const Colour& colour) {
    return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b)};
}

const Eigen::Matrix3d& xyz_from_linear() {
    static const Eigen::Matrix3d matrix{{0.4124564, 0.3575761, 0.1804375},
                                        {0.2126729, 0.7151522, 0.0721750},
                                        {0.0193339, 0.1191920, 0.9503041}};
    return matrix;
}

Eigen::Vector3d lab_of_light(const Eigen::Vector3d& light) {
    const Eigen::Vector3d white = xyz_from_linear().rowwise().sum();
    const Eigen::Vector3d xyz =
        (xyz_from_linear() * light.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    return {116.0 * f(xyz.y()) - 16.0, 500.0 * (f(xyz.x()) - f(xyz.y())),
            200.0 * (f(xyz.y()) - f(xyz.z()))};
}

// The difference along L*, a*, b* that half of all people notice (Stone, Szafir & Setlur 2014).
Eigen::Vector3d noticed() {
    constexpr double half = 0.5;
    constexpr double width_deg = 4.0 / 1080.0 * 20.0;
    return half *
           (Eigen::Vector3d(10.16, 10.68, 10.70) + Eigen::Vector3d(1.50, 3.08, 5.74) / width_deg);
}

}  // namespace

double relative_luminance(const Colour& colour) {
    return xyz_from_linear().row(1).dot(linear(colour));
}

double contrast(const Colour& a, const Colour& b) {
    const auto [dim, bright] = std::minmax({relative_luminance(a), relative_luminance(b)});
    return (bright + 0.05) / (dim + 0.05);
}

Eigen::Vector3d lab(const Colour& colour) { return lab_of_light(linear(colour)); }

const std::array<Vision, 4>& visions() {
    static const std::array<Vision, 4> all{{
        {"", Eigen::Matrix3d::Identity()},
        {" to an eye without red (protanopia)", Eigen::Matrix3d{{0.152286, 1.052583, -0.204868},
                                                                {0.114503, 0.786281, 0.099216},
                                                                {-0.003882, -0.048116, 1.051998}}},
        {" to an eye without green (deuteranopia)",
         Eigen::Matrix3d{{0.367322, 0.860646, -0.227968},
                         {0.280085, 0.672501, 0.047413},
                         {-0.011820, 0.042940, 0.968881}}},
        {" to an eye without blue (tritanopia)", Eigen::Matrix3d{{1.255528, -0.076749, -0.178779},
                                                                 {-0.078411, 0.930809, 0.147602},
                                                                 {0.004733, 0.691367, 0.303900}}},
    }};
    return all;
}

double line_difference(const Colour& a, const Colour& b, const Vision& vision) {
    const Eigen::Vector3d apart = lab_of_light(vision.seen_from_linear * linear(a)) -
                                  lab_of_light(vision.seen_from_linear * linear(b));
    return apart.cwiseQuotient(noticed()).norm();
}

double grey_difference(const Colour& a, const Colour& b) {
    return std::abs(lab(a).x() - lab(b).x()) / noticed().x();
}

}  // namespace poinsot
