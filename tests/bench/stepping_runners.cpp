#include "bench/stepping_runners.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

namespace poinsot::bench {

namespace {

namespace odeint = boost::numeric::odeint;

Runner runner_of(const FreeBody& body, const std::vector<double>& times_s, double period_s,
                 const Method& method, int order) {
    const auto problem_at = [=, &method](int rung) {
        MotionProblem problem = problem_of(body);
        problem.last_time_s = times_s.back();
        problem.method.name = std::string(method.name);
        if (order > 0) problem.method.order = order;
        if (method.takes_step) problem.method.step_s = period_s / 8.0 * std::exp2(-0.5 * rung);
        if (method.takes_tolerance) problem.method.tolerance = 1e-3 * std::pow(10.0, -0.5 * rung);
        return problem;
    };
    Runner runner;
    runner.name = order > 0 ? fmt::format("{}-{}", method.name, order) : std::string(method.name);
    runner.setting = [=, &method](int rung) -> std::optional<std::string> {
        const MethodChoice choice = problem_at(rung).method;
        if (method.takes_tolerance && *choice.tolerance < least_tolerance) return std::nullopt;
        return method.takes_step ? fmt::format("step {:.3g} s", *choice.step_s)
                                 : fmt::format("tolerance {:.0e}", *choice.tolerance);
    };
    runner.run = [=](int rung) { return attitudes_of(Motion(problem_at(rung)), times_s); };
    return runner;
}

// ω in body axes and the attitude (x, y, z, w), with their rates, in any arithmetic.
template <typename Number>
using Numbers = std::array<Number, 7>;

template <typename Number>
struct Equations {
    explicit Equations(const FreeBody& body) {
        const Eigen::Vector3d& I = body.moments_kg_m2;
        for (int i = 0; i < 3; ++i) {
            coupling[static_cast<std::size_t>(i)] =
                (Number(I[(i + 1) % 3]) - Number(I[(i + 2) % 3])) / Number(I[i]);
        }
    }
    template <typename Time>
    void operator()(const Numbers<Number>& x, Numbers<Number>& rate, Time /*time_s*/) const {
        const Number half = 0.5;
        rate[0] = coupling[0] * x[1] * x[2];
        rate[1] = coupling[1] * x[2] * x[0];
        rate[2] = coupling[2] * x[0] * x[1];
        rate[3] = half * (x[6] * x[0] + x[4] * x[2] - x[5] * x[1]);
        rate[4] = half * (x[6] * x[1] + x[5] * x[0] - x[3] * x[2]);
        rate[5] = half * (x[6] * x[2] + x[3] * x[1] - x[4] * x[0]);
        rate[6] = -half * (x[3] * x[0] + x[4] * x[1] + x[5] * x[2]);
    }
    std::array<Number, 3> coupling{};
};

template <typename Number>
Numbers<Number> start_of(const FreeBody& body) {
    const Eigen::Vector3d& w = body.omega_rad_s;
    return {Number(w[0]), Number(w[1]), Number(w[2]), Number(0), Number(0), Number(0), Number(1)};
}
template <typename Number>
Eigen::Vector4d attitude_of(const Numbers<Number>& x) {
    return {static_cast<double>(x[3]), static_cast<double>(x[4]), static_cast<double>(x[5]),
            static_cast<double>(x[6])};
}

Runner odeint_dopri5(const FreeBody& body, const std::vector<double>& times_s) {
    const auto tolerance = [](int rung) { return 1e-4 * std::pow(10.0, -0.5 * rung); };
    Runner runner;
    runner.name = "Boost.odeint dopri5";
    runner.setting = [=](int rung) -> std::optional<std::string> {
        if (tolerance(rung) < 1e-15) return std::nullopt;
        return fmt::format("tolerance {:.0e}", tolerance(rung));
    };
    runner.run = [=](int rung) {
        auto stepper = odeint::make_dense_output(tolerance(rung), tolerance(rung),
                                                 odeint::runge_kutta_dopri5<Numbers<double>>());
        const Equations<double> equations(body);
        Numbers<double> x = start_of<double>(body);
        stepper.initialize(x, 0.0, times_s[1]);
        Attitudes attitudes{attitude_of(x)};
        attitudes.reserve(times_s.size());
        for (std::size_t k = 1; k < times_s.size(); ++k) {
            while (stepper.current_time() < times_s[k]) stepper.do_step(equations);
            stepper.calc_state(times_s[k], x);
            attitudes.push_back(attitude_of(x));
        }
        return attitudes;
    };
    return runner;
}

// An integral number of steps between frames, one more at each finer setting.
template <typename Number, template <typename...> typename Stepper>
Runner odeint_fixed(std::string name, const FreeBody& body, const std::vector<double>& times_s) {
    Runner runner;
    runner.name = std::move(name);
    runner.setting = [](int rung) { return fmt::format("{} steps a frame", rung + 1); };
    runner.run = [=](int rung) {
        Stepper<Numbers<Number>, Number, Numbers<Number>, Number> stepper;
        const Equations<Number> equations(body);
        Numbers<Number> x = start_of<Number>(body);
        const int n_steps = rung + 1;
        Attitudes attitudes{attitude_of(x)};
        attitudes.reserve(times_s.size());
        for (std::size_t k = 1; k < times_s.size(); ++k) {
            const Number step_s = (Number(times_s[k]) - Number(times_s[k - 1])) / n_steps;
            for (int n = 0; n < n_steps; ++n) stepper.do_step(equations, x, Number(0), step_s);
            attitudes.push_back(attitude_of(x));
        }
        return attitudes;
    };
    return runner;
}

template <typename... Types>
using Rk4 = odeint::runge_kutta4<Types...>;
template <typename... Types>
using Fehlberg78 = odeint::runge_kutta_fehlberg78<Types...>;

}  // namespace

Attitudes attitudes_of(const Motion& motion, const std::vector<double>& times_s) {
    Attitudes attitudes;
    attitudes.reserve(times_s.size());
    for (const double t : times_s) attitudes.push_back(motion.at(t).space_from_body.coeffs());
    return attitudes;
}

double worst_error(const Attitudes& a, const Attitudes& b) {
    double worst = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double apart = 2.0 * std::min((a[k] - b[k]).norm(), (a[k] + b[k]).norm());
        worst = std::isfinite(apart) ? std::max(worst, apart) : INFINITY;
    }
    return worst;
}

std::vector<Runner> runners_for(const FreeBody& body, const std::vector<double>& times_s,
                                std::size_t frames_a_period) {
    using boost::multiprecision::cpp_bin_float_quad;
    std::vector<Runner> runners{
        odeint_dopri5(body, times_s), odeint_fixed<double, Rk4>("Boost.odeint rk4", body, times_s),
        odeint_fixed<double, Fehlberg78>("Boost.odeint rkf78", body, times_s),
        odeint_fixed<long double, Fehlberg78>("rkf78 in 64 bits", body, times_s),
        odeint_fixed<cpp_bin_float_quad, Fehlberg78>("rkf78 in 113 bits", body, times_s)};
    runners.back().longest_run_s = 10.0;
    for (const Method& method : methods()) {
        if (method.make == nullptr) continue;
        for (const int order : method.orders) {
            runners.push_back(runner_of(body, times_s, times_s[frames_a_period], method,
                                        method.orders.size() > 1 ? order : 0));
        }
    }
    return runners;
}

}  // namespace poinsot::bench
