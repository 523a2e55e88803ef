// Everything a scene file may say, as plain values with defaults.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/inertia.h"
#include "mechanics/motion_problem.h"
#include "mechanics/solids.h"

namespace poinsot {

// Where a value stands. line 0: it came from --set or is a default.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;
    // "file:line:column: ", "--set: " or "file: ".
    std::string prefix() const;
};

// [body]: how the inertia was given, and the tensor that follows from it.
struct BodySpec {
    enum class Given { moments, tensor, solid, masses };
    Given given = Given::moments;
    InertiaTensor inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    std::string shape;              // solid: name of the solid
    std::vector<double> size_m;     // solid
    double mass_kg = 1.0;           // solid, or the sum of the masses
    std::vector<PointMass> masses;  // masses, moved so that the centre of mass is the origin
    Eigen::Vector3d centre_of_mass_m_body = Eigen::Vector3d::Zero();  // as given, before that
    bool allow_unphysical = false;
};

// [start]: ω and attitude at t = 0, or the top's Euler angles and rates.
struct TopStart {
    double theta_rad = 0.0, theta_dot_rad_s = 0.0, phi_dot_rad_s = 0.0, omega3_rad_s = 0.0;
};
struct StartSpec {
    Eigen::Vector3d omega_rad_s = Eigen::Vector3d::Zero();  // body axes
    Eigen::Quaterniond space_from_body = Eigen::Quaterniond::Identity();
    std::optional<TopStart> top;
};

// [film]: which instants become video frames. Frame k shows start_s + k·speed/fps.
struct FilmSpec {
    double start_s = 0.0;
    std::optional<double>
        duration_s;  // of the motion shown; absent: chosen from the motion's periods
    std::int64_t fps_numerator = 30, fps_denominator = 1;
    int width_px = 1920, height_px = 1080;
    double speed = 1.0;  // seconds of motion a second of film
    std::string quality = "lecture";
};

// [camera]: about the picture's vertical, which is L.
struct CameraSpec {
    double azimuth_deg = -58.0;
    double elevation_deg = 20.0;
    double distance = 5.2;    // in units of the largest half-axis, from the target
    double field_deg = 28.0;  // vertical
    std::optional<Eigen::Vector3d>
        target;                    // picture axes; absent: chosen to frame the construction
    std::string motion = "fixed";  // fixed, co-precessing
};

struct Scene {
    std::string name = "scene";  // the file's stem
    std::filesystem::path file;
    std::string title;
    std::string caption;
    BodySpec body;
    StartSpec start;
    Torque torque;
    MethodChoice method;
    FilmSpec film;
    CameraSpec camera;
    std::vector<std::string> show;  // elements by name; empty: the defaults for this kind of motion
    std::string theme = "light";
    double accuracy_px = 0.1;

    std::map<std::string, SourceLocation>
        locations;  // of every key that was given, by dotted path: "start.omega_rad_s"

    // "file:line:column: " of a key, or of the nearest table above it that was given.
    std::string where(const std::string& key) const;
};

}  // namespace poinsot
