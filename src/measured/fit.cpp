#include "measured/fit.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>
#include <vector>

#include "error/error.h"
#include "measured/table_faults.h"
#include "mechanics/free/free_rotation.h"

namespace poinsot {

namespace {

constexpr std::size_t most_rows = 20'000;
constexpr std::size_t least_rows = 30;
constexpr double most_turn_rad = 0.5;  // from row to row

// What is fitted: the values of a family of tensors, then ω at the first instant, then the damping.
using Parameters = Eigen::VectorXd;
constexpr int n_besides_tensor = 4;
Eigen::Vector3d omega_in(const Parameters& p) { return p.tail<n_besides_tensor>().head<3>(); }
double damping_in(const Parameters& p) { return p[p.size() - 1]; }

using Tensor = Eigen::Matrix3d;
const std::array<Tensor, 5>& shapes() {
    static const std::array<Tensor, 5> all = [] {
        std::array<Tensor, 5> made;
        const double half = std::sqrt(0.5);
        made[0] = Eigen::Vector3d(half, -half, 0.0).asDiagonal();
        made[1] = Eigen::Vector3d(1.0, 1.0, -2.0).asDiagonal();
        made[1] /= std::sqrt(6.0);
        for (int k = 0; k < 3; ++k) {
            Tensor& off = made[2U + static_cast<std::size_t>(k)];
            off.setZero();
            off((k + 1) % 3, (k + 2) % 3) = off((k + 2) % 3, (k + 1) % 3) = half;
        }
        return made;
    }();
    return all;
}

// f of the eigenvalues of a symmetric tensor.
template <typename Function>
Tensor mapped(const Tensor& tensor, Function f) {
    const Eigen::SelfAdjointEigenSolver<Tensor> eigen(tensor);
    const Tensor made = eigen.eigenvectors() * eigen.eigenvalues().unaryExpr(f).asDiagonal() *
                        eigen.eigenvectors().transpose();
    return 0.5 * (made + made.transpose());  // symmetric to the last bit
}

// The tensors among which one is fitted. Without known moments these are five components of the
// logarithm of the tensor, which has no trace, so that every value is a positive tensor of
// determinant 1. With known moments these are turns about principal axes, from a first guess of
// them; a turn about the axis of two equal moments changes nothing and is left out.
class Family {
 public:
    Family() = default;
    // Precondition: moments in falling order.
    Family(const Eigen::Vector3d& moments, const Eigen::Matrix3d& first_axes)
        : moments_(moments), first_axes_(first_axes) {
        for (int k = 0; k < 3; ++k)
            if (moments[(k + 1) % 3] != moments[(k + 2) % 3]) turned_.push_back(k);
    }

    bool has_moments() const { return moments_.has_value(); }
    const Eigen::Vector3d& moments() const { return *moments_; }
    int n_of_tensor() const { return moments_ ? static_cast<int>(turned_.size()) : 5; }
    int n_parameters() const { return n_of_tensor() + n_besides_tensor; }

    // Precondition: the moments are known.
    Eigen::Matrix3d axes(const Parameters& p) const {
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < turned_.size(); ++k)
            turn[turned_[k]] = p[static_cast<Eigen::Index>(k)];
        const double angle = turn.norm();
        if (!(angle > 0.0)) return first_axes_;
        return first_axes_ * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    }

    Tensor tensor(const Parameters& p) const {
        if (moments_) {
            const Eigen::Matrix3d turned = axes(p);
            const Tensor made = turned * moments_->asDiagonal() * turned.transpose();
            return 0.5 * (made + made.transpose());
        }
        Tensor logarithm = Tensor::Zero();
        for (int k = 0; k < 5; ++k) logarithm += p[k] * shapes()[static_cast<std::size_t>(k)];
        return mapped(logarithm, [](double x) { return std::exp(x); });
    }

    // The parameters of a tensor; with known moments those of the first axes.
    Parameters parameters(const Tensor& tensor, const Eigen::Vector3d& omega,
                          double damping) const {
        Parameters p = Parameters::Zero(n_parameters());
        if (!moments_) {
            const Tensor logarithm = mapped(tensor, [](double x) { return std::log(x); });
            for (int k = 0; k < 5; ++k)
                p[k] = logarithm.cwiseProduct(shapes()[static_cast<std::size_t>(k)]).sum();
        }
        p.tail<n_besides_tensor>() << omega, damping;
        return p;
    }

