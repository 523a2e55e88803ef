#include "construction/herpolhode.h"

namespace poinsot {

namespace {

Eigen::Vector3d foot_of(const PoinsotConstruction& construction) {
    return construction.plane_distance() * construction.normal_space();
}

Eigen::Vector3d point_from_foot(const PoinsotConstruction& construction, const Motion& motion,
                                double time_s) {
    const MotionSample sample =
        motion.sample(time_s, {.attitude = false, .herpolhode = true, .euler_angles = false});
    return construction.contact_in_plane(sample.herpolhode_space);
}

}  // namespace

Eigen::Vector3d herpolhode_point(const PoinsotConstruction& construction, const Motion& motion,
                                 double time_s) {
    return point_from_foot(construction, motion, time_s) + foot_of(construction);
}

Herpolhode sample_herpolhode(const PoinsotConstruction& construction, const Motion& motion,
                             double first_time_s, double last_time_s, double shortest_feature_s,
                             double tolerance, std::size_t max_points) {
    Herpolhode curve;
    static_cast<TimedPath&>(curve) =
        sample_path([&](double t) { return point_from_foot(construction, motion, t); },
                    first_time_s, last_time_s, shortest_feature_s, tolerance, max_points);
    curve.foot = foot_of(construction);
    return curve;
}

}  // namespace poinsot
