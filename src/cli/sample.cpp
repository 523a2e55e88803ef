// poinsot sample SCENE --times T,T,…: the motion as data.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <string>

#include "cli/command.h"
#include "cli/requests.h"
#include "error/error.h"
#include "production/session.h"

namespace poinsot {

namespace {

MotionSample sample_at(const Motion& motion, double time_s, bool top) {
    try {
        return motion.sample(time_s, {.attitude = true, .herpolhode = true, .euler_angles = top});
    } catch (const InputError& error) {
        throw InputError(fmt::format("--times {}: {}", time_s, error.what()));
    }
}

int run(const Options& options) {
    const Session session = open_session(scene_request_of(options), Purpose::numbers);
    print_notes(session.scene, options.quiet);
    const bool top = session.motion.regime() == Regime::heavy_top;

    // Shortest decimals that give each double back.
    // Printed when all of it is known: an instant that cannot be had leaves no half a table.
    std::string table = fmt::format(
        "time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,"
        "herpolhode_x,herpolhode_y,herpolhode_z{}\n",
        top ? ",theta_rad,phi_rad,psi_rad" : "");
    for (const double time_s : options.times_s) {
        const MotionSample sample = sample_at(session.motion, time_s, top);
        const Eigen::Vector3d& w = sample.state.omega_body;
        const Eigen::Quaterniond& q = sample.state.space_from_body;
        const Eigen::Vector3d& h = sample.herpolhode_space;
        table += fmt::format("{},{},{},{},{},{},{},{},{},{},{}", time_s, w[0], w[1], w[2], q.w(),
                             q.x(), q.y(), q.z(), h[0], h[1], h[2]);
        if (top) {
            table += fmt::format(",{},{},{}", sample.euler.theta_rad, sample.euler.phi_rad,
                                 sample.euler.psi_rad);
        }
        table += "\n";
    }
    fmt::print("{}", table);
    return 0;
}

constexpr std::array<std::string_view, 4> options_taken{"set", "times", "quiet", "allow-outside"};

}  // namespace

const Command sample_command{"sample",      "SCENE", 1, 1, "print the motion at given times as CSV",
                             options_taken, run};

}  // namespace poinsot