 private:
    std::optional<Eigen::Vector3d> moments_;
    Eigen::Matrix3d first_axes_ = Eigen::Matrix3d::Identity();
    std::vector<int> turned_;  // the axes about which a turn changes the tensor
};

// The time that a free motion takes for what the damped one does in t, over it: (1 − e^(−γt))/(γt).
double slowed(double damping, double t) {
    const double x = damping * t;
    return std::abs(x) < 1e-12 ? 1.0 : -std::expm1(-x) / x;
}

// The damped motion of some parameters.
class Model {
 public:
    Model(const Family& family, const Parameters& p)
        : free_(InertiaTensor::from_matrix(family.tensor(p), Physicality::waived),
                RotationState{0.0, Eigen::Quaterniond::Identity(), omega_in(p)}),
          damping_(damping_in(p)) {}

    // `t`: since the first row.
    Eigen::Vector3d omega(double t) const {
        const Quantities omega_alone{.attitude = false};
        return std::exp(-damping_ * t) *
               free_.sample(t * slowed(damping_, t), omega_alone).state.omega_body;
    }

 private:
    FreeRotation free_;
    double damping_;
};

// Model less measurement, three components a row.
struct Residuals {
    std::span<const MeasuredRow> rows;
    const Family* family;

    Eigen::Index n_values() const { return static_cast<Eigen::Index>(3 * rows.size()); }

    Eigen::VectorXd at(const Parameters& p) const {
        Eigen::VectorXd out(n_values());
        const Model model(*family, p);
        for (std::size_t i = 0; i < rows.size(); ++i)
            out.segment<3>(static_cast<Eigen::Index>(3 * i)) =
                model.omega(rows[i].time_s - rows.front().time_s) - rows[i].omega_body;
        return out;
    }
    // Central differences: the model is smooth, and exact to rounding.
    Eigen::MatrixXd jacobian_at(const Parameters& p) const {
        Eigen::MatrixXd jacobian(n_values(), p.size());
        const double rate = omega_in(p).norm();
        const int n_of_tensor = family->n_of_tensor();
        for (int k = 0; k < p.size(); ++k) {
            const double step = 1e-6 * (k < n_of_tensor       ? 1.0
                                        : k < n_of_tensor + 3 ? rate
                                                              : 1.0 / span_s());
            Parameters above = p, below = p;
            above[k] += step;
            below[k] -= step;
            jacobian.col(k) = (at(above) - at(below)) / (2.0 * step);
        }
        return jacobian;
    }
    double span_s() const { return rows.back().time_s - rows.front().time_s; }
};

double rate_of(std::span<const MeasuredRow> rows) {
    double sum = 0.0;
    for (const MeasuredRow& row : rows) sum += row.omega_body.squaredNorm();
    return std::sqrt(sum / static_cast<double>(rows.size()));
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
    const double window = window_rad / rate_of(rows);
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
    const Eigen::SelfAdjointEigenSolver<Normal> eigen(normal);
    Tensor tensor;
    for (int k = 0; k < 6; ++k) {
        const auto [i, j] = places[static_cast<std::size_t>(k)];
        tensor(i, j) = tensor(j, i) = eigen.eigenvectors()(k, 0);
    }
    if (tensor.trace() < 0.0) tensor = -tensor;
    const double largest = Eigen::SelfAdjointEigenSolver<Tensor>(tensor).eigenvalues().maxCoeff();
    // Noise may make a moment negative.
    tensor = mapped(tensor / largest, [](double x) { return std::max(x, 0.05); });
    return {tensor, eigen.eigenvalues()[0] / std::max(normal.trace(), 1e-300)};
}

// As Eigen's Levenberg–Marquardt method, which is MINPACK's, wants them.
struct LeastSquares {
    using Scalar = double;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;

    Residuals residuals;

