// Motions without a scene: states at instants, the constants of the motion, and the curves of
// Poinsot's construction.
#include <poinsot/construction.h>
#include <poinsot/error.h>
#include <poinsot/motion.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "library/mechanics/given_torque.h"
#include "python/bindings.h"

namespace poinsot::python {

namespace {

using library::Construction;
using library::Motion;
using library::State;

std::span<const double> span_of(const Doubles& values) {
    return {values.data(), static_cast<std::size_t>(values.size())};
}

// States at instants of any shape, quantity by quantity.
class States {
 public:
    States(const Motion& motion, std::span<const double> times_s, std::vector<py::ssize_t> shape)
        : shape_(std::move(shape)),
          n_(times_s.size()),
          values_(std::make_unique_for_overwrite<double[]>(11 * n_)) {
        if (n_ == 1) {
            put(motion.at(times_s.front()), 0);
            return;
        }
        constexpr std::size_t most_at_once = 64;
        std::array<State, most_at_once> states;
        for (std::size_t first = 0; first < n_; first += most_at_once) {
            stop_if_interrupted();
            const std::size_t n = std::min(most_at_once, n_ - first);
            motion.at(times_s.subspan(first, n), std::span(states).first(n));
            for (std::size_t i = 0; i < n; ++i) put(states[i], first + i);
        }
    }

    // One state, or what the arrays hold, in two lines.
    std::string repr() {
        const auto text = [](double number) {
            return py::str("{:.6g}").format(number).cast<std::string>();
        };
        const auto list = [&text](const double* numbers, int n) {
            std::string line = "(" + text(numbers[0]);
            for (int k = 1; k < n; ++k) line += ", " + text(numbers[k]);
            return line + ")";
        };
        if (n_ == 0) return "<poinsot.States, no instants>";
        if (shape_.empty())
            return "<poinsot.States at " + text(block(0)[0]) +
                   " s: omega_body = " + list(block(1), 3) +
                   " rad/s,\n space_from_body = " + list(block(4), 4) +
                   ", herpolhode = " + list(block(8), 3) + " rad/s>";
        double least = std::numeric_limits<double>::infinity(), most = 0.0;
        for (std::size_t i = 0; i < n_; ++i) {
            const double* omega = block(1) + 3 * i;
            const double rate = std::hypot(omega[0], omega[1], omega[2]);
            least = std::min(least, rate);
            most = std::max(most, rate);
        }
        const auto [first, last] = std::minmax_element(block(0), block(0) + n_);
        const auto shape = [this](py::ssize_t width) {
            py::list sizes;
            for (const py::ssize_t size : shape_) sizes.append(size);
            if (width > 0) sizes.append(width);
            return py::str(py::tuple(sizes)).cast<std::string>();
        };
        return "<poinsot.States, " + std::to_string(n_) + (n_ == 1 ? " instant" : " instants") +
               " from " + text(*first) + " to " + text(*last) + " s, |ω| from " + text(least) +
               " to " + text(most) + " rad/s:\n time_s " + shape(0) + ", omega_body " + shape(3) +
               ", space_from_body " + shape(4) + ", herpolhode " + shape(3) + ">";
    }

    // `first`: of the quantity's numbers among the 11 of a state; `width`: 0 for a number.
    static py::array quantity(const py::object& self, std::size_t first, py::ssize_t width) {
        auto& states = self.cast<States&>();
        std::vector<py::ssize_t> shape = states.shape_;
        if (width > 0) shape.push_back(width);
        return py::array_t<double>(std::move(shape), states.block(first), self);
    }

 private:
    double* block(std::size_t first) { return values_.get() + first * n_; }

    void put(const State& state, std::size_t i) {
        const library::Quaternion& q = state.space_from_body;
        block(0)[i] = state.time_s;
        std::copy_n(state.omega_body.data(), 3, block(1) + 3 * i);
        const std::array<double, 4> attitude{q.w(), q.x(), q.y(), q.z()};
        std::copy_n(attitude.data(), 4, block(4) + 4 * i);
        std::copy_n(state.herpolhode_space.data(), 3, block(8) + 3 * i);
    }

