#include "measured/flight_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "measured/fit_start.h"
#include "measured/table_faults.h"
#include "numerics/small_solvers.h"
#include "system/interrupt.h"

namespace poinsot {

namespace {

// Each axis points to the positive side of its largest component.
void point_axes(Eigen::Matrix3d& axes) {
    for (int k = 0; k < 3; ++k) {
        Eigen::Index largest = 0;
        axes.col(k).cwiseAbs().maxCoeff(&largest);
        if (axes(largest, k) < 0.0) axes.col(k) *= -1.0;
    }
    if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
}

// Least squares over the first rows, then over twice as many, and so on: each fit is near enough
// for the next to keep count of the periods.
FoundFlight grown(std::span<const MeasuredRow> rows, Flight start, const IsFitted& is_fitted,
                  double first_span_rad) {
    constexpr int most_steps = 60;
    for (double span = first_span_rad;; span *= 2.0) {
        const auto end =
            std::upper_bound(rows.begin(), rows.end(), rows.front().time_s + span,
                             [](double t, const MeasuredRow& row) { return t < row.time_s; });
        const std::size_t n = std::min(
            rows.size(), std::max(least_fitted_rows, static_cast<std::size_t>(end - rows.begin())));
        FoundFlight found = minimised(rows.first(n), start, is_fitted, most_steps);
        if (n == rows.size()) return found;
        start = found.flight;
    }
}

// Starts are tried until one leaves no more than noise, or until two of them end in the same least
// minimum.
FoundFlight valley_of(std::span<const MeasuredRow> rows, double noise,
                      const std::optional<Eigen::Vector3d>& moments, const IsFitted& is_fitted) {
    const double most_noise = 1.2 * noise;
    const double n_values = static_cast<double>(3 * rows.size()) - count(is_fitted);
    FoundFlight best;
    constexpr double same = 1e-3, near_share = 0.05;
    for (const double first_span_rad : {12.0, 5.0, 30.0})
        for (const Flight& start : first_flights(rows, moments)) {
            const FoundFlight found = grown(rows, start, is_fitted, first_span_rad);
            const bool is_same = std::abs(found.squares - best.squares) < same * best.squares;
            if (found.squares < best.squares) best = found;
            if (best.squares < most_noise * most_noise * n_values) return best;
            if (is_same && best.squares < near_share * near_share * n_values) return best;
        }
    return best;
}

void add_attitude(bool has_attitude, IsFitted& is_fitted) {
    if (has_attitude) std::fill(is_fitted.begin() + first_of_attitude, is_fitted.end(), true);
}

}  // namespace

double rate_of(std::span<const MeasuredRow> rows) {
    double sum = 0.0;
    for (const MeasuredRow& row : rows) sum += row.omega_body.squaredNorm();
    return std::sqrt(sum / static_cast<double>(rows.size()));
}

// From sixth differences, to which a smooth motion adds little: the squares of their coefficients,
// 1, 6, 15, 20 and so on, sum up to 924.
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

double fitted_noise_of(std::span<const MeasuredRow> rows, double rate) {
    return has_fitted_attitude(rows) ? attitude_noise_of(rows) : noise_of(rows) / rate;
}

std::vector<MeasuredRow> scaled_by(std::span<const MeasuredRow> rows, double rate) {
    std::vector<MeasuredRow> scaled(rows.begin(), rows.end());
    for (MeasuredRow& row : scaled) {
        row.time_s = (row.time_s - rows.front().time_s) * rate;
        row.omega_body /= rate;
    }
    return scaled;
}

IsFitted fitted_changes(const std::optional<Eigen::Vector3d>& moments, DragModel drag,
                        bool has_attitude) {
    IsFitted is_fitted{};
    for (int k = 0; k < n_changes(drag); ++k) is_fitted[static_cast<std::size_t>(k)] = true;
    add_attitude(has_attitude, is_fitted);
    if (!moments) return is_fitted;
    is_fitted[0] = is_fitted[1] = false;
    // A turn about the axis of two equal moments changes nothing.
    for (std::size_t k = 0; k < 3; ++k) {
        const auto one = static_cast<Eigen::Index>((k + 1) % 3);
        const auto other = static_cast<Eigen::Index>((k + 2) % 3);
        if ((*moments)[one] == (*moments)[other]) is_fitted[2 + k] = false;
    }
    return is_fitted;
}

int count(const IsFitted& is_fitted) {
    return static_cast<int>(std::count(is_fitted.begin(), is_fitted.end(), true));
}

std::vector<int> places_of(const IsFitted& is_fitted) {
    std::vector<int> places;
    places.reserve(is_fitted.size());
    for (std::size_t k = 0; k < is_fitted.size(); ++k)
        if (is_fitted[k]) places.push_back(static_cast<int>(k));
    return places;
}

Eigen::MatrixXd chosen(const FlightSquare& square, const std::vector<int>& places) {
    const auto n = static_cast<Eigen::Index>(places.size());
    Eigen::MatrixXd normal(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k)
            normal(i, k) =
                square(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(k)]);
    return normal;
}

