#include "measured/flights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "measured/fit_start.h"
#include "measured/flight_fit.h"
#include "measured/flight_model.h"
#include "measured/table_faults.h"
#include "system/interrupt.h"

namespace poinsot {

namespace {

constexpr double least_turn_rad = 3.5;
constexpr double widest_gap_rad = 1.0;
// Residuals as shares of |ω|: of any body, of one that is known from other flights, and of one that
// flies once where others fly often.
constexpr double most_share = 0.03, most_known_share = 0.03, most_single_share = 0.01;

// Rows that are not at the limit of the sensor.
std::vector<MeasuredRow> unsaturated(std::span<const MeasuredRow> rows) {
    std::vector<bool> is_saturated(rows.size(), false);
    constexpr std::size_t least_rows = 3;
    for (const Saturation& saturation : saturations_of(rows)) {
        const auto is_at_limit = [&](std::size_t i) {
            return rows[i].omega_body[saturation.component] == saturation.value_rad_s;
        };
        for (std::size_t begin = 0; begin < rows.size(); ++begin) {
            std::size_t end = begin;
            while (end < rows.size() && is_at_limit(end)) ++end;
            if (end - begin >= least_rows)
                std::fill(is_saturated.begin() + static_cast<std::ptrdiff_t>(begin),
                          is_saturated.begin() + static_cast<std::ptrdiff_t>(end), true);
            begin = end;
        }
    }
    std::vector<MeasuredRow> some;
    some.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!is_saturated[i]) some.push_back(rows[i]);
    return some;
}

// A window of rows, and how far Euler's equations are from holding in it for the best body: the
// share of the changes of angular momentum that they leave unexplained.
struct Window {
    std::size_t begin = 0, end = 0;
    double unexplained = 0.0;
};

// Rows begin … end − 1, fitted by a flight in units in which |ω| is `rate`.
struct Stretch {
    std::size_t begin = 0, end = 0;
    double rate = 0.0;
    Flight flight;                                                 // scaled by the rate
    double share = std::numeric_limits<double>::infinity();        // residual over rate
    double least_share = std::numeric_limits<double>::infinity();  // of all that it grew from
};

double middle_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class FlightFinder {
 public:
    explicit FlightFinder(std::span<const MeasuredRow> rows)
        : rows_(unsaturated(rows)), angles_(rows_.size(), 0.0), is_used_(rows_.size(), false) {
        for (std::size_t i = 1; i < rows_.size(); ++i)
            angles_[i] =
                angles_[i - 1] + 0.5 * (rows_[i].time_s - rows_[i - 1].time_s) *
                                     (rows_[i].omega_body.norm() + rows_[i - 1].omega_body.norm());
    }

    std::vector<FreeFlight> flights();

 private:
    std::span<const MeasuredRow> between(std::size_t begin, std::size_t end) const {
        return std::span(rows_).subspan(begin, end - begin);
    }
    double turn(std::size_t begin, std::size_t end) const {
        return angles_[end - 1] - angles_[begin];
    }
    double most() const { return body_ ? most_known_share : most_share; }
    std::vector<Window> windows() const;
    std::optional<Stretch> fitted(std::size_t begin, std::size_t end, const Flight* start) const;
    bool grow(Stretch& stretch, bool forward) const;
    void grow(Stretch& stretch) const;
    void trim(Stretch& stretch) const;
    bool refit(Stretch& stretch, std::size_t begin, std::size_t end) const;
    Eigen::Vector3d omega_at(const Stretch& stretch, std::size_t row) const;
    void mark(const Stretch& stretch, bool is_used);
    void join(std::vector<Stretch>& stretches);
    std::vector<Stretch> stretches_from(const std::vector<Window>& windows);
    std::pair<std::size_t, std::size_t> most_common(const std::vector<Stretch>& stretches);
    std::optional<Stretch> grown_from(const Window& window) const;

    std::vector<MeasuredRow> rows_;
    std::vector<double> angles_;
    std::vector<bool> is_used_;
    std::optional<Stretch> body_;  // of known moments and axes
};

std::vector<Window> FlightFinder::windows() const {
    std::vector<Window> made;
    constexpr double steps_a_window = 4.0;
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < rows_.size();) {
        stop_if_interrupted();
        end = std::max(end, begin);
        while (end < rows_.size() &&
               (angles_[end] - angles_[begin] < least_turn_rad || end - begin < least_fitted_rows))
            ++end;
        if (end == rows_.size()) break;
        made.push_back({begin, end, unexplained_share(between(begin, end))});
        const double next = angles_[begin] + least_turn_rad / steps_a_window;
        const std::size_t before = begin;
        while (begin < end && angles_[begin] < next) ++begin;
        begin = std::max(begin, before + 1);
    }
    std::stable_sort(made.begin(), made.end(), [](const Window& a, const Window& b) {
        return a.unexplained < b.unexplained;
    });
    return made;
}