    int inputs() const { return residuals.family->n_parameters(); }
    int values() const { return static_cast<int>(residuals.n_values()); }
    int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& out) const {
        // Beyond moments of 1 : 5e-6, exponentials lose their digits. More than half a turn about
        // an axis is a turn the other way.
        constexpr double far_off = 1e9, most_logarithm = 10.0;
        if (p.allFinite() &&
            p.head(p.size() - n_besides_tensor).cwiseAbs().maxCoeff() < most_logarithm)
            out = residuals.at(p);
        else
            out.setConstant(far_off);
        return 0;
    }
    int df(const Eigen::VectorXd& p, Eigen::MatrixXd& jacobian) const {
        jacobian = residuals.jacobian_at(p);
        return 0;
    }
};

// Least squares over the first rows, then over twice as many, and so on: each fit is near enough
// for the next to keep count of the periods.
Parameters fitted(const Family& family, std::span<const MeasuredRow> rows, Parameters start,
                  double first_span_s) {
    const auto n_within = [rows](double span_s) {
        const auto end =
            std::upper_bound(rows.begin(), rows.end(), rows.front().time_s + span_s,
                             [](double t, const MeasuredRow& row) { return t < row.time_s; });
        return std::max<std::size_t>(least_rows, static_cast<std::size_t>(end - rows.begin()));
    };
    for (double span_s = first_span_s;; span_s *= 2.0) {
        const std::size_t n = std::min(rows.size(), n_within(span_s));
        LeastSquares problem{Residuals{rows.first(n), &family}};
        Eigen::LevenbergMarquardt<LeastSquares> method(problem);
        method.parameters.maxfev = 200;
        Eigen::VectorXd p = start;
        method.minimize(p);
        start = p;
        if (n == rows.size()) return start;
    }
}

// The noise of a component, from sixth differences, to which a smooth motion adds little: the
// squares of their coefficients, 1, 6, 15, 20 and so on, sum up to 924. Between uneven instants it
// is too large.
double noise_of(std::span<const MeasuredRow> rows) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double sum = 0.0;
    std::size_t n = 0;
    const auto add = [&sum, &n](std::span<const MeasuredRow> stretch) {
        for (std::size_t i = 3; i + 3 < stretch.size(); ++i, ++n) {
            const auto pair = [&](std::size_t k) -> Eigen::Vector3d {
                return stretch[i - k].omega_body + stretch[i + k].omega_body;
            };
            sum += (pair(3) - 6.0 * pair(2) + 15.0 * pair(1) - 20.0 * stretch[i].omega_body)
                       .squaredNorm();
        }
    };
    for (const auto& stretch : stretches_of(rows, -infinity, infinity)) add(stretch);
    if (n == 0) add(rows);
    return std::sqrt(sum / 924.0 / static_cast<double>(3 * n));
}

[[noreturn]] void throw_no_motion(double off_rad_s, double rate_rad_s) {
    throw InputError(fmt::format(
        "no free motion of a rigid body comes near these rows: the best is off by {:.3g} rad/s of "
        "{:.3g}; cut the table to the time in which the body is free, and check units and axes",
        off_rad_s, rate_rad_s));
}
[[noreturn]] void throw_undetermined() {
    throw InputError(
        "the rows do not determine the moments: bodies with other moments would give the same "
        "ω(t); "
        "measure a motion in which the axis of rotation moves farther through the body, or measure "
        "for longer");
}
constexpr double most_noise_share = 0.3;      // of the rate
constexpr double most_residual_share = 0.05;  // of the rate, where the rows scatter less

// Refuses rows that are noise, and a turn about one axis, which says nothing about the moments:
// whatever ω is besides is noise.
void check_wandering(std::span<const MeasuredRow> rows) {
    const double noise = noise_of(rows), rate = rate_of(rows);
    if (noise > most_noise_share * rate) throw_no_motion(noise, rate);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const MeasuredRow& row : rows) squares += row.omega_body * row.omega_body.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(squares);
    const double beside = std::sqrt((eigen.eigenvalues()[0] + eigen.eigenvalues()[1]) / 2.0 /
                                    static_cast<double>(rows.size()));
    constexpr double least_share = 1e-6, least_noises = 3.0;
    if (beside < least_noises * noise || beside < least_share * rate)
        throw InputError(
            "the rows do not determine the moments: but for noise the body turns about one axis; "
            "measure a motion whose axis of rotation wanders through the body");
}

