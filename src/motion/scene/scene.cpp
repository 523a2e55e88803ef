#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "numerics/power_of_two.h"
#include "scene/film_clock.h"
#include "scene/scene_error.h"

namespace poinsot {

std::string SourceLocation::prefix() const {
    if (line == 0) return fmt::format("{}: ", printable(file));
    return fmt::format("{}:{}:{}: ", printable(file), line, column);
}

SourceLocation Scene::location_of(const std::string& key) const {
    // The key itself, then the array that it is an item of, then each table above it.
    std::string path = key;
    while (true) {
        const auto found = locations.find(path);
        if (found != locations.end()) return found->second;
        const std::size_t end = path.find_last_of(".[");
        if (end == std::string::npos) break;
        path.resize(end);
    }
    return {file.string(), 1, 1};
}

std::string Scene::where(const std::string& key) const { return location_of(key).prefix(); }

double overshoot_s(const MotionProblem& problem) {
    // A history's last piece lasts at most a quarter of the fastest turn that ω can make about L,
    // (π/2)·I_min/L ≤ (π/2)/|ω|.
    const double rate = norm_of(problem.start.omega_body);
    const double span_s = problem.last_time_s - problem.first_time_s;
    return rate > 0.0 ? std::min(2.0 / rate, longest_piece_spans * span_s) : 0.0;
}

MotionProblem problem_of(const Scene& scene) {
    MotionProblem problem;
    problem.inertia = scene.body.inertia;
    problem.start = {0.0, scene.start.space_from_body, scene.start.omega_rad_s};
    problem.top_start = scene.start.top;
    const ConservedStartSpec* conserved = scene.start.given_by_conserved();
    problem.on_separatrix = conserved != nullptr && conserved->start.on_separatrix;
    problem.torque = scene.torque;
    problem.method = scene.method;

    const double still_s = scene.film.still_s.value_or(scene.film.start_s);
    problem.first_time_s = std::min({0.0, scene.film.start_s, still_s});
    problem.last_time_s = std::max({0.0, film_end_time_s(scene), still_s});
    problem.overshoot_s = overshoot_s(problem);
    return problem;
}

std::vector<std::string> controls_of(const Scene& scene) {
    if (scene.page.controls) return *scene.page.controls;
    if (!is_free(scene.torque) || scene.start.top || !scene.film.loop.empty() ||
        scene.measured.given() || !scene.construction.sweep.empty())
        return {};
    const ConservedStartSpec* conserved = scene.start.given_by_conserved();
    std::vector<std::string> controls{conserved != nullptr ? "start.energy_J"
                                                           : "start.omega_rad_s"};
    if (scene.body.given == BodySpec::Given::moments) controls.emplace_back("body.moments_kg_m2");
    return controls;
}

}  // namespace poinsot