// Least squares from this flight on, with its drag, or with linear drag from Euler's equations. The
// body is fitted, too, unless it is known.
std::optional<Stretch> FlightFinder::fitted(std::size_t begin, std::size_t end,
                                            const Flight* start) const {
    const auto part = between(begin, end);
    Stretch stretch{begin, end, rate_of(part), {}};
    const std::vector<MeasuredRow> scaled = scaled_by(part, stretch.rate);
    const DragModel drag = start != nullptr ? start->drag : DragModel::linear;
    const IsFitted is_fitted = body_ ? fitted_start(drag) : fitted_changes({}, drag);
    FoundFlight found;
    constexpr int most_steps = 15;
    if (start != nullptr) {
        found = minimised(scaled, *start, is_fitted, most_steps);
    } else {
        const std::vector<Flight> starts = first_flights(scaled, {});
        constexpr std::size_t most_starts = 3;
        for (std::size_t i = 0; i < std::min(most_starts, starts.size()); ++i) {
            const FoundFlight next = minimised(scaled, starts[i], is_fitted, most_steps);
            if (next.squares < found.squares) found = next;
            if (residual_of(found, scaled.size(), count(is_fitted)) < most_share) break;
        }
    }
    if (!std::isfinite(found.squares)) return std::nullopt;
    stretch.flight = found.flight;
    stretch.share = residual_of(found, scaled.size(), count(is_fitted));
    return stretch;
}

// The same motion seen backwards: −ω(−t) obeys Euler's equations, too, with negative drag.
Flight reversed(const Flight& flight, const Eigen::Vector3d& omega_at_its_start) {
    Flight made = flight;
    made.omega = -omega_at_its_start;
    made.drag_rates *= -1.0;
    return made;
}

// By rows that the fitted motion predicts; false where there are none.
bool FlightFinder::grow(Stretch& stretch, bool forward) const {
    constexpr double growth = 0.35, most_residuals = 5.0;
    const double most_angle = std::max(1.0, growth * turn(stretch.begin, stretch.end));
    std::vector<std::size_t> next;
    std::size_t at = forward ? stretch.end - 1 : stretch.begin;
    const double angle = angles_[at];
    for (;;) {
        const std::size_t before = at;
        if (forward ? ++at == rows_.size() : at-- == 0) break;
        if (is_used_[at] || std::abs(angles_[at] - angle) > most_angle ||
            std::abs(angles_[at] - angles_[before]) > widest_gap_rad)
            break;
        next.push_back(at);
    }
    if (next.empty()) return false;
    // From the first row of the stretch to its last one, and on.
    const double first_s = rows_[stretch.begin].time_s, last_s = rows_[stretch.end - 1].time_s;
    std::vector<double> times{0.0};
    Flight flight = stretch.flight;
    if (forward)
        times.push_back((last_s - first_s) * stretch.rate);
    else
        flight = reversed(flight, flight.omega);
    for (const std::size_t i : next)
        times.push_back(std::abs(rows_[i].time_s - first_s) * stretch.rate);
    const std::vector<Eigen::Vector3d> omegas = flight_omega(flight, times);
    const double most_off = std::max(most_residuals * stretch.share, most_share);
    std::size_t n = 0;
    const std::size_t skipped = forward ? 2 : 1;
    for (; n < next.size() && n + skipped < omegas.size(); ++n) {
        const Eigen::Vector3d there = rows_[next[n]].omega_body / stretch.rate;
        const Eigen::Vector3d off =
            omegas[n + skipped] - (forward ? there : Eigen::Vector3d(-there));
        if (!(off.norm() < most_off)) break;
    }
    if (n == 0) return false;
    const std::size_t begin = forward ? stretch.begin : next[n - 1];
    const std::size_t end = forward ? next[n - 1] + 1 : stretch.end;
    return refit(stretch, begin, end);
}