    std::vector<py::ssize_t> shape_;
    std::size_t n_;
    std::unique_ptr<double[]> values_;  // written as a whole
};

Eigen::Vector3d three(const char* name, const Doubles& values) {
    if (values.ndim() != 1 || values.shape(0) != 3)
        throw InputError(std::string(name) + ": give three numbers");
    return {values.at(0), values.at(1), values.at(2)};
}

// The kind, and its numbers by name.
using GivenTorque =
    std::pair<std::string, std::vector<std::pair<std::string, std::vector<double>>>>;

library::MotionOptions options_of(const Doubles& attitude, const std::string& method,
                                  std::optional<double> step_s, std::optional<double> tolerance,
                                  std::optional<int> order, std::pair<double, double> span_s,
                                  const GivenTorque& torque, bool allow_unphysical) {
    if (attitude.ndim() != 1 || attitude.shape(0) != 4)
        throw InputError("attitude: give a quaternion (w, x, y, z)");
    library::MotionOptions options;
    options.start_attitude =
        library::Quaternion(attitude.at(0), attitude.at(1), attitude.at(2), attitude.at(3));
    options.method = method;
    options.step_s = step_s;
    options.tolerance = tolerance;
    options.order = order;
    options.first_time_s = span_s.first;
    options.last_time_s = span_s.second;
    options.torque =
        library::given_torque(torque.first, {torque.second.begin(), torque.second.end()});
    options.allow_unphysical = allow_unphysical;
    return options;
}

// Asks the interpreter seldom enough not to slow stepping.
std::function<bool()> at_times(std::function<bool()> stop) {
    using Clock = std::chrono::steady_clock;
    return [stop = std::move(stop), next = Clock::time_point{}]() mutable {
        if (Clock::now() < next) return false;
        next = Clock::now() + std::chrono::milliseconds(20);
        return stop();
    };
}

Motion motion_of(const Doubles& moments, const Doubles& omega, const Doubles& attitude,
                 const std::string& method, std::optional<double> step_s,
                 std::optional<double> tolerance, std::optional<int> order,
                 std::pair<double, double> span_s, const GivenTorque& torque,
                 bool allow_unphysical) {
    library::MotionOptions options =
        options_of(attitude, method, step_s, tolerance, order, span_s, torque, allow_unphysical);
    const Eigen::Vector3d start = three("omega", omega);
    std::optional<Motion> made;
    const auto make = [&](const auto& body, auto maker) {
        InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
            options.stop = at_times(watch.stop);
            made = maker(body, start, options);
        });
        return *made;
    };
    if (moments.ndim() == 2 && moments.shape(0) == 3 && moments.shape(1) == 3) {
        Eigen::Matrix3d tensor;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) tensor(i, j) = moments.at(i, j);
        return make(tensor, &Motion::with_tensor);
    }
    if (moments.ndim() != 1 || moments.shape(0) != 3)
        throw InputError(
            "moments: give the three principal moments, or the inertia tensor (3 × 3)");
    return make(three("moments", moments),
                [](const auto&... arguments) { return Motion(arguments...); });
}

Motion heavy_top(double transverse, double axial, double mgl_N_m, double theta_rad,
                 double theta_dot_rad_s, double phi_dot_rad_s, double omega3_rad_s) {
    return Motion::heavy_top(transverse, axial, mgl_N_m,
                             {theta_rad, theta_dot_rad_s, phi_dot_rad_s, omega3_rad_s});
}

std::vector<py::ssize_t> shape_of(const Doubles& values) {
    return {values.shape(), values.shape() + values.ndim()};
}