// Principal axes with I1 ≥ I2 ≥ I3 in units of I1.
struct Principal {
    Eigen::Vector3d moments;
    Eigen::Matrix3d axes;
};
// Each axis points near that of `near`, or to the positive side of its largest component.
void point_axes(Eigen::Matrix3d& axes, const Eigen::Matrix3d* near) {
    for (int k = 0; k < 3; ++k) {
        Eigen::Index largest = 0;
        axes.col(k).cwiseAbs().maxCoeff(&largest);
        const double side = near != nullptr ? axes.col(k).dot(near->col(k)) : axes(largest, k);
        if (side < 0.0) axes.col(k) *= -1.0;
    }
    if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
}
Principal principal(const Tensor& tensor, const Eigen::Matrix3d* near = nullptr) {
    const Eigen::SelfAdjointEigenSolver<Tensor> eigen(tensor);
    Principal found{eigen.eigenvalues().reverse() / eigen.eigenvalues()[2],
                    eigen.eigenvectors().rowwise().reverse()};
    point_axes(found.axes, near);
    return found;
}

// The same of a value of a family; known moments stay exactly what they are, and so do the axes of
// equal ones.
Principal principal_of(const Family& family, const Parameters& p,
                       const Eigen::Matrix3d* near = nullptr) {
    if (!family.has_moments()) return principal(family.tensor(p), near);
    Principal found{family.moments() / family.moments()[0], family.axes(p)};
    point_axes(found.axes, near);
    return found;
}

// A family of tensors and where to start in it.
struct Start {
    Family family;
    Parameters parameters;
    double rest = std::numeric_limits<double>::infinity();  // of Euler's equations
};

// That of these dampings which Euler's equations hold best with, for windows of this angle. Each is
// given by γ times the span of the rows.
constexpr std::array<double, 6> losses{0.0, 0.1, 0.3, 1.0, 2.0, 4.0};
Start start_of(std::span<const MeasuredRow> rows, double window_rad,
               std::span<const double> tried = losses) {
    const double span_s = rows.back().time_s - rows.front().time_s;
    Start start;
    start.parameters = start.family.parameters(Tensor::Identity(), rows.front().omega_body, 0.0);
    for (const double loss : tried) {
        const auto [tensor, rest] = first_tensor(normal_of(rows, loss / span_s, window_rad));
        if (!(rest < start.rest)) continue;
        start.rest = rest;
        start.parameters = start.family.parameters(tensor, rows.front().omega_body, loss / span_s);
    }
    return start;
}

// What is tried, best first. With known moments, in falling order, noise may have put the axes of a
// first tensor into another order: those orders that Euler's equations hold best with are tried.
std::vector<Start> starts_of(std::span<const MeasuredRow> rows,
                             const std::optional<Eigen::Vector3d>& moments) {
    std::vector<Start> starts;
    for (const double window_rad : {1.0, 0.5, 2.0, 4.0}) {
        const Start free = start_of(rows, window_rad);
        if (!moments) {
            starts.push_back(free);
            continue;
        }
        const double damping = damping_in(free.parameters);
        const Normal normal = normal_of(rows, damping, window_rad);
        const Eigen::Matrix3d axes = principal(free.family.tensor(free.parameters)).axes;
        std::array<int, 3> order{0, 1, 2};
        do {
            Eigen::Matrix3d ordered;
            for (int k = 0; k < 3; ++k)
                ordered.col(k) = axes.col(order[static_cast<std::size_t>(k)]);
            if (ordered.determinant() < 0.0) ordered.col(2) *= -1.0;
            Start start{Family(*moments, ordered), {}};
            start.parameters =
                start.family.parameters(Tensor::Identity(), rows.front().omega_body, damping);
            const Tensor tensor = start.family.tensor(start.parameters);
            Elements elements;
            for (int k = 0; k < 6; ++k) {
                const auto [i, j] = places[static_cast<std::size_t>(k)];
                elements[k] = tensor(i, j);
            }
            start.rest = elements.dot(normal * elements) /
                         std::max(normal.trace() * elements.squaredNorm(), 1e-300);
            starts.push_back(std::move(start));
        } while (std::next_permutation(order.begin(), order.end()));
    }
    // Noise may also make the wrong damping look best.
    if (!moments)
        for (const double& loss : losses)
            starts.push_back(start_of(rows, 1.0, std::span(&loss, 1)));
    if (moments) {
        constexpr std::size_t most = 6;
        std::stable_sort(starts.begin(), starts.end(),
                         [](const Start& a, const Start& b) { return a.rest < b.rest; });
        starts.resize(std::min(starts.size(), most));
    }
    return starts;
}