IsFitted fitted_start(DragModel drag, bool has_attitude, bool with_drag) {
    IsFitted is_fitted{};
    const int end = with_drag ? n_changes(drag) : first_of_drag;
    for (int k = first_of_omega; k < end; ++k) is_fitted[static_cast<std::size_t>(k)] = true;
    add_attitude(has_attitude, is_fitted);
    return is_fitted;
}

FoundFlight minimised(std::span<const MeasuredRow> rows, const Flight& start,
                      const IsFitted& is_fitted, int most_steps) {
    constexpr double least_gain = 1e-9, most_trust = 1e12, widest = 6e4;
    const std::vector<int> places = places_of(is_fitted);
    Flight flight = start;
    FlightSums sums = flight_sums(flight, rows);
    double trust = 1e-3;
    for (int n_steps = 0; n_steps < most_steps && std::isfinite(sums.squares); ++n_steps) {
        stop_if_interrupted();
        const Eigen::MatrixXd normal = chosen(sums.normal, places);
        Eigen::VectorXd gradient(normal.rows());
        for (Eigen::Index i = 0; i < gradient.size(); ++i)
            gradient[i] = sums.gradient[places[static_cast<std::size_t>(i)]];
        Eigen::MatrixXd damped = normal;
        // A number that changes nothing stays. A common floor keeps a few rows of ω in the valley
        // that they leave; in a long flight of attitudes, the squares of drag and start differ by
        // more digits than it would leave.
        const double floor = flight.attitude ? 0.0 : 1e-12 * normal.diagonal().maxCoeff();
        for (Eigen::Index i = 0; i < damped.rows(); ++i)
            damped(i, i) +=
                normal(i, i) > 0.0 ? trust * normal(i, i) + floor : std::max(floor, 1.0);
        const Eigen::VectorXd step = solved(damped, -gradient);
        FlightChange by = FlightChange::Zero();
        for (Eigen::Index i = 0; i < step.size(); ++i)
            by[places[static_cast<std::size_t>(i)]] = step[i];
        if (!by.allFinite()) break;
        const Flight next = changed(flight, by);
        const bool is_tried = by.head<n_of_body>().cwiseAbs().maxCoeff() < 2.0 &&
                              next.moments.maxCoeff() < widest &&
                              next.moments.minCoeff() > 1.0 / widest;
        FlightSums there;
        there.squares = std::numeric_limits<double>::infinity();
        if (is_tried) there = flight_sums(next, rows);
        if (there.squares < sums.squares) {
            const double gain = 1.0 - there.squares / sums.squares;
            flight = next;
            sums = there;
            trust = std::max(trust * 0.1, 1e-9);
            if (gain < least_gain) break;
        } else {
            trust *= 8.0;
            if (trust > most_trust || by.cwiseAbs().maxCoeff() < 1e-13) break;
        }
    }
    return {flight, sums.squares};
}

int steps_to_a_minimum(std::size_t n_rows) {
    constexpr double most_rows = 2e6, least = 60.0, most = 5000.0;
    return static_cast<int>(std::clamp(most_rows / static_cast<double>(n_rows), least, most));
}

FoundFlight minimised(std::span<const MeasuredRow> rows, const Flight& start,
                      const IsFitted& is_fitted) {
    return minimised(rows, start, is_fitted, steps_to_a_minimum(rows.size()));
}

