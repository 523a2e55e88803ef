#include "production/fits/fitted_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "mechanics/free/free_rotation.h"
#include "mechanics/torque.h"
#include "scene/toml/toml_text.h"

namespace poinsot {

namespace {

// The drag of a fit as a scene says it, or why the scene leaves it out.
struct SceneDrag {
    std::optional<Drag> torque;
    std::string_view left_out{};
};

// Whether the drag changes the motion by more than its uncertainty and the rounding of the rows.
bool is_noticed(const FittedMotion& fit, double span_s) {
    constexpr double least_sds = 2.0, least_change = 1e-9;
    const double rate = fit.drag == DragModel::quadratic ? fit.omega_rad_s.norm() : 1.0;
    const int n = fit.drag == DragModel::growing ? 1 : 3;
    for (int k = 0; k < n; ++k)
        if (std::abs(fit.drag_rates[k]) > least_sds * fit.drag_rates_sd[k] &&
            std::abs(fit.drag_rates[k]) * rate * span_s > least_change)
            return true;
    return false;
}

SceneDrag drag_of(const FittedScene& scene) {
    const FittedMotion& fit = scene.fit;
    if (fit.drag == DragModel::none) return {};
    if (!is_noticed(fit, scene.last_time_s - fit.first_time_s))
        return {{}, "it does not differ from 0"};
    Drag drag;
    Eigen::Vector3d& rates =
        fit.drag == DragModel::quadratic ? drag.quadratic_1_rad : drag.linear_1_s;
    if (fit.drag == DragModel::growing) {
        rates.setConstant(fit.drag_rates[0]);
        drag.growth_1_s = fit.drag_rates[1];
    } else {
        // Along the axes of the scene's tensor, which may number them otherwise.
        const Eigen::Matrix3d along = (InertiaTensor::from_matrix(fit.tensor(), Physicality::waived)
                                           .body_from_principal()
                                           .transpose() *
                                       fit.instrument_from_principal)
                                          .cwiseAbs();
        constexpr double same = 1.0 - 1e-9;
        for (int k = 0; k < 3; ++k) {
            Eigen::Index own = 0;
            if (!(along.row(k).maxCoeff(&own) > same) && fit.drag != DragModel::linear)
                return {{}, "two moments are equal and their axes arbitrary"};
            rates[k] = fit.drag_rates[own];
        }
    }
    if (rates.minCoeff() < 0.0) return {{}, "a rate is negative, and air only slows"};
    return {drag, {}};
}

std::string text_of(const Drag& drag) {
    std::string text = "\n[torque]\nkind = \"drag\"\n";
    if (!drag.linear_1_s.isZero(0.0))
        text += fmt::format("linear_1_s = {}\n", toml_text(drag.linear_1_s));
    if (!drag.quadratic_1_rad.isZero(0.0))
        text += fmt::format("quadratic_1_rad = {}\n", toml_text(drag.quadratic_1_rad));
    if (drag.growth_1_s != 0.0)
        text += fmt::format("growth_1_s = {}\n", toml_text(drag.growth_1_s));
    return text + "\n[motion]\nmethod = \"dopri5\"\n";
}

}  // namespace

double zero_of(const FittedScene& scene) {
    return drag_of(scene).torque ? scene.fit.first_time_s : 0.0;
}

MeasuredMotion counted_from(MeasuredMotion measured, double zero_s) {
    for (MeasuredRow& row : measured.rows) row.time_s -= zero_s;
    return measured;
}

std::string hash_comment(const std::string& table_sha256) {
    return fmt::format("  # sha256 {}", table_sha256);
}

std::string text_of(const FittedScene& scene) {
    const FittedMotion& fit = scene.fit;
    const SceneDrag drag = drag_of(scene);
    const double zero_s = zero_of(scene);
    const double first_s = fit.first_time_s - zero_s, last_s = scene.last_time_s - zero_s;
    std::string text = fmt::format("# Fitted to {}", scene.from);
    if (zero_s != 0.0) text += fmt::format(", whose {} s are the 0 s of the scene", zero_s);
    text += ".\n";
    for (const std::string& line : scene.words) text += fmt::format("# {}\n", line);
    if (!drag.left_out.empty())
        text += fmt::format("# The scene leaves the drag out: {}.\n", drag.left_out);
    const InertiaTensor inertia = InertiaTensor::from_matrix(fit.tensor(), Physicality::waived);
    RotationState start{first_s, scene.attitude.value_or(Eigen::Quaterniond::Identity()),
                        fit.omega_rad_s};
    if (start.time_s != 0.0) start = FreeRotation(inertia, start).at(0.0);
    const Eigen::Vector3d moments = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    if (moments[0] < moments[1] || moments[1] < moments[2])
        text += fmt::format(
            "# The scene numbers the axes otherwise: I1, I2, I3 = {:.4g}, {:.4g}, {:.4g}, in units "
            "of the largest.\n",
            moments[0], moments[1], moments[2]);
    text += fmt::format("\n[body]\ntensor_kg_m2 = {}{}\n", toml_text(fit.tensor()),
                        fit.I1_kg_m2 ? "" : "  # I1 = 1: a common factor has no effect on ω");
    if (excess_of(fit) > 0.0) text += "allow_unphysical = true\n";
    text += fmt::format("\n[start]\nomega_rad_s = {}\n", toml_text(start.omega_body));
    const Eigen::Quaterniond& q = start.space_from_body;
    if (scene.attitude)
        text +=
            fmt::format("attitude = {}\n", toml_text(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())));
    if (drag.torque) text += text_of(*drag.torque);
    if (!scene.table.empty())
        text += fmt::format("\n[measured]\nfile = {}{}\n", toml_text(std::string_view(scene.table)),
                            scene.table_sha256.empty() ? "" : hash_comment(scene.table_sha256));
    // A still shows all points. A film that would be short or long lasts ten seconds.
    const double span_s = last_s - first_s;
    text += fmt::format("\n[film]\nstart_s = {}\nduration_s = {}\nstill_s = {}\n",
                        toml_text(first_s), toml_text(span_s), toml_text(last_s));
    constexpr double short_s = 5.0, long_s = 60.0, length_s = 10.0;
    if (span_s < short_s || span_s > long_s)
        text += fmt::format("speed = {}\n", toml_text(span_s / length_s));
    return text;
}

}  // namespace poinsot
