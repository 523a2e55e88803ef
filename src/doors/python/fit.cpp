// Fits of measured motions: the body behind rows of ω, the flights of a recording, predictions.
#include "measured/fit.h"

#include <poinsot/error.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "measured/flights.h"
#include "measured/joint_fit.h"
#include "measured/measured_motion.h"
#include "measured/prediction.h"
#include "orders/fitted_rows.h"
#include "production/fits/fit_flights.h"
#include "production/fits/fitted_scene.h"
#include "production/vectors/flight_page.h"
#include "python/bindings.h"

namespace poinsot::python {

namespace {

using Rows = std::vector<MeasuredRow>;
using Maybe = std::optional<Doubles>;

Eigen::Quaterniond rotation_of(const double* wxyz, py::ssize_t row) {
    const Eigen::Quaterniond q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    constexpr double tolerance = 1e-3;
    if (!(std::abs(q.norm() - 1.0) <= tolerance))
        throw InputError("attitude: the quaternion of row " + std::to_string(row) +
                         " has not the length 1; give unit quaternions (w, x, y, z)");
    return q.normalized();
}

void check_shape(const char* name, const Doubles& values, py::ssize_t n, py::ssize_t width) {
    if (values.ndim() == 2 && values.shape(0) == n && values.shape(1) == width) return;
    throw InputError(std::string(name) + ": give an array of shape (" + std::to_string(n) + ", " +
                     std::to_string(width) + "), a row for each instant");
}

// Rows from arrays of shape (n,), (n, 3) and (n, 4). Instants increase, and all numbers are finite.
Rows rows_of(const Doubles& times, const Maybe& omega, const Maybe& attitude) {
    if (times.ndim() != 1) throw InputError("times: give an array of one dimension, in seconds");
    const py::ssize_t n = times.shape(0);
    if (n == 0) throw InputError("times: there is no row; give instants with values");
    if (omega) check_shape("omega", *omega, n, 3);
    if (attitude) check_shape("attitude", *attitude, n, 4);
    Rows rows(static_cast<std::size_t>(n));
    for (py::ssize_t i = 0; i < n; ++i) {
        MeasuredRow& row = rows[static_cast<std::size_t>(i)];
        const auto refuse = [i](const char* name, const std::string& what) {
            throw InputError(std::string(name) + ": row " + std::to_string(i) + " " + what);
        };
        row.time_s = times.at(i);
        if (!std::isfinite(row.time_s)) refuse("times", "is not finite; leave it out");
        if (i > 0 && !(row.time_s > times.at(i - 1)))
            refuse("times", "does not come after the row before it; sort the rows, each once");
        if (omega) row.omega_body = Eigen::Map<const Eigen::Vector3d>(omega->data(i, 0));
        if (!row.omega_body.allFinite())
            refuse("omega", "is not finite; leave out rows without values");
        if (attitude) row.space_from_body = rotation_of(attitude->data(i, 0), i);
    }
    return rows;
}

// ω of attitudes alone follows from their differences.
MeasuredMotion measured_of(const Doubles& times, const Maybe& omega, const Maybe& attitude) {
    MeasuredMotion measured{rows_of(times, omega, attitude), omega.has_value(),
                            attitude.has_value()};
    if (!omega && measured.rows.size() < 2)
        throw InputError("attitude: no ω follows from one attitude; give two or more rows");
    add_omega_by_differences(measured);
    return measured;
}

py::array triples(const std::vector<Eigen::Vector3d>& vectors) {
    std::vector<double> values;
    values.reserve(3 * vectors.size());
    for (const Eigen::Vector3d& vector : vectors)
        values.insert(values.end(), {vector.x(), vector.y(), vector.z()});
    return array_of(std::move(values), {static_cast<py::ssize_t>(vectors.size()), 3});
}

// "times", "omega", "attitude" and which of them was measured; None for attitudes if there are
// none.
py::dict columns_of(const MeasuredMotion& measured) {
    using namespace py::literals;
    const Rows& rows = measured.rows;
    const bool has_attitude = measured.has_attitude;
    const auto n = static_cast<py::ssize_t>(rows.size());
    std::vector<double> times, attitudes;
    std::vector<Eigen::Vector3d> omegas;
    for (const MeasuredRow& row : rows) {
        times.push_back(row.time_s);
        omegas.push_back(row.omega_body);
        const Eigen::Quaterniond& q = row.space_from_body;
        if (has_attitude) attitudes.insert(attitudes.end(), {q.w(), q.x(), q.y(), q.z()});
    }
    py::object attitude = py::none();
    if (has_attitude) attitude = array_of(std::move(attitudes), {n, 4});
    return py::dict("times"_a = array_of(std::move(times), {n}), "omega"_a = triples(omegas),
                    "attitude"_a = attitude,
                    "measured"_a = measured.has_omega ? "omega" : "attitude");
}

py::tuple table(const std::string& text, const std::string& name) {
    const MeasuredMotion measured = read_measured(text, name);
    const py::dict held = columns_of(measured);
    return py::make_tuple(held["times"],
                          measured.has_omega ? py::object(held["omega"]) : py::none(),
                          held["attitude"]);
}

std::optional<Eigen::Vector3d> known_moments(const Maybe& moments) {
    if (!moments) return std::nullopt;
    if (moments->ndim() != 1 || moments->shape(0) != 3)
        throw InputError("moments: give the three principal moments in kg m²");
    const Eigen::Vector3d known(moments->at(0), moments->at(1), moments->at(2));
    if (!(known.minCoeff() > 0.0) || !known.allFinite())
        throw InputError("moments: give three positive numbers in kg m²");
    try {
        check_known_moments(known);
    } catch (const InputError& error) {
        throw InputError(std::string("moments: ") + error.what());
    }
    return known;
}

std::optional<DragModel> known_drag(const std::optional<std::string>& name) {
    if (!name) return std::nullopt;
    std::string names;
    for (const DragModel drag : drag_models) {
        if (*name == name_of(drag)) return drag;
        names += (names.empty() ? "" : ", ") + std::string(name_of(drag));
    }
    throw InputError("drag: is " + shown(py::str(*name)) + "; choose one of " + names +
                     ", or leave it out");
}

// (w, x, y, z).
py::object numbers_of(const std::optional<Eigen::Quaterniond>& q) {
    if (!q) return py::none();
    return py::cast(Eigen::Vector4d(q->w(), q->x(), q->y(), q->z()));
}

// All of a fit, from which fit_of makes the same again.
py::dict dict_of(const FittedMotion& fit) {
    using namespace py::literals;
    return py::dict(
        "first_time_s"_a = fit.first_time_s, "omega"_a = fit.omega_rad_s,
        "omega_sd"_a = fit.omega_sd_rad_s, "moments"_a = fit.moments,
        "moments_sd"_a = fit.moments_sd, "I1_kg_m2"_a = fit.I1_kg_m2,
        "axes"_a = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(fit.instrument_from_principal),
        "axes_sd"_a = fit.axes_sd_rad, "drag"_a = std::string(name_of(fit.drag)),
        "drag_rates"_a = fit.drag_rates, "drag_rates_sd"_a = fit.drag_rates_sd,
        "attitude"_a = numbers_of(fit.attitude), "unit"_a = std::string(fit.unit()),
        "residual"_a = fit.residual, "noise"_a = fit.noise, "correlation"_a = fit.correlation,
        "n_rows"_a = fit.n_rows, "excess"_a = excess_of(fit));
}

// What ω(t) and scenes need.
FittedMotion fit_of(const py::dict& found) {
    const auto vector = [&found](const char* name) -> Eigen::Vector3d {
        return Eigen::Map<const Eigen::Vector3d>(found[name].cast<Doubles>().data());
    };
    using Rows3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    FittedMotion fit;
    fit.first_time_s = found["first_time_s"].cast<double>();
    fit.omega_rad_s = vector("omega");
    fit.moments = vector("moments");
    fit.I1_kg_m2 = found["I1_kg_m2"].cast<std::optional<double>>();
    fit.instrument_from_principal = Eigen::Map<const Rows3>(found["axes"].cast<Doubles>().data());
    fit.drag = *known_drag(found["drag"].cast<std::string>());
    fit.drag_rates = vector("drag_rates");
    if (!found["attitude"].is_none())
        fit.attitude = rotation_of(found["attitude"].cast<Doubles>().data(), 0);
    return fit;
}

py::object dict_of(const std::optional<Prediction>& made) {
    using namespace py::literals;
    if (!made) return py::none();
    const auto pair = [](const std::optional<Predicted>& number) -> py::object {
        if (!number) return py::none();
        return py::make_tuple(number->value, number->sd);
    };
    return py::dict("n_fitted"_a = made->n_fitted, "n_predicted"_a = made->n_rest,
                    "residual"_a = made->residual, "rms"_a = made->rms,
                    "largest"_a = py::make_tuple(made->largest, made->largest_at_s),
                    "period_s"_a = pair(made->period_s),
                    "measured_period_s"_a = made->measured_period_s,
                    "flip_s"_a = pair(made->flip_s), "measured_flip_s"_a = made->measured_flip_s);
}

// A refusal says which number it is about.
template <typename Make>
Prediction predicted(int n_rows, const Make& make) {
    const std::string name = "predict " + std::to_string(n_rows) + ": ";
    if (n_rows < 1) throw InputError(name + "give the number of rows that are fitted");
    try {
        return make(static_cast<std::size_t>(n_rows));
    } catch (const InputError& error) {
        throw InputError(name + error.what());
    }
}

// The rows as one flight, if the caller says so, or the flight of theirs that says most about the
// body; with the rows that are fitted.
py::dict fit(const Doubles& times, const Maybe& omega, const Maybe& attitude, bool is_flight,
             const Maybe& moments, const std::optional<std::string>& drag,
             std::optional<int> predict) {
    MeasuredMotion measured{rows_of(times, omega, attitude), omega.has_value(),
                            attitude.has_value()};
    const FitKnown known{known_moments(moments), known_drag(drag)};
    FitTable table;
    std::optional<Prediction> prediction;
    const TableFlight* best = nullptr;
    run_interruptibly([&] {
        table = is_flight ? table_of_flight(std::move(measured), "", known)
                          : fitted_table(std::move(measured), "", known);
        best = &best_of(table);
        if (!best->fit) throw InputError(best->refusal);
        if (predict)
            prediction = predicted(*predict, [&](std::size_t n_rows) {
                return predicted_alone(best->measured.rows, n_rows, known.moments_kg_m2,
                                       known.drag);
            });
    });
    py::dict made = dict_of(*best->fit);
    made["notes"] = notes_of(table, *best);
    made["rows"] = columns_of(best->measured);
    made["prediction"] = dict_of(prediction);
    return made;
}

py::dict fit_together(const std::vector<std::tuple<Doubles, Maybe, Maybe>>& flights,
                      const Maybe& moments, const std::optional<std::string>& drag, bool share_drag,
                      std::optional<int> predict) {
    using namespace py::literals;
    std::vector<MeasuredMotion> held;
    std::vector<std::span<const MeasuredRow>> spans;
    for (std::size_t i = 0; i < flights.size(); ++i) try {
            const auto& [times, omega, attitude] = flights[i];
            held.push_back(measured_of(times, omega, attitude));
            spans.emplace_back(held.back().rows);
        } catch (const InputError& error) {
            throw InputError("flight " + std::to_string(i) + ": " + error.what());
        }
    const auto known = known_moments(moments);
    const auto model = known_drag(drag);
    if (const auto repeated = repeated_flight(spans))
        throw InputError("flights " + std::to_string(repeated->first) + " and " +
                         std::to_string(repeated->second) +
                         " hold the same rows; give each flight once");
    JointFit joint;
    std::vector<std::optional<Prediction>> predictions(flights.size());
    run_interruptibly([&] {
        joint = poinsot::fit_together(spans, known, model, share_drag);
        for (std::size_t i = 0; predict && i < spans.size(); ++i)
            if (joint.flights[i].left_out.empty())
                predictions[i] = predicted(*predict, [&](std::size_t n_rows) {
                    return predicted_by_others(spans[i], n_rows, joint, i);
                });
    });
    py::list list;
    for (std::size_t i = 0; i < joint.flights.size(); ++i) {
        const JointFlight& flight = joint.flights[i];
        py::dict one = dict_of(poinsot::motion_of(joint, flight));
        for (const char* unknown : {"omega_sd", "drag_rates_sd", "noise", "correlation"})
            one[unknown] = py::none();
        one["left_out"] = flight.left_out;
        one["own"] = flight.own ? py::object(dict_of(*flight.own)) : py::none();
        one["prediction"] = dict_of(predictions[i]);
        one["rows"] = columns_of(held[i]);
        list.append(one);
    }
    py::object rates = py::none(), rates_sd = py::none();
    if (joint.shares_drag) {
        rates = py::cast(joint.drag_rates);
        rates_sd = py::cast(joint.drag_rates_sd);
    }
    return py::dict(
        "flights"_a = list, "moments"_a = joint.moments, "moments_sd"_a = joint.moments_sd,
        "I1_kg_m2"_a = joint.I1_kg_m2,
        "axes"_a = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(joint.instrument_from_principal),
        "axes_sd"_a = joint.axes_sd_rad, "drag"_a = std::string(name_of(joint.drag)),
        "drag_rates"_a = rates, "drag_rates_sd"_a = rates_sd,
        "residual"_a =
            joint.residual_rad_s ? *joint.residual_rad_s : joint.residual_rad.value_or(0),
        "unit"_a = joint.residual_rad_s ? "rad/s" : "rad", "n_rows"_a = joint.n_rows,
        "n_used"_a = joint.n_used);
}

py::list flights(const Doubles& times, const Maybe& omega, const Maybe& attitude) {
    const MeasuredMotion measured = measured_of(times, omega, attitude);
    std::vector<FreeFlight> found;
    run_interruptibly([&] { found = flights_of(measured.rows); });
    py::list list;
    for (const FreeFlight& flight : found) {
        py::dict one = columns_of({flight.rows, measured.has_omega, measured.has_attitude});
        one["rate"] = flight.rate_rad_s;
        one["turn_rad"] = flight.turn_rad;
        one["residual"] = flight.residual_rad_s;
        one["noise"] = flight.noise_rad_s;
        list.append(one);
    }
    return list;
}

py::array fitted_omega(const py::dict& fit, const Doubles& times) {
    const FittedMotion motion = fit_of(fit);
    std::vector<Eigen::Vector3d> omegas;
    {
        const WithoutLock without_lock;
        omegas = omega_of(motion, {times.data(), static_cast<std::size_t>(times.size())});
    }
    return triples(omegas);
}

py::array fitted_residuals(const py::dict& fit, const Doubles& times, const Doubles& omega,
                           const Maybe& attitude) {
    const FittedMotion motion = fit_of(fit);
    const Rows rows = rows_of(times, omega, attitude);
    std::vector<Eigen::Vector3d> residuals;
    {
        const WithoutLock without_lock;
        residuals = residuals_of(motion, rows);
    }
    return triples(residuals);
}

// The text of the scene, and the instant of the rows at which its times begin.
std::pair<std::string, double> fitted_scene(const py::dict& fit,
                                            const std::vector<std::string>& words,
                                            double last_time_s, const Maybe& attitude,
                                            const std::string& table,
                                            const std::string& table_sha256) {
    FittedScene scene{.fit = fit_of(fit),
                      .from = "measured rows",
                      .words = words,
                      .last_time_s = last_time_s,
                      .attitude = {},
                      .table = table,
                      .table_sha256 = table_sha256};
    if (attitude) scene.attitude = rotation_of(attitude->data(), 0);
    return {text_of(scene), zero_of(scene)};
}

// `flights`: the fit, times, omega, attitude, whether it is left out and, in `own`, its fit alone
// or None.
py::bytes fit_chart(const std::string& title, const py::list& flights, const py::object& together,
                    const std::string& format) {
    const auto ratios_of = [](const py::dict& fit, const char* name) -> Eigen::Vector2d {
        return Eigen::Map<const Eigen::Vector3d>(fit[name].cast<Doubles>().data()).tail<2>();
    };
    FlightChart chart;
    chart.title = title;
    if (!together.is_none()) {
        chart.ratios = ratios_of(together, "moments");
        chart.ratios_sd = ratios_of(together, "moments_sd");
    }
    for (const py::handle& given : flights) {
        const auto [fit, times, omega, attitude, is_left_out, own] =
            given.cast<std::tuple<py::dict, Doubles, Doubles, Maybe, bool, py::object>>();
        ChartedFlight flight = charted(fit_of(fit), rows_of(times, omega, attitude));
        flight.is_left_out = is_left_out;
        if (flights.size() > 1) flight.name = std::to_string(chart.flights.size() + 1);
        if (flight.is_left_out) flight.name += ", left out";
        if (!own.is_none()) {
            flight.ratios = ratios_of(own, "moments");
            flight.ratios_sd = ratios_of(own, "moments_sd");
        }
        chart.flights.push_back(std::move(flight));
    }
    std::string bytes;
    {
        const WithoutLock without_lock;
        bytes = flight_page(chart, "poinsot.fit", format == "svg");
    }
    return bytes;
}

}  // namespace

void check_rows(const Doubles& times, const Maybe& omega, const Maybe& attitude) {
    rows_of(times, omega, attitude);
}

void add_fit(py::module_& module) {
    using namespace py::literals;
    module.def("fit", fit, "times"_a, "omega"_a, "attitude"_a, "is_flight"_a, "moments"_a, "drag"_a,
               "predict"_a);
    module.def("fit_together", fit_together, "flights"_a, "moments"_a, "drag"_a, "share_drag"_a,
               "predict"_a);
    module.def("flights", flights, "times"_a, "omega"_a, "attitude"_a);
    module.def("table", table, "text"_a, "name"_a);
    module.def("fitted_residuals", fitted_residuals, "fit"_a, "times"_a, "omega"_a, "attitude"_a);
    module.def("fitted_omega", fitted_omega, "fit"_a, "times"_a);
    module.def("fitted_scene", fitted_scene, "fit"_a, "words"_a, "last_time_s"_a, "attitude"_a,
               "table"_a, "table_sha256"_a);
    module.def(
        "check_rows_place",
        [](const std::string& table, const std::string& scene, const py::bytes& rows) {
            check_rows_place(table, scene, std::string_view(rows));
        },
        "table"_a, "scene"_a, "rows"_a);
    module.def("fit_chart", fit_chart, "title"_a, "flights"_a, "together"_a, "format"_a);
}

}  // namespace poinsot::python