// A number is the common case of one instant, and takes no array.
std::unique_ptr<States> at(const Motion& motion, const py::handle& times) {
    if (PyFloat_Check(times.ptr())) {
        const double time_s = PyFloat_AS_DOUBLE(times.ptr());
        return std::make_unique<States>(motion, std::span(&time_s, 1), std::vector<py::ssize_t>{});
    }
    const auto array =
        py::module_::import("poinsot.arrays").attr("seconds")("times", times).cast<Doubles>();
    std::vector<py::ssize_t> shape = shape_of(array);
    const std::span<const double> times_s = span_of(array);
    std::unique_ptr<States> states;
    const auto make = [&] { states = std::make_unique<States>(motion, times_s, std::move(shape)); };
    // Some milliseconds need no look at Ctrl-C.
    constexpr std::size_t few = 10'000;
    if (times_s.size() > few) {
        run_interruptibly(make);
    } else {
        const WithoutLock without_lock;
        make();
    }
    return states;
}

py::dict constants(const Motion& motion) {
    using namespace py::literals;
    const library::Constants c = motion.constants();
    const Construction construction(motion);
    return py::dict(
        "kinetic_energy_J"_a = c.kinetic_energy_J, "momentum_kg_m2_s"_a = c.momentum_kg_m2_s,
        "momentum_space"_a = c.momentum_space, "plane_distance"_a = construction.plane_distance(),
        "half_axes"_a = construction.half_axes(),
        "encircled_axis"_a =
            c.encircled_axis ? py::object(py::int_(*c.encircled_axis + 1)) : py::object(py::none()),
        "modulus"_a = c.modulus, "polhode_period_s"_a = c.polhode_period_s,
        "advance_per_period_rad"_a = c.advance_per_period_rad,
        "precession_rad_s"_a = c.precession_rad_s,
        "herpolhode_radii_rad_s"_a =
            py::make_tuple(c.least_herpolhode_rad_s, c.greatest_herpolhode_rad_s));
}

py::dict top_constants(const Motion& motion) {
    using namespace py::literals;
    const library::TopConstants c = motion.top_constants();
    return py::dict("p_phi_kg_m2_s"_a = c.p_phi_kg_m2_s, "p_psi_kg_m2_s"_a = c.p_psi_kg_m2_s,
                    "energy_J"_a = c.energy_J, "theta_min_rad"_a = c.theta_min_rad,
                    "theta_max_rad"_a = c.theta_max_rad,
                    "nutation_period_s"_a = c.nutation_period_s,
                    "precession_rad_s"_a = c.precession_rad_s);
}

py::object cones(const Motion& motion) {
    using namespace py::literals;
    const std::optional<library::Cones> found = Construction(motion).cones();
    if (!found) return py::none();
    return py::dict("symmetry_axis"_a = found->symmetry_axis + 1,
                    "body_half_angle_rad"_a = found->body_half_angle_rad,
                    "space_half_angle_rad"_a = found->space_half_angle_rad,
                    "body_precession_rad_s"_a = found->body_precession_rad_s,
                    "space_precession_rad_s"_a = found->space_precession_rad_s);
}

py::array points(const std::vector<Eigen::Vector3d>& curve, std::vector<py::ssize_t> shape) {
    std::vector<double> values;
    values.reserve(3 * curve.size());
    for (const Eigen::Vector3d& point : curve)
        values.insert(values.end(), {point.x(), point.y(), point.z()});
    shape.push_back(3);
    return array_of(std::move(values), std::move(shape));
}

py::array polhode(const Motion& motion, double tolerance) {
    if (!(tolerance >= 1e-9 && tolerance <= 1.0))
        throw InputError("tolerance: a share of the longest half-axis, from 1e-9 to 1");
    const Construction construction(motion);
    library::Polhode curve;
    {
        const WithoutLock without_lock;
        curve = construction.polhode(tolerance * construction.half_axes().maxCoeff());
        if (curve.closed && !curve.points.empty()) curve.points.push_back(curve.points.front());
    }
    return points(curve.points, {static_cast<py::ssize_t>(curve.points.size())});
}