double residual_of(const FoundFlight& found, std::size_t n_rows, int n_fitted) {
    return std::sqrt(found.squares / (static_cast<double>(3 * n_rows) - n_fitted));
}

double root_mean_square_of(double squares, std::size_t n_rows) {
    return std::sqrt(squares / static_cast<double>(3 * n_rows));
}

FoundFlight best_fit(std::span<const MeasuredRow> rows, double noise,
                     const std::optional<Eigen::Vector3d>& moments) {
    const IsFitted is_fitted = fitted_changes(moments, DragModel::linear);
    FoundFlight best = valley_of(rows, noise, moments, is_fitted);
    if (std::isfinite(best.squares)) best = minimised(rows, best.flight, is_fitted);
    if (moments || excess_of(best.flight.moments) < most_excess) return best;
    constexpr double first_span_rad = 12.0;
    for (const Flight& start : physical_flights(rows)) {
        const FoundFlight found = grown(rows, start, is_fitted, first_span_rad);
        if (found.squares < best.squares && excess_of(found.flight.moments) < most_excess)
            best = found;
    }
    return minimised(rows, best.flight, is_fitted);
}

double excess_of(const Eigen::Vector3d& moments) {
    return 2.0 - moments.sum() / moments.maxCoeff();
}

// The three axes share the damping at first, which does not grow.
Eigen::Vector3d first_rates(DragModel drag, double damping) {
    if (drag == DragModel::none) return Eigen::Vector3d::Zero();
    if (drag == DragModel::growing) return {damping, 0.0, 0.0};
    return Eigen::Vector3d::Constant(damping);
}

FoundFlight with_drag(std::span<const MeasuredRow> rows, const FoundFlight& linear, DragModel drag,
                      const std::optional<Eigen::Vector3d>& moments) {
    if (drag == DragModel::linear) return linear;
    Flight start = linear.flight;
    start.drag = drag;
    start.drag_rates = first_rates(drag, linear.flight.drag_rates[0]);
    return minimised(rows, start, fitted_changes(moments, drag, start.attitude.has_value()));
}

// Differences make ω too small, so that the flight may lose count of the turns: then from the first
// rows on.
FoundFlight with_attitude(std::span<const MeasuredRow> rows, const Flight& of_omega, double noise,
                          const IsFitted& is_fitted) {
    Flight start = of_omega;
    start.attitude = rows.front().space_from_body;
    FoundFlight best = minimised(rows, start, is_fitted);
    constexpr double like_noise = 1.2, first_span_rad = 12.0;
    const double n_values = static_cast<double>(3 * rows.size()) - count(is_fitted);
    if (best.squares < std::pow(like_noise * noise, 2) * n_values) return best;
    const FoundFlight other = grown(rows, start, is_fitted, first_span_rad);
    return other.squares < best.squares ? minimised(rows, other.flight, is_fitted) : best;
}

Flight in_order(const Flight& flight) {
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&flight](int a, int b) { return flight.moments[a] > flight.moments[b]; });
    Flight made = flight;
    for (int k = 0; k < 3; ++k) {
        const int from = order[static_cast<std::size_t>(k)];
        made.moments[k] = flight.moments[from] / flight.moments[order[0]];
        made.axes.col(k) = flight.axes.col(from);
        if (flight.drag == DragModel::axes || flight.drag == DragModel::quadratic)
            made.drag_rates[k] = flight.drag_rates[from];
    }
    point_axes(made.axes);
    return made;
}

double variance_of(double squares, std::size_t n_rows, double n_taken) {
    const auto n_values = static_cast<double>(3 * n_rows);
    constexpr double least_share = 0.1;
    return squares / std::max(n_values - n_taken, least_share * n_values);
}

double correlation_of(const std::vector<Eigen::Vector3d>& residuals) {
    double squares = 0.0, products = 0.0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        squares += residuals[i].squaredNorm();
        if (i > 0) products += residuals[i].dot(residuals[i - 1]);
    }
    constexpr double most = 0.99;
    return squares > 0.0 ? std::clamp(products / squares, 0.0, most) : 0.0;
}

}  // namespace poinsot
