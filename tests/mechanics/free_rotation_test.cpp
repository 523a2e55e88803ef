// Jacobi's solution against the reference motions, computed to 40 digits by Taylor series.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "mechanics/motion.h"
#include "mechanics/reference_cases.h"

namespace poinsot {
namespace {

using reference::Json;
using Triple = std::array<long double, 3>;

Triple triple_of(const Json& json, std::size_t first = 0) {
    Triple x{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = std::strtold(json.items.at(first + i).text.c_str(), nullptr);
    }
    return x;
}

long double norm(const Triple& x) { return std::hypot(x[0], x[1], x[2]); }

// |x − reference|, in long double, so that the difference itself is not rounded to double.
long double distance(const Eigen::Vector3d& x, const Triple& reference) {
    return std::hypot(x[0] - reference[0], x[1] - reference[1], x[2] - reference[2]);
}

// Angle between an attitude and q = (w, x, y, z), for small angles.
long double angle(const Eigen::Quaterniond& attitude, const Json& q) {
    const Triple vector = triple_of(q, 1);
    const long double w = std::strtold(q.items.at(0).text.c_str(), nullptr);
    const auto difference = [&](long double sign) {
        return std::hypot(attitude.w() - sign * w, std::hypot(attitude.x() - sign * vector[0],
                                                              attitude.y() - sign * vector[1],
                                                              attitude.z() - sign * vector[2]));
    };
    return 2.0L * std::min(difference(1.0L), difference(-1.0L));
}

Motion motion_of(const Json& c) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(
        {c["I1"].number(), c["I2"].number(), c["I3"].number()}, Physicality::waived);
    const Json& omega = c["omega0"];
    problem.start.omega_body = {omega.items[0].number(), omega.items[1].number(),
                                omega.items[2].number()};
    return Motion(problem);
}

TEST(FreeRotation, AgreesWithReferenceCases) {
    const Json file = reference::read_reference("torque_free.json");
    ASSERT_EQ(file["cases"].items.size(), 34U);
    for (const Json& c : file["cases"].items) {
        const Motion motion = motion_of(c);
        // A subnormal component of ω has fewer digits to keep.
        const bool subnormal = c["name"].text == "denormal_component";
        for (const Json& sample : c["samples"].items) {
            const std::string where = c["name"].text + " t = " + sample["t"].text;
            const MotionSample now =
                motion.sample(sample["t"].number(),
                              {.attitude = true, .herpolhode = true, .euler_angles = false});
            const Triple omega = triple_of(sample["omega"]);
            const long double omega_error = distance(now.state.omega_body, omega);
            EXPECT_LE(omega_error, 2e-15L * norm(omega)) << where;  // measured 4.1e-16
            const long double attitude_error = angle(now.state.space_from_body, sample["q"]);
            EXPECT_LE(attitude_error, 2e-15L) << where;  // measured 8.0e-16
            const Triple h = triple_of(sample["herpolhode"]);
            const long double h_error = distance(now.herpolhode_space, h);
            // measured 9.9e-16
            EXPECT_LE(h_error, subnormal ? 1e-298L : 3e-15L * norm(h)) << where;
        }
    }
}

}  // namespace
}  // namespace poinsot