// The contact points of instants in any shape, in space axes or body axes.
py::array contact(const Motion& motion, const Doubles& times, bool in_space) {
    const Construction construction(motion);
    std::vector<Eigen::Vector3d> found;
    run_interruptibly([&] {
        for (const double time_s : span_of(times)) {
            stop_if_interrupted();
            const library::ContactPoint point = construction.contact(time_s);
            found.push_back(in_space ? point.space : point.body);
        }
    });
    return points(found, shape_of(times));
}

py::list certificate(const Motion& motion, const Doubles& times, double attitude_error_rad) {
    using namespace py::literals;
    library::Certificate certified;
    {
        const WithoutLock without_lock;
        certified = Construction(motion).certificate(span_of(times), attitude_error_rad);
    }
    py::list claims;
    for (const library::Claim& claim : certified.claims)
        if (claim.n_measured > 0)
            claims.append(py::dict("name"_a = claim.name, "means"_a = claim.means,
                                   "worst"_a = claim.worst, "at_time_s"_a = claim.at_time_s,
                                   "bound"_a = claim.bound, "holds"_a = claim.holds()));
    return claims;
}

// space_from_body as SciPy's Rotation, whose quaternions are (x, y, z, w).
py::object scipy_rotation_of(const py::object& states) {
    using namespace py::literals;
    const py::object from_quat =
        py::module_::import("scipy.spatial.transform").attr("Rotation").attr("from_quat");
    const py::object wxyz = states.attr("space_from_body");
    const py::object xyzw = py::module_::import("numpy").attr("roll")(wxyz, -1, "axis"_a = -1);
    if (xyzw.attr("ndim").cast<int>() <= 2) return from_quat(xyzw);
    return from_quat(xyzw.attr("reshape")(-1, 4));
}

}  // namespace

void add_motion(py::module_& module) {
    using namespace py::literals;
    const auto quantity = [](std::size_t first, py::ssize_t width) {
        return
            [first, width](const py::object& self) { return States::quantity(self, first, width); };
    };
    py::class_<States>(module, "States", without_new())
        .def("__repr__", &States::repr)
        .def_property_readonly("time_s", quantity(0, 0))
        .def_property_readonly("omega_body", quantity(1, 3))
        .def_property_readonly("space_from_body", quantity(4, 4))
        .def_property_readonly("herpolhode", quantity(8, 3))
        .def_property_readonly("rotation",
                               [](const py::object& self) { return scipy_rotation_of(self); });
    const auto without_lock = py::call_guard<WithoutLock>();
    py::class_<Motion>(module, "Motion", without_new())
        .def_static("of_body", motion_of, "moments"_a, "omega"_a, "attitude"_a, "method"_a,
                    "step_s"_a, "tolerance"_a, "order"_a, "span_s"_a, "torque"_a,
                    "allow_unphysical"_a)
        .def_static("heavy_top", heavy_top, "transverse"_a, "axial"_a, "mgl_N_m"_a, "theta_rad"_a,
                    "theta_dot_rad_s"_a, "phi_dot_rad_s"_a, "omega3_rad_s"_a)
        .def("at", at, "times"_a)
        .def_property_readonly(
            "regime",
            [](const Motion& motion) { return std::string(library::name_of(motion.regime())); })
        .def_property_readonly("description", &Motion::regime_sentence)
        .def_property_readonly("principal_axes",
                               [](const Motion& motion) {
                                   using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
                                   return Rows(motion.body_from_principal().array() + 0.0);
                               })
        .def_property_readonly("moments", &Motion::moments_kg_m2)
        .def("constants", constants)
        .def("top_constants", top_constants)
        .def("cones", cones)
        .def("polhode", polhode, "tolerance"_a)
        .def("contact", contact, "times"_a, "in_space"_a)
        .def(
            "flips",
            [](const Motion& motion, double first_s, double last_s) {
                return Construction(motion).flips(first_s, last_s);
            },
            without_lock, "first_s"_a, "last_s"_a)
        .def("certificate", certificate, "times"_a, "attitude_error_rad"_a);
}

}  // namespace poinsot::python
