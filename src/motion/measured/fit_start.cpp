#include "measured/fit_start.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/small_solvers.h"

namespace poinsot {

namespace {

using Tensor = Eigen::Matrix3d;

// f of the eigenvalues of a symmetric tensor.
template <typename Function>
Tensor mapped(const Tensor& tensor, Function f) {
    const auto [values, vectors] = eigenpairs_of(tensor);
    const Tensor made = vectors * values.unaryExpr(f).asDiagonal() * vectors.transpose();
    return 0.5 * (made + made.transpose());  // symmetric to the last bit
}

// The time that a free motion takes for what the damped one does in t, over it: (1 − e^(−γt))/(γt).
double slowed(double damping, double t) {
    const double x = damping * t;
    return std::abs(x) < 1e-12 ? 1.0 : -std::expm1(-x) / x;
}

// The six elements of a symmetric tensor.
constexpr std::array<std::array<int, 2>, 6> places{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
using Elements = Eigen::Matrix<double, 6, 1>;
using Normal = Eigen::Matrix<double, 6, 6>;

// Euler's equations, integrated over windows of this angle: J(ω_b − ω_a) + ∫ ω × Jω dt = 0 is
// linear in J. With damping, the same holds for e^(γt) ω in the time (1 − e^(−γt))/γ. Returns the
// matrix of the sum of squares of what is left, as a form in the elements of J; zero for rows too
// short.
Normal normal_of(std::span<const MeasuredRow> rows, double damping, double window_rad) {
    using Row = Eigen::Matrix<double, 3, 6>;
    std::array<Tensor, 6> basis;
    for (std::size_t k = 0; k < 6; ++k) {
        basis[k].setZero();
        basis[k](places[k][0], places[k][1]) = basis[k](places[k][1], places[k][0]) = 1.0;
    }
    const double start = rows.front().time_s;
    std::vector<Row> sums(rows.size(), Row::Zero()), ends(rows.size());
    std::vector<double> times(rows.size());
    Row before = Row::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double t = rows[i].time_s - start;
        times[i] = t * slowed(damping, t);
        const Eigen::Vector3d omega = std::exp(damping * t) * rows[i].omega_body;
        Row turning;
        for (int k = 0; k < 6; ++k) {
            const Eigen::Vector3d momentum = basis[static_cast<std::size_t>(k)] * omega;
            ends[i].col(k) = momentum;
            turning.col(k) = omega.cross(momentum);
        }
        if (i > 0) sums[i] = sums[i - 1] + 0.5 * (times[i] - times[i - 1]) * (turning + before);
        before = turning;
    }
    const double window = window_rad;
    Normal normal = Normal::Zero();
    std::size_t b = 0;
    for (std::size_t a = 0; a < rows.size(); ++a) {
        while (b < rows.size() && times[b] - times[a] < window) ++b;
        if (b == rows.size()) break;
        const Row row = ends[b] - ends[a] + sums[b] - sums[a];
        normal += row.transpose() * row;
    }
    return normal;
}

// The tensor with the least rest, and this rest as a share.
std::pair<Tensor, double> first_tensor(const Normal& normal) {
    // Rows too short for a window say nothing.
    if (normal.isZero(0.0)) return {Tensor::Identity(), std::numeric_limits<double>::infinity()};
    const auto [values, vectors] = eigenpairs_of(normal);
    Tensor tensor;
    for (int k = 0; k < 6; ++k) {
        const auto [i, j] = places[static_cast<std::size_t>(k)];
        tensor(i, j) = tensor(j, i) = vectors(k, 0);
    }
    if (tensor.trace() < 0.0) tensor = -tensor;
    const double largest = eigenpairs_of(tensor).values.maxCoeff();
    // Noise may make a moment negative.
    tensor = mapped(tensor / largest, [](double x) { return std::max(x, 0.05); });
    return {tensor, values[0] / std::max(normal.trace(), 1e-300)};
}

// That of these dampings which Euler's equations hold best with, for windows of this angle. Each is
// given by γ times the span of the rows.
constexpr std::array<double, 6> losses{0.0, 0.1, 0.3, 1.0, 2.0, 4.0};
struct FirstTensor {
    Tensor tensor = Tensor::Identity();
    double damping = 0.0;
    double rest = std::numeric_limits<double>::infinity();
};
FirstTensor tensor_of(std::span<const MeasuredRow> rows, double window_rad,
                      std::span<const double> tried) {
    const double span = rows.back().time_s - rows.front().time_s;
    FirstTensor best;
    for (const double loss : tried) {
        const auto [tensor, rest] = first_tensor(normal_of(rows, loss / span, window_rad));
        if (rest < best.rest) best = {tensor, loss / span, rest};
    }
    return best;
}

Flight flight_of(const Eigen::Vector3d& moments, const Eigen::Matrix3d& axes, double damping,
                 std::span<const MeasuredRow> rows) {
    Flight flight;
    flight.moments = moments / moments[0];
    flight.axes = axes;
    if (axes.determinant() < 0.0) flight.axes.col(2) *= -1.0;
    flight.omega = rows.front().omega_body;
    flight.drag_rates.setConstant(damping);
    return flight;
}

}  // namespace

std::vector<Flight> first_flights(std::span<const MeasuredRow> rows,
                                  const std::optional<Eigen::Vector3d>& moments) {
    std::vector<Flight> flights;
    std::vector<std::pair<double, Flight>> ordered;
    for (const double window_rad : {1.0, 0.5, 2.0, 4.0}) {
        const FirstTensor first = tensor_of(rows, window_rad, losses);
        const Eigenpairs eigen = eigenpairs_of(first.tensor);
        const Eigen::Matrix3d axes = eigen.vectors.rowwise().reverse();
        if (!moments) {
            flights.push_back(flight_of(eigen.values.reverse(), axes, first.damping, rows));
            continue;
        }
        // Noise may have put the axes into another order.
        const Normal normal = normal_of(rows, first.damping, window_rad);
        std::array<int, 3> order{0, 1, 2};
        do {
            Eigen::Matrix3d permuted;
            for (int k = 0; k < 3; ++k)
                permuted.col(k) = axes.col(order[static_cast<std::size_t>(k)]);
            const Tensor tensor = permuted * moments->asDiagonal() * permuted.transpose();
            Elements elements;
            for (int k = 0; k < 6; ++k) {
                const auto& place = places[static_cast<std::size_t>(k)];
                elements[k] = tensor(place[0], place[1]);
            }
            const double rest = elements.dot(normal * elements) /
                                std::max(normal.trace() * elements.squaredNorm(), 1e-300);
            ordered.emplace_back(rest, flight_of(*moments, permuted, first.damping, rows));
        } while (std::next_permutation(order.begin(), order.end()));
    }
    // Noise may also make the wrong damping look best.
    if (!moments)
        for (const double& loss : losses) {
            const FirstTensor first = tensor_of(rows, 1.0, std::span(&loss, 1));
            const Eigenpairs eigen = eigenpairs_of(first.tensor);
            flights.push_back(flight_of(eigen.values.reverse(), eigen.vectors.rowwise().reverse(),
                                        first.damping, rows));
        }
    constexpr std::size_t most = 6;
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < std::min(most, ordered.size()); ++i)
        flights.push_back(ordered[i].second);
    return flights;
}

