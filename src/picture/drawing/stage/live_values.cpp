#include "drawing/stage/live_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "construction/montgomery_phase.h"
#include "construction/quantities.h"
#include "drawing/stage/type/clock_text.h"
#include "error/error.h"
#include "numerics/power_of_two.h"
#include "scene/film_clock.h"
#include "text/languages.h"
#include "text/nearest.h"
#include "text/units.h"

namespace poinsot {

namespace {

// Quantities of which a caption may name every component, with and without its unit, and the
// symbol.
constexpr std::string_view in_captions[] = {"time", "omega", "omega_body", "kinetic_energy",
                                            "momentum"};

// Of the scene's motion. Throws InputError if it has none; `name`: the number that needs it.
MontgomeryPhase phase_for(std::string_view name, const Scene& scene) {
    if (const auto phase = montgomery_phase(problem_of(scene))) return *phase;
    throw InputError(fmt::format(
        "{{{}}} needs a torque-free motion whose polhode has a period; leave it out", name));
}

}  // namespace

std::vector<LiveValue> live_values(const Scene& scene, const FrameInput& instant,
                                   std::string_view text) {
    std::vector<LiveValue> values{{"time_h", instant.time_s / 3600.0, "h"},
                                  {"time_d", instant.time_s / 86400.0, "d"}};
    // In the unit in which the scene shows such a quantity, which the number brings along.
    const auto add = [&](std::string_view name, double value, std::string_view unit) {
        const ShownUnit shown = unit_shown(scene.units, unit);
        values.push_back({std::string(name), value * shown.per_SI, shown.name, true});
    };
    MotionSample sample = instant;
    sample.state.time_s = instant.time_s;
    for (const std::string_view name : in_captions) {
        const Quantity& quantity = *find_row(quantities(), name);
        std::array<double, 3> numbers{};
        quantity.values({scene.body.inertia}, sample, numbers.data());
        const std::string_view unit = quantity.unit.printed;
        for (std::size_t i = 0; i < quantity.components.size(); ++i) {
            values.push_back({name_with_unit(quantity, i), numbers[i], std::string(unit)});
            add(quantity.components[i], numbers[i], unit);
        }
        if (!quantity.symbol.empty()) add(quantity.symbol, numbers[0], unit);
    }
    add("omega", norm_of(instant.state.omega_body), "rad/s");
    const ClockText clock(scene.film.start_s, film_end_time_s(scene));
    for (LiveValue& value : values)
        if (value.name == "t" || value.name == "time")
            value.format = clock.format_in(unit_shown(scene.units, "s").per_SI);
    // Rows of three numbers that are the same at every instant.
    const auto add_row = [&](std::string_view name, const Eigen::Vector3d& row,
                             std::string_view unit) {
        add(name, 1.0, unit);
        LiveValue& value = values.back();
        for (const double number : row) value.row.push_back(value.value * number);
        value.format = ".4g";
        value.is_constant = true;
    };
    add_row("I", scene.body.inertia.moments_kg_m2(), "kg m²");
    add_row("omega_start", scene.start.omega_rad_s, "rad/s");
    const auto n_of_instant = static_cast<std::ptrdiff_t>(values.size());
    const auto add_phase = [&](const MontgomeryPhase& phase) {
        add("period", phase.period_s, "s");
        add("phase", phase.turned_rad, "rad");
        add("dynamic_phase", phase.dynamic_rad, "rad");
        add("solid_angle", phase.solid_angle_rad, "rad");
    };
    add_phase({});
    for (const std::string_view name : numbers_in(text, values)) {
        const LiveValue* value = find_row(values, name);
        if (value - values.data() < n_of_instant) continue;
        const MontgomeryPhase phase = phase_for(name, scene);
        values.resize(static_cast<std::size_t>(n_of_instant));
        add_phase(phase);
        break;
    }
    return values;
}

bool changes(const Scene& scene, std::string_view text) {
    if (!is_live(text)) return false;
    const std::vector<LiveValue> values = live_values(scene, {});
    const std::vector<std::string_view> names = numbers_in(text, values);
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return !find_row(values, name)->is_constant; });
}

std::string live_text(const Scene& scene, std::string_view text, const FrameInput& instant) {
    return expand_live_text(text, live_values(scene, instant, text),
                            decimal_mark_of(scene.language));
}

}  // namespace poinsot
