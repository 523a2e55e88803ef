// Motions whose herpolhode closes: the whole body then comes back to where it was.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "mechanics/inertia.h"

namespace poinsot {

// After q periods of the polhode with p turns of ω about L.
struct Closure {
    int turns = 1;    // p
    int periods = 1;  // q
};

// The start of a motion that closes.
struct ClosedStart {
    Eigen::Vector3d omega_body;     // rad/s
    std::optional<int> changed;     // the component of ω that was changed; none: it closed before
    double polhode_period_s = 0.0;  // of that motion
    double advance_turns = 0.0;     // of its herpolhode in one period
};

// Changes one component of ω (body axes, rad/s), the one named or else the one that has to change
// least, by as little as makes the herpolhode close: its advance in one polhode period, which the
// exact solution gives in closed form, becomes 2π p/q. Within half of |ω|. A motion that closes to
// 1e-12 of a turn a period is left as it is.
//
// The attitude closes with it: after a period ω is back in body axes, and as L = Jω is fixed in
// space, the attitude has turned about L by the herpolhode's advance.
//
// Throws InputError, without a place: for a body whose herpolhode is a point or never ends, and,
// naming the nearest p/q that is possible, where no start near by closes.
ClosedStart close_herpolhode(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                             const Closure& closure, std::optional<int> component = {});

}  // namespace poinsot
