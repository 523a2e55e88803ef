// poinsot sample SCENE --times T,T,…: the motion as data.
#include <fmt/format.h>

#include <string>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "error/error.h"
#include "production/session.h"

namespace poinsot {

namespace {

struct SampleChoices {
    std::vector<std::string> scenes;
    SceneOptions scene;
    std::vector<double> times_s;
    bool quiet = false;
};

MotionSample sample_at(const Motion& motion, double time_s, bool top) {
    try {
        return motion.sample(time_s, {.attitude = true, .herpolhode = true, .euler_angles = top});
    } catch (const InputError& error) {
        throw InputError(fmt::format("--times {}: {}", time_s, error.what()));
    }
}

int run(const SampleChoices& choices) {
    SceneRequest request = scene_request_of(choices.scenes.at(0), choices.scene);
    request.times_s = choices.times_s;
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    const Session session = open_session(request, Purpose::numbers, telling);
    tell_notes(session.scene, telling);
    const bool top = session.motion.regime() == Regime::heavy_top;

    // Shortest decimals that give each double back.
    // Printed when all of it is known: an instant that cannot be had leaves no half a table.
    std::string table = fmt::format(
        "time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,"
        "herpolhode_x,herpolhode_y,herpolhode_z{}\n",
        top ? ",theta_rad,phi_rad,psi_rad" : "");
    for (const double time_s : choices.times_s) {
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

CommandLine line(std::any& room) {
    auto& c = room.emplace<SampleChoices>();
    return {&c.scenes,
            {set_option(c.scene),
             {"--times",
              "T,T,…: instants of the motion in seconds",
              ReadText([&c](const std::string& text) { c.times_s = parse_times(text); }),
              "",
              {},
              true},
             quiet_option(c.quiet),
             allow_outside_option(c.scene.allow_outside)},
            [&c] { return run(c); }};
}

}  // namespace

const Command sample_command{"sample",
                             "SCENE",
                             1,
                             1,
                             "print the motion at given times as CSV",
                             line,
                             {{{"poinsot sample generic --times 0,0.5,1", "three instants as CSV"},
                               {"poinsot sample generic --times 1e6 --set motion.method=exact",
                                "an instant after eleven days"}}}};

}  // namespace poinsot
