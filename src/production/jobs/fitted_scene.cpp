#include "production/jobs/fitted_scene.h"

#include <fmt/format.h>

#include <string_view>

#include "mechanics/free/free_rotation.h"
#include "scene/toml_text.h"

namespace poinsot {

std::string text_of(const FittedScene& scene) {
    const FittedMotion& fit = scene.fit;
    std::string text = fmt::format("# Fitted to {}.\n", scene.from);
    for (const std::string& line : scene.words) text += fmt::format("# {}\n", line);
    text += "# The scene leaves the drag out.\n";
    const InertiaTensor inertia = InertiaTensor::from_matrix(fit.tensor(), Physicality::waived);
    const RotationState first{
        fit.first_time_s, scene.attitude.value_or(Eigen::Quaterniond::Identity()), fit.omega_rad_s};
    const RotationState start = FreeRotation(inertia, first).at(0.0);
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
    if (!scene.table.empty())
        text += fmt::format("\n[measured]\nfile = {}\n", toml_text(std::string_view(scene.table)));
    // A still shows all points. A film that would be short or long lasts ten seconds.
    const double span_s = scene.last_time_s - fit.first_time_s;
    text +=
        fmt::format("\n[film]\nstart_s = {}\nduration_s = {}\nstill_s = {}\n",
                    toml_text(fit.first_time_s), toml_text(span_s), toml_text(scene.last_time_s));
    constexpr double short_s = 5.0, long_s = 60.0, length_s = 10.0;
    if (span_s < short_s || span_s > long_s)
        text += fmt::format("speed = {}\n", toml_text(span_s / length_s));
    return text;
}

}  // namespace poinsot
