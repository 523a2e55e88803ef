#include "mechanics/methods.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "error/error.h"
#include "mechanics/top/heavy_top.h"
#include "text/nearest.h"

namespace poinsot {

// The functions of the rows, defined in stepped/.

// Explicit, for any torque.
Propagator euler(const MethodStart& start);   // order 1
Propagator rk4(const MethodStart& start);     // order 4
Propagator dopri5(const MethodStart& start);  // order 5, adaptive, dense output of order 4
// Runge–Kutta–Munthe-Kaas of order 4 for the attitude, with L in space: L is kept without a torque.
Propagator rkmk4(const MethodStart& start);

// Implicit midpoint rule in momentum with a Cayley update of the attitude, order 2: keeps L in
// space and T to rounding at every step.
Propagator midpoint(const MethodStart& start);

// Strang splitting into exact rotations about the principal axes, order 2: symplectic, keeps L in
// space; with gravity, half a kick before and after.
Propagator splitting(const MethodStart& start);

// Preprocessed discrete Moser–Veselov algorithm of order 2, 4, 6, 8 or 10: keeps L in space and T
// to rounding at every step.
Propagator dmv(const MethodStart& start);

namespace {

constexpr std::array order_1{1};
constexpr std::array order_2{2};
constexpr std::array order_4{4};
constexpr std::array order_5{5};
constexpr std::array even_orders{2, 4, 6, 8, 10};

constexpr std::array method_rows{
    Method{.name = "exact",
           .summary = "closed form; every instant has the same cost and is accurate to rounding",
           .source = "Jacobi 1849; Klein & Sommerfeld, Theorie des Kreisels",
           .conserves = "everything, to rounding",
           .torques = TorquesTaken::with_potential},
    Method{
        .name = "euler",
        .summary = "Euler's explicit method, order 1: shows what a bad integrator does",
        .source = "Hairer, Nørsett & Wanner, Solving ODEs I, §I.7",
        .conserves =
            "nothing: T and L grow (with internal friction, L in space is conserved to rounding)",
        .orders = order_1,
        .takes_step = true,
        .torques = TorquesTaken::all,
        .make = euler},
    Method{.name = "rk4",
           .summary = "the classical Runge–Kutta method, order 4",
           .source = "Hairer, Nørsett & Wanner, Solving ODEs I, §II.1",
           .conserves =
               "nothing exactly: T and L drift steadily (with internal friction, L in space is "
               "conserved to rounding)",
           .orders = order_4,
           .takes_step = true,
           .torques = TorquesTaken::all,
           .make = rk4},
    Method{.name = "dopri5",
           .summary = "Dormand & Prince 5(4) with step control and dense output",
           .source = "Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19; Boost.odeint",
           .conserves = "nothing exactly: T and L drift by at most the tolerance in each step "
                        "(with internal friction, L in space is conserved to rounding)",
           .orders = order_5,
           .takes_tolerance = true,
           .torques = TorquesTaken::all,
           .make = dopri5},
    Method{.name = "midpoint",
           .summary = "implicit midpoint rule with a Cayley update, order 2",
           .source = "Austin, Krishnaprasad & Wang, J. Comput. Phys. 107 (1993) 105",
           .conserves = "T and L in space, to rounding",
           .orders = order_2,
           .takes_step = true,
           .torques = TorquesTaken::none,
           .make = midpoint},
    Method{
        .name = "splitting",
        .summary = "symplectic Strang splitting into rotations about the principal axes, order 2",
        .source = "McLachlan, Phys. Rev. Lett. 71 (1993) 3043; Reich, Physica D 76 (1994) 375",
        .conserves = "L in space to rounding without torque; the energy error stays bounded",
        .orders = order_2,
        .takes_step = true,
        .torques = TorquesTaken::with_potential,
        .make = splitting},
    Method{.name = "dmv",
           .summary = "preprocessed discrete Moser–Veselov algorithm, orders 2 to 10",
           .source = "Hairer & Vilmart, J. Phys. A 39 (2006) 13225",
           .conserves = "T and L in space, to rounding",
           .orders = even_orders,
           .takes_step = true,
           .torques = TorquesTaken::none,
           .make = dmv},
    Method{.name = "rkmk4",
           .summary = "Runge–Kutta–Munthe-Kaas on the rotation group, order 4",
           .source = "Munthe-Kaas, BIT 38 (1998) 92; Iserles et al., Acta Numerica 9 (2000) 215",
           .conserves = "L in space to rounding without torque; T drifts",
           .orders = order_4,
           .takes_step = true,
           .torques = TorquesTaken::all,
           .make = rkmk4},
};

std::string joined(const std::vector<std::string_view>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

bool is_exact(const Method& method) { return method.make == nullptr; }

// The options that the method accepts, for a message about one that it does not accept.
std::string options_of(const Method& method) {
    if (method.takes_step) return "give step_s";
    if (method.takes_tolerance) return "give tolerance";
    return "it needs neither step nor tolerance: leave both out";
}

void check_step(double step_s) {
    if (!(step_s > 0.0) || !std::isfinite(step_s)) {
        throw InputError(fmt::format("step_s is {} s; give a positive number of seconds", step_s));
    }
}

void check_tolerance(double tolerance) {
    if (!(tolerance >= least_tolerance)) {
        throw InputError(
            fmt::format("tolerance {} is finer than double precision allows; give {} or more",
                        tolerance, least_tolerance));
    }
    if (!(tolerance < 1.0)) {
        throw InputError(
            fmt::format("tolerance {} is too large; give a number below 1", tolerance));
    }
}

void check_order(const Method& method, int order) {
    if (std::find(method.orders.begin(), method.orders.end(), order) != method.orders.end()) return;
    if (method.orders.empty()) {
        throw InputError(
            fmt::format("method \"{}\" has only one order; leave order out", method.name));
    }
    throw InputError(fmt::format("method \"{}\" has no order {}; its orders are {}", method.name,
                                 order, fmt::join(method.orders, ", ")));
}

}  // namespace

std::span<const Method> methods() { return method_rows; }

const Method& find_method(std::string_view name) {
    if (const Method* row = find_row(method_rows, name)) return *row;
    throw InputError(unknown("method", name, names_of(method_rows)));
}

bool can_solve(const Method& method, const InertiaTensor& inertia, const Torque& torque) {
    if (method.torques == TorquesTaken::none && !is_free(torque)) return false;
    if (method.torques == TorquesTaken::with_potential && !kind_of(torque).has_potential)
        return false;
    const auto* gravity = std::get_if<Gravity>(&torque);
    return !is_exact(method) || gravity == nullptr || gravity->mgl_N_m == 0.0 ||
           HeavyTop::accepts(inertia, *gravity);
}

std::string methods_that_solve(const InertiaTensor& inertia, const Torque& torque) {
    std::vector<std::string_view> names;
    for (const Method& method : method_rows) {
        if (can_solve(method, inertia, torque)) names.push_back(method.name);
    }
    return joined(names);
}

const Method& check_method(const MethodChoice& choice, const InertiaTensor& inertia,
                           const Torque& torque) {
    const Method& method = find_method(choice.name);
    if (!can_solve(method, inertia, torque)) {
        const bool asymmetric_top = is_exact(method) && has_weight(torque);
        throw InputError(fmt::format(
            "method \"{}\" has no solution for {}; choose one of {}", method.name,
            asymmetric_top ? std::string("gravity on a body that is not symmetric about the arm "
                                         "(not integrable)")
                           : fmt::format("the torque \"{}\"", kind_of(torque).name),
            methods_that_solve(inertia, torque)));
    }
    if (choice.order) check_order(method, *choice.order);
    if (choice.step_s && !method.takes_step) {
        throw InputError(
            fmt::format("method \"{}\" takes no step_s; {}", method.name, options_of(method)));
    }
    if (choice.tolerance && !method.takes_tolerance) {
        throw InputError(
            fmt::format("method \"{}\" takes no tolerance; {}", method.name, options_of(method)));
    }
    if (choice.step_s) check_step(*choice.step_s);
    if (choice.tolerance) check_tolerance(*choice.tolerance);
    return method;
}

}  // namespace poinsot