std::optional<Stretch> FlightFinder::grown_from(const Window& window) const {
    std::optional<Stretch> stretch;
    if (body_) {
        const double rate = rate_of(between(window.begin, window.end));
        Flight start = body_->flight;
        start.omega = rows_[window.begin].omega_body / rate;
        start.drag_rates *= body_->rate / rate;
        stretch = fitted(window.begin, window.end, &start);
    } else {
        stretch = fitted(window.begin, window.end, nullptr);
    }
    if (!stretch || !(stretch->share < most())) return std::nullopt;
    grow(*stretch);
    // Drag along each axis describes longer stretches, and ends more sharply.
    for (int n_times = 0; n_times < 2; ++n_times) {
        Flight richer = stretch->flight;
        richer.drag = DragModel::axes;
        const auto again = fitted(stretch->begin, stretch->end, &richer);
        if (!again || !(again->share < stretch->share)) return stretch;
        stretch = again;
        grow(*stretch);
        trim(*stretch);
    }
    return stretch;
}

// A stretch that stops at one end for a poor fit may go on there when rows at the other end have
// mended it: else a long flight is found in many pieces, each of which grows over the others.
void FlightFinder::grow(Stretch& stretch) const {
    constexpr double least_growth = 1.05;
    double n_before = 0.0;
    do {
        n_before = static_cast<double>(stretch.end - stretch.begin);
        bool grows_forward = true, grows_backward = true;
        while (grows_forward || grows_backward) {
            if (grows_forward) grows_forward = grow(stretch, true);
            if (grows_backward) grows_backward = grow(stretch, false);
        }
    } while (static_cast<double>(stretch.end - stretch.begin) > least_growth * n_before);
}

// Takes rows from the ends at which the residuals change far faster than elsewhere, by a torque
// that the air does not have.
void FlightFinder::trim(Stretch& stretch) const {
    // A torque in units of the moment times ω²; that of the air is of the order of 0.02.
    constexpr double most_slopes = 5.0, least_torque = 0.05, most_residuals = 2.0;
    for (;;) {
        const std::vector<MeasuredRow> scaled =
            scaled_by(between(stretch.begin, stretch.end), stretch.rate);
        std::vector<Eigen::Vector3d> residuals;
        flight_sums(stretch.flight, scaled, &residuals);
        const std::size_t n = residuals.size();
        if (n <= least_fitted_rows) return;
        std::vector<double> slopes(n - 1), sizes(n);
        for (std::size_t i = 0; i + 1 < n; ++i)
            slopes[i] = (residuals[i + 1] - residuals[i]).norm() /
                        (scaled[i + 1].time_s - scaled[i].time_s);
        for (std::size_t i = 0; i < n; ++i) sizes[i] = residuals[i].norm();
        const double most_slope = std::max(most_slopes * middle_of(slopes), least_torque);
        const double most_size = most_residuals * middle_of(sizes);
        const auto is_torn = [&](std::size_t i, std::size_t slope) {
            return sizes[i] > most_size && slopes[slope] > most_slope;
        };
        // Two whole rows end the torn ones.
        const std::size_t most_rows = std::min((n - least_fitted_rows + 1) / 2, n / 8 + 1);
        std::size_t begin = 0, end = n;
        for (std::size_t i = 0; i < std::min(most_rows, begin + 2); ++i)
            if (is_torn(i, i)) begin = i + 1;
        for (std::size_t i = 0; i < std::min(most_rows, n - end + 2); ++i)
            if (is_torn(n - 1 - i, n - 2 - i)) end = n - 1 - i;
        if (begin == 0 && end == n) return;
        if (!refit(stretch, stretch.begin + begin, stretch.begin + end)) return;
    }
}