// From a first tensor or a first span that is far off, another minimum may be found: starts are
// tried until one leaves no more than noise, or the least of all counts.
Start best_fit(std::span<const MeasuredRow> rows, const std::optional<Eigen::Vector3d>& moments) {
    const double noise = 1.2 * noise_of(rows);
    const std::vector<Start> starts = starts_of(rows, moments);
    Start best;
    double least = std::numeric_limits<double>::infinity();
    for (const double first_span_rad : {12.0, 5.0, 30.0})
        for (const Start& start : starts) {
            const Parameters found =
                fitted(start.family, rows, start.parameters, first_span_rad / rate_of(rows));
            const double square = Residuals{rows, &start.family}.at(found).squaredNorm();
            if (square < least) {
                least = square;
                best = start;
                best.parameters = found;
            }
            const auto n_values = static_cast<double>(3 * rows.size()) -
                                  static_cast<double>(start.family.n_parameters());
            if (least < noise * noise * n_values) return best;
        }
    return best;
}

// Whether L² = 2T·I2 but for rounding. Then sech and tanh of ω(t) fit a family of bodies: k = 1
// says nothing more about the moments.
bool is_on_separatrix(const Principal& body, const Eigen::Vector3d& omega) {
    const Eigen::Vector3d squares = (body.axes.transpose() * omega).cwiseAbs2();
    const double twice_energy = body.moments.dot(squares);
    const double momentum_squared = body.moments.cwiseAbs2().dot(squares);
    constexpr double nearest = 1e-6;
    return std::abs(momentum_squared / twice_energy - body.moments[1]) <
           nearest * (body.moments[0] - body.moments[2]);
}

// Every so many rows, evenly, so that no more than most_rows are left, but none of them so far
// apart that the body turns by too much in between: of a longer table the beginning is taken.
std::vector<MeasuredRow> thinned(std::span<const MeasuredRow> rows) {
    const double step_s = (rows.back().time_s - rows.front().time_s) /
                          static_cast<double>(std::max<std::size_t>(rows.size(), 2) - 1);
    const double most_turn = 0.5 * most_turn_rad;
    const auto widest = static_cast<std::size_t>(
        std::max(1.0, std::min(1e9, most_turn / std::max(step_s * rate_of(rows), 1e-9))));
    const std::size_t stride = std::min((rows.size() + most_rows - 1) / most_rows, widest);
    std::vector<MeasuredRow> some;
    some.reserve(std::min(rows.size(), most_rows));
    for (std::size_t i = 0; i < rows.size() && some.size() < most_rows; i += stride)
        some.push_back(rows[i]);
    return some;
}

void check(std::span<const MeasuredRow> rows) {
    if (rows.size() < least_rows)
        throw InputError(fmt::format("{} about a motion; give {} or more",
                                     rows.size() == 1
                                         ? "1 row says too little"
                                         : fmt::format("{} rows say too little", rows.size()),
                                     least_rows));
    const double rate = rate_of(rows);
    if (!(rate > 0.0))
        throw InputError("ω is zero in all rows: a body at rest says nothing about its moments");
    if (!std::isfinite(rate)) throw InputError("ω is too large to be squared; give it in rad/s");
    std::size_t n_far = 0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        n_far += (rows[i].time_s - rows[i - 1].time_s) * rate > most_turn_rad;
    if (2 * n_far > rows.size())
        throw InputError(
            fmt::format("the body turns by more than half a radian from one row to the next; "
                        "sample it at {:.3g} Hz or more",
                        2.0 * rate));
}

}  // namespace

