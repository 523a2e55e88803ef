#include "drawing/stage/live_values.h"

#include <string_view>

#include "text/units.h"

namespace poinsot {

std::vector<LiveValue> live_values(const Scene& scene, const FrameInput& instant) {
    const Eigen::Vector3d& omega = instant.state.omega_body;
    const Eigen::Vector3d momentum = scene.body.inertia.matrix_body() * omega;
    // In the unit in which the scene shows such a quantity.
    const auto shown = [&scene](double value, std::string_view unit) {
        return value * unit_shown(scene.units, unit).per_SI;
    };
    return {{"time_s", instant.time_s},
            {"time_h", instant.time_s / 3600.0},
            {"time_d", instant.time_s / 86400.0},
            {"omega_1_rad_s", omega[0]},
            {"omega_2_rad_s", omega[1]},
            {"omega_3_rad_s", omega[2]},
            {"kinetic_energy_J", 0.5 * omega.dot(momentum)},
            {"momentum_kg_m2_s", momentum.stableNorm()},
            {"omega_1", shown(omega[0], "rad/s")},
            {"omega_2", shown(omega[1], "rad/s")},
            {"omega_3", shown(omega[2], "rad/s")},
            {"omega", shown(omega.stableNorm(), "rad/s")},
            {"kinetic_energy", shown(0.5 * omega.dot(momentum), "J")},
            {"momentum", shown(momentum.stableNorm(), "kg m²/s")}};
}

}  // namespace poinsot
