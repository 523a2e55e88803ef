#include "production/session/motion_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <variant>

#include "construction/flips.h"
#include "construction/near_closures.h"
#include "mechanics/free/free_rotation.h"
#include "mechanics/motion.h"
#include "mechanics/regime_sentence.h"
#include "scene/loop_text.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

// Instants named in words, and in JSON.
constexpr int most_named = 12;
constexpr int most_listed = 1000;

// Polhode periods of the longest loop suggested.
constexpr int most_loop_periods = 12;

std::string named_times(const std::vector<double>& times) {
    std::string text;
    for (std::size_t i = 0; i < times.size() && i < most_named; ++i)
        text += fmt::format("{}{:.6g}", i == 0 ? "" : ", ", times[i]);
    return times.size() > most_named ? text + ", \u2026" : text;
}

std::string json_times(const std::vector<double>& times) {
    std::vector<std::string> numbers;
    numbers.reserve(times.size());
    for (const double time : times) numbers.push_back(json_number(time));
    return json_list(numbers);
}

// "e2 swings from 15.9° to 164.1° from L, and e3 stays within 74.1° of L".
std::string swing_in_words(const AxisSwing& swing) {
    const double least_deg = swing.least_rad * 180.0 / std::numbers::pi;
    return fmt::format(
        "e{} swings from {:.1f}° to {:.1f}° from L, and e{} stays within {:.1f}° of {}L",
        swing.middle + 1, least_deg, 180.0 - least_deg, swing.encircled + 1, 90.0 - least_deg,
        swing.is_along_momentum ? "" : "\u2212");
}

}  // namespace

std::string motion_in_words(const Motion& motion) {
    std::string kind = regime_sentence(motion);
    const MotionProblem& problem = motion.problem();
    if (!is_free(problem.torque)) return kind;
    const FreeRotationConstants constants = motion.free_constants();
    const auto flips = flips_of(problem, constants);
    const bool is_elliptic = motion.regime() == Regime::elliptic_about_lowest ||
                             motion.regime() == Regime::elliptic_about_highest;
    if (const auto swing = swing_of(problem); is_elliptic && swing)
        kind += "; " + swing_in_words(*swing);
    if (!flips) return is_elliptic ? "does not turn over: " + kind : kind;
    return (flips->interval_s ? fmt::format("turns over every {:.3g} s: ", *flips->interval_s)
                              : "turns over once: ") +
           kind;
}

namespace {

// Adds the lines of the flips of a film. `beyond`: of those outside of it; `after`: how they go on.
void add_flip_times(const FilmPlan& film, int axis, const std::vector<double>& times,
                    const std::string& beyond, const std::string& after,
                    std::vector<SummaryLine>& lines) {
    std::vector<double> film_times;
    film_times.reserve(times.size());
    for (const double time_s : times)
        film_times.push_back(film.clock.film_second_of(time_s).value_or(0.0));
    const std::string text = times.empty()
                                 ? "none in the film" + beyond
                                 : fmt::format("at t = {} s of the motion ({} s of the film){}",
                                               named_times(times), named_times(film_times), after);
    lines.push_back(
        {"flips_s", json_times(times),
         fmt::format("flips (\u03c9 along e{}, the middle axis, changes its sign)", axis + 1),
         text});
    lines.push_back({"flips_film_s", json_times(film_times), "", ""});
}

}  // namespace

void add_flips(const Session& session, const FilmPlan& film, std::vector<SummaryLine>& lines) {
    const auto flips = flips_of(session.motion.problem(), session.motion.free_constants());
    if (!flips) return;
    const auto [first_s, last_s] = std::minmax({film.start_s, film.last_time_s()});
    const std::string interval =
        flips->interval_s ? fmt::format(", every {:.6g} s", *flips->interval_s) : ", once";
    add_flip_times(film, flips->axis, flips->between(first_s, last_s, most_listed),
                   fmt::format("; one at t = {:.6g} s{}", flips->one_s, interval), interval, lines);
    if (flips->interval_s)
        lines.push_back({"flip_interval_s", json_number(*flips->interval_s), "", ""});
}

void add_stepped_motion(const Session& session, const FilmPlan& film,
                        std::vector<SummaryLine>& lines) {
    const MotionProblem& problem = session.motion.problem();
    const auto [first_s, last_s] = std::minmax({film.start_s, film.last_time_s()});
    const Eigen::Matrix3d inertia = problem.inertia.matrix_body();
    const auto energy_of = [&](const Eigen::Vector3d& omega) {
        return 0.5 * omega.dot(inertia * omega);
    };
    const double at_start = energy_of(problem.start.omega_body);
    const double at_end = energy_of(session.motion.at(film.last_time_s()).omega_body);
    std::string change;
    if (at_start > 0.0 && at_end != at_start)
        change = at_end < at_start ? fmt::format(", {:.3g} % of T at t = 0 lost",
                                                 100.0 * (1.0 - at_end / at_start))
                                   : fmt::format(", {:.4g} times T at t = 0", at_end / at_start);
    lines.push_back({"end_kinetic_energy_J", json_number(at_end),
                     fmt::format("T at t = {:.6g} s", film.last_time_s()),
                     fmt::format("{:.9g} J{}", at_end, change)});
    const std::optional<int> axis = middle_axis(problem.inertia.moments_kg_m2());
    if (!axis) return;
    if (auto times = sampled_flips(session.motion, first_s, last_s)) {
        if (times->size() > most_listed) times->resize(most_listed);
        add_flip_times(film, *axis, *times, "", "", lines);
    }
}

void add_near_loops(const Session& session, std::vector<SummaryLine>& lines) {
    if (session.loop) return;
    const MotionProblem& problem = session.motion.problem();
    if (problem.on_separatrix) return;
    std::vector<std::string> loops;
    std::string text;
    for (const NearClosure& near :
         near_closures(problem.inertia, problem.start.omega_body, most_loop_periods)) {
        const std::string loop = fmt::format("{}/{}", near.closure.turns, near.closure.periods);
        const std::string changed =
            near.start.changed
                ? std::string(loop_values()[static_cast<std::size_t>(*near.start.changed)])
                : "";
        const Eigen::Vector3d& omega = near.start.omega_body;
        loops.push_back(fmt::format(
            "{{\"loop\": {}, \"changes\": {}, \"relative_change\": {}, \"omega_rad_s\": {}}}",
            json_string(loop), json_string(changed), json_number(near.relative_change),
            json_numbers(omega[0], omega[1], omega[2])));
        text += fmt::format("{}\"{}\" ({})", text.empty() ? "" : ", ", loop,
                            near.start.changed ? fmt::format("{} changes by {:.2g} % of |\u03c9|",
                                                             changed, 100.0 * near.relative_change)
                                               : "closed already");
    }
    if (text.empty()) return;
    lines.push_back({"near_loops", json_list(loops), "film.loop nearby", text});
}

}  // namespace poinsot