// ω of the stretch's flight at this row, in units of the stretch's rate. A single row's own ω has
// noise, which leads fits of many turns astray.
Eigen::Vector3d FlightFinder::omega_at(const Stretch& stretch, std::size_t row) const {
    const double t = (rows_[row].time_s - rows_[stretch.begin].time_s) * stretch.rate;
    const std::vector<double> times{0.0, std::abs(t)};
    const Flight& flight = stretch.flight;
    const auto omegas = flight_omega(t < 0.0 ? reversed(flight, flight.omega) : flight, times);
    if (omegas.size() < times.size()) return rows_[row].omega_body / stretch.rate;
    return t < 0.0 ? Eigen::Vector3d(-omegas[1]) : omegas[1];
}

// From the flight of the stretch on, for other rows and in units of their rate.
bool FlightFinder::refit(Stretch& stretch, std::size_t begin, std::size_t end) const {
    const double rate = rate_of(between(begin, end));
    Flight start = stretch.flight;
    start.omega = omega_at(stretch, begin) * (stretch.rate / rate);
    if (start.drag != DragModel::quadratic) start.drag_rates *= stretch.rate / rate;
    auto made = fitted(begin, end, &start);
    // Few rows leave a curved valley, in which the fit goes on while it gains.
    constexpr double most_worse = 1.2, least_gain = 0.01;
    constexpr int most_times = 4;
    const double least_share = std::min(stretch.share, stretch.least_share);
    for (int n = 0; n < most_times && made && made->share > most_worse * least_share; ++n) {
        const Stretch before = *made;
        made = fitted(begin, end, &before.flight);
        if (made && made->share > (1.0 - least_gain) * before.share) break;
    }
    if (!made || !(made->share < most())) return false;
    made->least_share = std::min(made->share, least_share);
    stretch = *made;
    return true;
}

void FlightFinder::mark(const Stretch& stretch, bool is_used) {
    std::fill(is_used_.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
              is_used_.begin() + static_cast<std::ptrdiff_t>(stretch.end), is_used);
}

// Of neighbours, the one that fits better may reach over the other one, whose rows near an end were
// not free.
void FlightFinder::join(std::vector<Stretch>& stretches) {
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    for (std::size_t i = 0; i + 1 < stretches.size();) {
        const bool is_first_better = stretches[i].share < stretches[i + 1].share;
        Stretch better = stretches[is_first_better ? i : i + 1];
        const Stretch other = stretches[is_first_better ? i + 1 : i];
        const double apart = angles_[stretches[i + 1].begin] - angles_[stretches[i].end - 1];
        bool is_joined = false;
        if (apart < widest_gap_rad) {
            mark(other, false);
            grow(better);
            trim(better);
            const std::size_t begin = std::max(better.begin, other.begin);
            const std::size_t end = std::min(better.end, other.end);
            is_joined = begin < end && 2 * (end - begin) > other.end - other.begin;
            if (!is_joined) mark(other, true);
        }
        if (is_joined) {
            mark(better, true);
            stretches[i] = better;
            stretches.erase(stretches.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        } else {
            ++i;
        }
    }
}

std::vector<Stretch> FlightFinder::stretches_from(const std::vector<Window>& windows) {
    std::vector<Stretch> stretches;
    for (const Window& window : windows) {
        constexpr double most_unexplained = 0.5;
        if (window.unexplained > most_unexplained) break;
        const std::size_t middle = (window.begin + window.end) / 2;
        if (is_used_[window.begin] || is_used_[window.end - 1] || is_used_[middle]) continue;
        const auto stretch = grown_from(window);
        if (!stretch) continue;
        mark(*stretch, true);
        stretches.push_back(*stretch);
    }
    return stretches;
}

// The stretch whose body describes them best, and how many it describes.
std::pair<std::size_t, std::size_t> FlightFinder::most_common(
    const std::vector<Stretch>& stretches) {
    std::vector<std::size_t> order(stretches.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&stretches](std::size_t a, std::size_t b) {
        return stretches[a].share < stretches[b].share;
    });
    constexpr std::size_t most_tried = 6;
    std::pair<std::size_t, std::size_t> best{0, 0};
    double least_rest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < std::min(most_tried, order.size()); ++k) {
        body_ = stretches[order[k]];
        std::size_t n = 0;
        double rest = 0.0;
        for (const Stretch& other : stretches) {
            Flight start = body_->flight;
            start.omega = other.flight.omega;
            start.drag_rates *= body_->rate / other.rate;
            const auto made = fitted(other.begin, other.end, &start);
            const double share = made ? std::min(made->share / most_known_share, 1.0) : 1.0;
            n += share < 1.0;
            rest += share * share;
        }
        if (rest < least_rest) {
            least_rest = rest;
            best = {order[k], n};
        }
    }
    body_.reset();
    return best;
}

