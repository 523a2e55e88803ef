// Recordings with known flights: walking, throwing, free flight, catching and bouncing, as a
// gyroscope would have measured them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "measured/measured_motion.h"

namespace poinsot::testing {

struct ThrownBody {
    Eigen::Vector3d moments{1.0, 0.93, 0.07};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // instrument from principal
    // Torques −γ_i I_i |ω_i| ω_i, as of air, in 1/rad.
    Eigen::Vector3d drag{0.01, 0.01, 0.002};
};

struct TrueFlight {
    double begin_s = 0.0, end_s = 0.0;
    int body = 0;
};

struct Gyroscope {
    double rate_Hz = 100.0;
    double noise_rad_s = 0.01;
    double jitter_share = 0.0;  // of a step, by which rows come early or late
    double stamp_share = 0.0;   // of a step, by which their times are wrong
    double limit_rad_s = 1e9;
};

// ω on a fine grid. Euler's equations are stepped by the classical Runge-Kutta method.
class MadeRecording {
 public:
    explicit MadeRecording(unsigned seed) : random_(seed) {}

    double now_s() const { return step_s * static_cast<double>(omega_.size()); }
    const std::vector<TrueFlight>& flights() const { return flights_; }

    // Swinging arms and steps: turns at 0.5 to 6 Hz.
    void walk(double span_s, double most_rad_s = 1.5) {
        std::vector<Eigen::Vector3d> made(steps_of(span_s), Eigen::Vector3d::Zero());
        for (const double frequency : {0.5, 0.9, 1.8, 3.1, 5.7}) {
            const double f = frequency * (0.8 + 0.4 * unit());
            const Eigen::Vector3d sine = swing(most_rad_s / std::sqrt(frequency));
            const Eigen::Vector3d cosine = swing(most_rad_s / std::sqrt(frequency));
            for (std::size_t i = 0; i < made.size(); ++i) {
                const double x = 2.0 * std::numbers::pi * f * step_s * static_cast<double>(i);
                made[i] += sine * std::sin(x) + cosine * std::cos(x);
            }
        }
        join(made);
    }

    // A hand that gives the body this ω, then free flight.
    void toss(const ThrownBody& body, const Eigen::Vector3d& omega, double span_s, int number = 0,
              double windup_s = 0.35) {
        const Eigen::Vector3d from = omega_.empty() ? Eigen::Vector3d::Zero() : omega_.back();
        const Eigen::Vector3d aside = direction() * 0.2 * omega.norm();
        const std::size_t n = steps_of(windup_s);
        for (std::size_t i = 0; i < n; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(n);
            const double smooth = x * x * (3.0 - 2.0 * x);
            omega_.push_back(from + smooth * (omega - from) +
                             std::sin(std::numbers::pi * x) * aside);
        }
        fly(body, omega, span_s, number);
    }

    void fly(const ThrownBody& body, Eigen::Vector3d omega, double span_s, int number = 0) {
        flights_.push_back({now_s(), now_s() + span_s, number});
        Eigen::Vector3d w = body.axes.transpose() * omega;
        const auto slope = [&body](const Eigen::Vector3d& at) -> Eigen::Vector3d {
            const Eigen::Vector3d torque =
                -at.cross(body.moments.cwiseProduct(at)) -
                body.moments.cwiseProduct(body.drag).cwiseProduct(at.cwiseAbs()).cwiseProduct(at);
            return torque.cwiseQuotient(body.moments);
        };
        for (std::size_t i = 0; i < steps_of(span_s); ++i) {
            omega_.push_back(body.axes * w);
            const Eigen::Vector3d a = slope(w), b = slope(w + 0.5 * step_s * a),
                                  c = slope(w + 0.5 * step_s * b), d = slope(w + step_s * c);
            w += step_s / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
    }

    // A hand or the floor stops the body within some hundredths of a second, with knocks.
    void hit(double span_s = 0.15) {
        Eigen::Vector3d from = omega_.back();
        const double most = std::max(5.0, from.norm());
        const std::size_t n = steps_of(span_s), knock = steps_of(0.012);
        Eigen::Vector3d to = from;
        for (std::size_t i = 0; i < n; ++i) {
            const double left = 1.0 - static_cast<double>(i) / static_cast<double>(n);
            if (i % knock == 0) {
                from = to;
                const double size = left * most * (0.4 + unit());
                to = size * direction();
            }
            const double x = static_cast<double>(i % knock) / static_cast<double>(knock);
            omega_.push_back(from + x * (to - from));
        }
    }

    std::vector<MeasuredRow> rows(const Gyroscope& gyroscope) {
        std::normal_distribution<double> normal;
        std::vector<MeasuredRow> made;
        const double step = 1.0 / gyroscope.rate_Hz;
        for (double t = step; t < now_s() - 2.0 * step; t += step) {
            const double there = t + step * gyroscope.jitter_share * (unit() - 0.5);
            const double place = there / step_s;
            const auto i = static_cast<std::size_t>(place);
            const double x = place - static_cast<double>(i);
            MeasuredRow row;
            row.time_s = there + step * gyroscope.stamp_share * (unit() - 0.5);
            row.omega_body = (1.0 - x) * omega_[i] + x * omega_[i + 1];
            for (double& w : row.omega_body)
                w = std::clamp(w + gyroscope.noise_rad_s * normal(random_), -gyroscope.limit_rad_s,
                               gyroscope.limit_rad_s);
            made.push_back(row);
        }
        return made;
    }

    // One after the other: the order of operands is the compiler's.
    Eigen::Vector3d swing(double most) {
        const double size = most * unit();
        return size * direction();
    }
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    Eigen::Vector3d direction() {
        std::normal_distribution<double> normal;
        const double x = normal(random_), y = normal(random_), z = normal(random_);
        return Eigen::Vector3d(x, y, z).normalized();
    }
    Eigen::Matrix3d rotation() {
        std::normal_distribution<double> normal;
        const double w = normal(random_), x = normal(random_), y = normal(random_),
                     z = normal(random_);
        return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    }

 private:
    static constexpr double step_s = 0.5e-3;
    static std::size_t steps_of(double span_s) {
        return static_cast<std::size_t>(std::lround(span_s / step_s));
    }
    // Without a jump where a piece begins.
    void join(const std::vector<Eigen::Vector3d>& piece) {
        const Eigen::Vector3d from = omega_.empty() ? piece.front() : omega_.back();
        const double tenth_s = 0.1;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double x = std::min(1.0, step_s * static_cast<double>(i) / tenth_s);
            omega_.push_back((1.0 - x) * from + x * piece[i]);
        }
    }

    std::mt19937 random_;
    std::vector<Eigen::Vector3d> omega_;
    std::vector<TrueFlight> flights_;
};

}  // namespace poinsot::testing
