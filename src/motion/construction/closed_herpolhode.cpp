#include "construction/closed_herpolhode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "error/error.h"
#include "mechanics/free/free_rotation.h"
#include "numerics/bracketed_root.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// Largest allowed change of the start, in |ω|.
constexpr double reach = 0.5;
constexpr double closed_turns = 1e-12;

// Advance of the herpolhode in one polhode period, in turns, and the axis that the polhode
// encircles: the advance is continuous as long as this axis stays the same, and has a pole at the
// separatrix.
struct Advance {
    double turns = 0.0;
    int axis = 0;
    double period_s = 0.0;
};

std::optional<Advance> advance_of(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body) {
    if (omega_body.isZero(0.0)) return std::nullopt;
    RotationState start;
    start.omega_body = omega_body;
    const FreeRotationConstants constants = FreeRotation(inertia, start).constants();
    if (!constants.polhode_period_s || !constants.advance_per_period_rad) return std::nullopt;
    return Advance{*constants.advance_per_period_rad / (2.0 * std::numbers::pi),
                   constants.encircled_axis, *constants.polhode_period_s};
}

// The motions that differ from a given one in one component of ω.
class Family {
 public:
    Family(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body, int component)
        : inertia_(inertia), omega_(omega_body), component_(component) {}

    double given() const { return omega_[component_]; }
    int component() const { return component_; }
    Eigen::Vector3d omega(double value) const {
        Eigen::Vector3d changed = omega_;
        changed[component_] = value;
        return changed;
    }
    std::optional<Advance> advance(double value) const {
        return advance_of(inertia_, omega(value));
    }

 private:
    const InertiaTensor& inertia_;
    Eigen::Vector3d omega_;
    int component_;
};

struct Sample {
    double value = 0.0;
    Advance advance;
};

// Values of the component with their advances, from the given value outwards on one side, as far as
// the polhode encircles the same axis. The distances grow in constant ratios, so that a small
// change is found as reliably as a large one; towards a separatrix the values come closer and
// closer to it.
std::vector<Sample> samples_outwards(const Family& family, const Advance& here, double span) {
    std::vector<Sample> samples{{family.given(), here}};
    constexpr int n_steps = 160;
    constexpr double first = 1e-9;  // of the span
    double inside = family.given();
    for (int k = 0; k <= n_steps; ++k) {
        const double value = family.given() + span * std::pow(first, 1.0 - 1.0 * k / n_steps);
        const auto advance = family.advance(value);
        if (advance && advance->axis == here.axis) {
            samples.push_back({value, *advance});
            inside = value;
            continue;
        }
        double outside = value;
        for (int round = 0; round < 60; ++round) {
            const double middle = 0.5 * (inside + outside);
            const auto there = family.advance(middle);
            if (there && there->axis == here.axis) {
                samples.push_back({middle, *there});
                inside = middle;
            } else {
                outside = middle;
            }
        }
        break;
    }
    return samples;
}

// The smallest change on this side for which the advance has the wanted value.
std::optional<double> nearest_root(const Family& family, const std::vector<Sample>& samples,
                                   double wanted_turns) {
    const auto excess = [&](double value) {
        const auto advance = family.advance(value);
        return advance ? advance->turns - wanted_turns : std::numeric_limits<double>::quiet_NaN();
    };
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double from = samples[i - 1].advance.turns - wanted_turns;
        const double to = samples[i].advance.turns - wanted_turns;
        if (std::signbit(from) == std::signbit(to) && from != 0.0 && to != 0.0) continue;
        return bracketed_root(excess, std::min(samples[i - 1].value, samples[i].value),
                              std::max(samples[i - 1].value, samples[i].value));
    }
    return std::nullopt;
}

// The fraction nearest to the wanted one between two numbers of turns: with as many periods if
// possible, otherwise with the fewest.
Closure nearest_closure(const Closure& wanted, double least, double most) {
    const auto within = [&](int periods) -> std::optional<Closure> {
        const double turns = 1.0 * wanted.turns * periods / wanted.periods;
        const double nearest =
            std::clamp(std::round(turns), std::ceil(least * periods),
                       std::max(std::ceil(least * periods), std::floor(most * periods)));
        if (nearest < 1.0 || nearest < least * periods || nearest > most * periods) return {};
        const int p = static_cast<int>(nearest);
        const int common = std::gcd(p, periods);
        return Closure{p / common, periods / common};
    };
    if (const auto same = within(wanted.periods)) return *same;
    for (int periods = 1; periods <= 1000; ++periods) {
        if (const auto found = within(periods)) return *found;
    }
    return {0, 1};
}

}  // namespace

ClosedStart close_herpolhode(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                             const Closure& closure, std::optional<int> component) {
    const double wanted_turns = 1.0 * closure.turns / closure.periods;
    const auto here = advance_of(inertia, omega_body);
    if (!here) {
        throw InputError(
            "this motion has no polhode period, so its herpolhode is a point or never closes; "
            "start away from the principal axes and the separatrix");
    }
    if (std::abs(here->turns - wanted_turns) <= closed_turns * std::max(1.0, wanted_turns)) {
        return {omega_body, {}, here->period_s, here->turns};
    }

    std::optional<ClosedStart> best;
    double best_change = std::numeric_limits<double>::infinity();
    double least = here->turns;
    double most = here->turns;
    for (int i = 0; i < 3; ++i) {
        if (component && *component != i) continue;
        const Family family(inertia, omega_body, i);
        for (const double side : {-1.0, 1.0}) {
            const double span = side * reach * norm_of(omega_body);
            const std::vector<Sample> samples = samples_outwards(family, *here, span);
            for (const Sample& sample : samples) {
                least = std::min(least, sample.advance.turns);
                most = std::max(most, sample.advance.turns);
            }
            const auto root = nearest_root(family, samples, wanted_turns);
            if (!root || std::abs(*root - family.given()) >= best_change) continue;
            const auto advance = family.advance(*root);
            best_change = std::abs(*root - family.given());
            best = {family.omega(*root), i, advance->period_s, advance->turns};
        }
    }
    if (best) return *best;
    const Closure near = nearest_closure(closure, least, most);
    throw InputError(fmt::format(
        "no start near this one closes after {} polhode period{} with {} turn{}: {} by up to half "
        "of |omega| makes the herpolhode advance by {:.4g} to {:.4g} turns per period; {}",
        closure.periods, closure.periods == 1 ? "" : "s", closure.turns,
        closure.turns == 1 ? "" : "s",
        component ? fmt::format("changing omega_{}", *component + 1) : "changing one component",
        least, most,
        near.turns > 0 ? fmt::format("the nearest is \"{}/{}\"", near.turns, near.periods)
                       : "choose another start"));
}

}  // namespace poinsot
