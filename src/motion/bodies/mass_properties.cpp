#include "bodies/mass_properties.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot {

namespace {

// Compensated sum. Source: Neumaier, ZAMM 54 (1974) 39.
class CompensatedSum {
 public:
    void add(double x) {
        const double sum = sum_ + x;
        lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
        sum_ = sum;
    }
    double value() const { return sum_ + lost_; }

 private:
    double sum_ = 0.0;
    double lost_ = 0.0;
};

using Corners = std::array<Eigen::Vector3d, 3>;

// Six times the signed volume of the tetrahedron between the origin and a triangle.
double six_volumes(const Corners& p) { return p[0].dot(p[1].cross(p[2])); }

// Moves and scales the mesh to a size of order one. The scale is a power of two, so that scaling
// does not round.
struct Placement {
    Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
    int exponent = 0;
    double scale = 1.0;  // 2^-exponent

    Corners of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) const {
        Corners p;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = scale * (mesh.vertices[triangle[i]] - origin_m);
        }
        return p;
    }
};

Placement middle_of(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) box.extend(mesh.vertices[v]);
    }
    Placement placement;
    placement.origin_m = box.min() + 0.5 * box.sizes();
    std::frexp(box.sizes().maxCoeff(), &placement.exponent);
    placement.exponent = std::max(placement.exponent, -1000);
    placement.scale = std::ldexp(1.0, -placement.exponent);
    return placement;
}

// Volume and first moments about the placement's origin.
struct FirstMoments {
    double six_volumes = 0.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

FirstMoments first_moments(const TriangleMesh& mesh, const Placement& placement) {
    CompensatedSum volume;
    std::array<CompensatedSum, 3> moment;
    for (const auto& t : mesh.triangles) {
        const Corners p = placement.of(mesh, t);
        const double d = six_volumes(p);
        volume.add(d);
        for (int i = 0; i < 3; ++i) moment[i].add(d * (p[0][i] + p[1][i] + p[2][i]));
    }
    FirstMoments result;
    result.six_volumes = volume.value();
    if (result.six_volumes == 0.0) return result;
    for (int i = 0; i < 3; ++i) {
        result.centre[i] = moment[i].value() / (4.0 * result.six_volumes);
    }
    return result;
}

// ∫ x xᵀ dV over a tetrahedron (0, a, b, c) is 6V/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ), s = a + b + c.
Eigen::Matrix3d second_moments(const TriangleMesh& mesh, const Placement& placement,
                               const Eigen::Vector3d& centre) {
    std::array<CompensatedSum, 6> sums;
    for (const auto& t : mesh.triangles) {
        Corners p = placement.of(mesh, t);
        for (Eigen::Vector3d& corner : p) corner -= centre;
        const double d = six_volumes(p);
        const Eigen::Vector3d s = p[0] + p[1] + p[2];
        std::size_t k = 0;
        for (int i = 0; i < 3; ++i) {
            for (int j = i; j < 3; ++j) {
                sums[k++].add(
                    d * (p[0][i] * p[0][j] + p[1][i] * p[1][j] + p[2][i] * p[2][j] + s[i] * s[j]));
            }
        }
    }
    Eigen::Matrix3d moments;
    std::size_t k = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) moments(i, j) = moments(j, i) = sums[k++].value() / 120.0;
    }
    return moments;
}

Eigen::Matrix3d inertia_from_second_moments(const Eigen::Matrix3d& c) {
    // Computing an element as trace minus element would cancel for a thin body.
    Eigen::Matrix3d inertia = -c;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        inertia(i, i) = c(j, j) + c(k, k);
    }
    return inertia;
}

// Sets products and differences of moments to zero where they are only rounding errors.
Eigen::Matrix3d without_rounding(Eigen::Matrix3d inertia) {
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * inertia.trace();
    bool diagonal = true;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (i == j) continue;
            if (std::abs(inertia(i, j)) <= rounding) inertia(i, j) = 0.0;
            diagonal = diagonal && inertia(i, j) == 0.0;
        }
    }
    if (!diagonal) return inertia;
    if (inertia.diagonal().maxCoeff() - inertia.diagonal().minCoeff() <= rounding) {
        inertia.diagonal().setConstant(inertia.diagonal().mean());
        return inertia;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (std::abs(inertia(i, i) - inertia(j, j)) > rounding) continue;
        inertia(i, i) = inertia(j, j) = 0.5 * (inertia(i, i) + inertia(j, j));
    }
    return inertia;
}

}  // namespace

MassProperties mass_properties(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return {};
    const Placement placement = middle_of(mesh);
    const FirstMoments first = first_moments(mesh, placement);
    const Eigen::Matrix3d second = second_moments(mesh, placement, first.centre);

    const auto unscaled = [&](double x, int power) {
        return std::ldexp(x, power * placement.exponent);
    };
    MassProperties result;
    result.volume_m3 = unscaled(first.six_volumes / 6.0, 3);
    result.centre_of_mass_m =
        placement.origin_m + first.centre.unaryExpr([&](double x) { return unscaled(x, 1); });
    result.inertia_unit_density =
        inertia_from_second_moments(second).unaryExpr([&](double x) { return unscaled(x, 5); });
    return result;
}

BodyProperties body_of_parts(std::span<const DensePart> parts) {
    BodyProperties body;
    for (const DensePart& part : parts) {
        const double mass_kg = part.density_kg_m3 * part.shape.volume_m3;
        body.mass_kg += mass_kg;
        body.centre_of_mass_m += mass_kg * part.shape.centre_of_mass_m;
    }
    if (!(body.mass_kg > 0.0)) return {};
    body.centre_of_mass_m /= body.mass_kg;

    for (const DensePart& part : parts) {
        const double mass_kg = part.density_kg_m3 * part.shape.volume_m3;
        const Eigen::Vector3d r = part.shape.centre_of_mass_m - body.centre_of_mass_m;
        body.inertia_kg_m2 += part.density_kg_m3 * part.shape.inertia_unit_density +
                              inertia_from_second_moments(mass_kg * r * r.transpose());
    }
    body.inertia_kg_m2 = without_rounding(body.inertia_kg_m2);
    return body;
}

}  // namespace poinsot
