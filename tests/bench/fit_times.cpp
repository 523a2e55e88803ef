// Processor time of fits of measured motions: fit_times [TABLE.csv…]. Without tables, 10,000 rows
// of a made motion with noise.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

#include "measured/files/measured_file.h"
#include "measured/fit.h"
#include "mechanics/free/free_rotation.h"

using namespace poinsot;

int main(int n_arguments, char** arguments) {
    std::vector<std::vector<MeasuredRow>> tables;
    for (int i = 1; i < n_arguments; ++i) tables.push_back(load_measured(arguments[i]).rows);
    if (tables.empty()) {
        const FreeRotation motion(
            InertiaTensor::from_matrix(Eigen::Vector3d(1.0, 0.7, 0.4).asDiagonal()),
            RotationState{0.0, Eigen::Quaterniond::Identity(), Eigen::Vector3d(3.0, 5.0, 4.0)});
        std::mt19937 random(1);
        std::normal_distribution<double> noise(0.0, 0.05);
        tables.emplace_back();
        for (int i = 0; i < 10'000; ++i) {
            MeasuredRow row;
            row.time_s = 0.01 * i;
            row.omega_body = motion.at(row.time_s).omega_body;
            for (int k = 0; k < 3; ++k) row.omega_body[k] += noise(random);
            tables.front().push_back(row);
        }
    }
    std::vector<double> times_ms;
    for (const auto& rows : tables) {
        const std::clock_t start = std::clock();
        fit_motion(rows);
        times_ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::sort(times_ms.begin(), times_ms.end());
    fmt::print("{} fits: median {:.2f} ms, largest {:.2f} ms\n", times_ms.size(),
               times_ms[times_ms.size() / 2], times_ms.back());
}