FittedMotion fit_motion(std::span<const MeasuredRow> all,
                        const std::optional<Eigen::Vector3d>& moments_kg_m2) {
    std::optional<Eigen::Vector3d> moments = moments_kg_m2;
    if (moments) std::sort(moments->begin(), moments->end(), std::greater<>());
    if (moments && (*moments)[0] == (*moments)[2])
        throw InputError(
            "the three moments are equal: every axis of such a body is a principal axis, and its ω "
            "does not change");
    check(all);
    const std::vector<MeasuredRow> rows = thinned(all);
    check(rows);
    check_wandering(rows);
    const Start best = best_fit(rows, moments);
    const Family& family = best.family;
    const Parameters& p = best.parameters;
    const Residuals residuals{rows, &family};
    const Eigen::MatrixXd jacobian = residuals.jacobian_at(p);
    const double variance =
        residuals.at(p).squaredNorm() / static_cast<double>(residuals.n_values() - p.size());
    const double rate = rate_of(rows);
    const double residual = std::sqrt(variance);
    if (!(residual < std::max(most_residual_share * rate, 1.5 * noise_of(rows))))
        throw_no_motion(residual, rate);
    // Scaled, so that units do not matter.
    const Eigen::VectorXd scale = jacobian.colwise().norm().cwiseInverse();
    const Eigen::MatrixXd scaled = jacobian * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled.transpose() * scaled);
    constexpr double least_eigenvalue = 1e-13;
    if (!(eigen.eigenvalues()[0] > least_eigenvalue)) throw_undetermined();
    const Eigen::MatrixXd covariance =
        variance * (scale.asDiagonal() * eigen.eigenvectors() *
                    eigen.eigenvalues().cwiseInverse().asDiagonal() *
                    eigen.eigenvectors().transpose() * scale.asDiagonal());

    const Principal found = principal_of(family, p);
    if (!moments && is_on_separatrix(found, omega_in(p))) throw_undetermined();
    // Moments and axes change with the tensor's parameters.
    const int n_of_tensor = family.n_of_tensor();
    Eigen::MatrixXd change(6, n_of_tensor);
    constexpr double step = 1e-6;
    for (int k = 0; k < n_of_tensor; ++k) {
        const auto moved = [&](double by) {
            Parameters q = p;
            q[k] += by;
            const Principal there = principal_of(family, q, &found.axes);
            const Eigen::Matrix3d turn = found.axes.transpose() * there.axes;
            Eigen::Matrix<double, 6, 1> values;
            values << there.moments, turn(2, 1), turn(0, 2), turn(1, 0);
            return values;
        };
        change.col(k) = (moved(step) - moved(-step)) / (2.0 * step);
    }
    const Eigen::Matrix<double, 6, 6> spread =
        change * covariance.topLeftCorner(n_of_tensor, n_of_tensor) * change.transpose();
    const auto sd = [](double square) { return std::sqrt(std::max(square, 0.0)); };

    FittedMotion fit;
    fit.first_time_s = rows.front().time_s;
    fit.omega_rad_s = omega_in(p);
    fit.moments = found.moments;
    if (moments) fit.I1_kg_m2 = (*moments)[0];
    fit.instrument_from_principal = found.axes;
    for (int k = 0; k < 3; ++k) {
        fit.moments_sd[k] = sd(spread(k, k));
        fit.axes_sd_rad[k] = sd(spread(3 + k, 3 + k));
        fit.omega_sd_rad_s[k] = sd(covariance(n_of_tensor + k, n_of_tensor + k));
    }
    fit.damping_1_s = damping_in(p);
    fit.damping_sd_1_s = sd(covariance(p.size() - 1, p.size() - 1));
    fit.residual_rad_s = residual;
    fit.n_rows = rows.size();
    fit.noise_rad_s = noise_of(rows);
    if (constexpr double most = 0.25; fit.moments_sd.maxCoeff() > most) throw_undetermined();
    return fit;
}

}  // namespace poinsot