std::size_t n_common(const Stretch& a, const Stretch& b) {
    const std::size_t begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
    return begin < end ? end - begin : 0;
}

bool is_better_in(const Stretch& stretch, const std::vector<Stretch>& others) {
    return std::any_of(others.begin(), others.end(), [&stretch](const Stretch& other) {
        return n_common(stretch, other) > 0 && 2.0 * other.share < stretch.share &&
               4 * (other.end - other.begin) > 3 * (stretch.end - stretch.begin);
    });
}

bool is_partly_in(const Stretch& stretch, const std::vector<Stretch>& others) {
    return std::any_of(others.begin(), others.end(), [&stretch](const Stretch& other) {
        return 3 * n_common(stretch, other) > stretch.end - stretch.begin;
    });
}

std::vector<FreeFlight> FlightFinder::flights() {
    const std::vector<Window> all = windows();
    std::vector<Stretch> unknown = stretches_from(all), known;
    join(unknown);
    // The body of a flight that describes others, too, is known: with it, ends are found more
    // surely, and flights that say little about their body.
    while (unknown.size() > 1) {
        const auto [body, n_described] = most_common(unknown);
        if (n_described < 2) break;
        body_ = unknown[body];
        for (const Stretch& stretch : unknown) mark(stretch, false);
        std::vector<Stretch> made = stretches_from(all);
        join(made);
        body_.reset();
        // Another body may describe a flight better.
        std::erase_if(made, [&](const Stretch& stretch) { return is_better_in(stretch, unknown); });
        if (made.empty()) break;
        known.insert(known.end(), made.begin(), made.end());
        const std::size_t n_before = unknown.size();
        std::erase_if(unknown, [&](const Stretch& stretch) { return is_partly_in(stretch, made); });
        for (const Stretch& stretch : unknown) mark(stretch, true);
        if (unknown.size() == n_before) break;
    }
    for (const Stretch& stretch : known) mark(stretch, true);
    for (Stretch& stretch : known) {
        if (!refit(stretch, stretch.begin, stretch.end)) continue;
        trim(stretch);
        grow(stretch);
        trim(stretch);
        mark(stretch, true);
    }
    // A body that flies once must fit closely where others fly often.
    std::erase_if(unknown, [&](const Stretch& stretch) {
        return !known.empty() && stretch.share * stretch.rate >
                                     std::max(most_single_share * stretch.rate,
                                              2.0 * noise_of(between(stretch.begin, stretch.end)));
    });
    unknown.insert(unknown.end(), known.begin(), known.end());
    std::sort(unknown.begin(), unknown.end(),
              [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    std::vector<FreeFlight> found;
    for (const Stretch& stretch : unknown) {
        const auto part = between(stretch.begin, stretch.end);
        found.push_back({{part.begin(), part.end()},
                         stretch.rate,
                         turn(stretch.begin, stretch.end),
                         stretch.share * stretch.rate,
                         noise_of(part)});
    }
    return found;
}

}  // namespace

std::vector<FreeFlight> flights_of(std::span<const MeasuredRow> rows) {
    return FlightFinder(rows).flights();
}

}  // namespace poinsot