std::vector<Flight> physical_flights(std::span<const MeasuredRow> rows) {
    Tensor squares = Tensor::Zero();
    for (const MeasuredRow& row : rows) squares += row.omega_body * row.omega_body.transpose();
    const Eigen::Matrix3d axes = eigenpairs_of(squares).vectors;
    // A slab, a rod and a disc.
    const Eigen::Vector3d bodies[] = {{1.0, 0.8, 0.3}, {1.0, 0.9, 0.2}, {1.0, 0.6, 0.5}};
    std::vector<Flight> flights;
    std::array<int, 3> order{0, 1, 2};
    do {
        const Eigen::Matrix3d permuted = axes(Eigen::all, order);
        for (const Eigen::Vector3d& moments : bodies)
            flights.push_back(flight_of(moments, permuted, 0.0, rows));
    } while (std::next_permutation(order.begin(), order.end()));
    return flights;
}

double unexplained_share(std::span<const MeasuredRow> rows) {
    constexpr double window_rad = 0.7;
    std::vector<Eigen::Matrix<double, 3, 6>> sums(rows.size()), momenta(rows.size());
    std::vector<double> angles(rows.size(), 0.0);
    Eigen::Matrix<double, 3, 6> before = Eigen::Matrix<double, 3, 6>::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Eigen::Vector3d& w = rows[i].omega_body;
        momenta[i] << w[0], 0.0, 0.0, 0.0, w[2], w[1], 0.0, w[1], 0.0, w[2], 0.0, w[0], 0.0, 0.0,
            w[2], w[1], w[0], 0.0;
        Eigen::Matrix<double, 3, 6> turning;
        for (int k = 0; k < 6; ++k) turning.col(k) = w.cross(momenta[i].col(k));
        sums[i].setZero();
        if (i > 0) {
            const double step_s = rows[i].time_s - rows[i - 1].time_s;
            sums[i] = sums[i - 1] + 0.5 * step_s * (turning + before);
            angles[i] = angles[i - 1] + 0.5 * step_s * (w.norm() + rows[i - 1].omega_body.norm());
        }
        before = turning;
    }
    Normal rest = Normal::Zero(), whole = Normal::Zero();
    std::size_t b = 0;
    for (std::size_t a = 0; a < rows.size(); ++a) {
        while (b < rows.size() && angles[b] - angles[a] < window_rad) ++b;
        if (b == rows.size()) break;
        const Eigen::Matrix<double, 3, 6> change = momenta[b] - momenta[a];
        const Eigen::Matrix<double, 3, 6> row = change + sums[b] - sums[a];
        rest += row.transpose() * row;
        whole += change.transpose() * change;
    }
    if (rest.isZero(0.0)) return 1.0;
    const Elements tensor = eigenpairs_of(rest).vectors.col(0);
    const double changes = tensor.dot(whole * tensor);
    return changes > 0.0 ? std::sqrt(std::max(tensor.dot(rest * tensor), 0.0) / changes) : 1.0;
}

}  // namespace poinsot
