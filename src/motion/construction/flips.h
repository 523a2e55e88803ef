// How a body turns over (the tennis racket, the Dzhanibekov effect).
//
// In every torque-free motion of a body with three different moments the axis that the polhode
// encircles keeps its side of L, and the two others change theirs: they pass the plane normal to L,
// twice in a period of the polhode. The middle axis swings farthest. Where it comes within 45° of L
// and of −L, it is nearer to that line for a time than the encircled axis: the body turns over, and
// its flips are the instants at which ω along the middle axis changes its sign. Else the encircled
// axis always stays within 45° of L, or of −L: the body wobbles.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mechanics/free/free_rotation.h"
#include "mechanics/motion.h"
#include "mechanics/motion_problem.h"

namespace poinsot {

struct Flips {
    int axis = 1;                      // principal axis of the middle moment
    double one_s = 0.0;                // the instant of the one nearest to the start
    std::optional<double> interval_s;  // between two; none on the separatrix, where there is one

    // Those between two instants, in order, and at most so many of them.
    std::vector<double> between(double first_s, double last_s, int most) const;
};

// The principal axis of the middle one of three different moments; none if two are equal.
std::optional<int> middle_axis(const Eigen::Vector3d& moments);

// How far the middle axis swings, of a motion with a closed polhode and three different moments.
struct AxisSwing {
    int middle = 1;                 // principal axis of the middle moment
    int encircled = 2;              // by the polhode
    bool is_along_momentum = true;  // the encircled axis, in its positive direction; else along −L
    // The least angle between the middle axis and L. The greatest is π − least_rad, and the
    // encircled axis stays within π/2 − least_rad of L, or of −L.
    double least_rad = 0.0;

    bool turns_over() const;
};

// None for two equal moments, a steady rotation, the separatrix and a body at rest.
std::optional<AxisSwing> swing_of(const MotionProblem& problem);

// The flips of a torque-free motion with these constants; nothing if it has none.
std::optional<Flips> flips_of(const MotionProblem& problem, const FreeRotationConstants& constants);

// The flips of any motion between two instants, in order: the middle axis comes within 45° of L,
// and next within 45° of −L, or the other way round; meanwhile ω along it changes its sign. Found
// by samples a tenth of a radian apart. Nothing if that takes more than a million samples; an empty
// list for a body with two equal moments.
std::optional<std::vector<double>> sampled_flips(const Motion& motion, double first_s,
                                                 double last_s);

}  // namespace poinsot
