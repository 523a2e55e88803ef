// Motions with a closed herpolhode: the whole body then returns to its initial attitude.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "mechanics/inertia.h"

namespace poinsot {

// A closed herpolhode: p turns of ω about L in q periods of the polhode.
struct Closure {
    int turns = 1;    // p
    int periods = 1;  // q
};

// The start of a motion with a closed herpolhode.
struct ClosedStart {
    Eigen::Vector3d omega_body;     // rad/s
    std::optional<int> changed;     // the component of ω that was changed; none: already closed
    double polhode_period_s = 0.0;  // of the changed motion
    double advance_turns = 0.0;     // of the herpolhode in one period
};

// Changes one component of ω (body axes, rad/s) by as little as possible so that the herpolhode
// closes: its advance in one polhode period, which the exact solution gives in closed form, becomes
// 2π p/q. The component is the given one, or else the one with the smallest change. The change is
// at most half of |ω|. A motion that closes to 1e-12 of a turn per period is left unchanged.
//
// The attitude closes with the herpolhode: after a period ω is back in body axes, and as L = Jω is
// fixed in space, the attitude has turned about L by the herpolhode's advance.
//
// Throws InputError, without a place: for a body whose herpolhode is a point or does not end, and,
// naming the nearest possible p/q, if no start in this range closes.
ClosedStart close_herpolhode(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                             const Closure& closure, std::optional<int> component = {});

}  // namespace poinsot
