// The input of panels and elements: the scene, its motion, the theme, and shared geometry.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "construction/poinsot_construction.h"
#include "construction/polhode.h"
#include "drawing/evaluations.h"
#include "drawing/stage.h"
#include "drawing/theme.h"
#include "drawing/timeline.h"
#include "drawing/type/caption_template.h"
#include "drawing/type/labels.h"
#include "shapes/views.h"

namespace poinsot {

// The state at one instant, as the panels use it.
struct FrameInput {
    double time_s = 0.0;
    RotationState state;  // the attitude is the identity unless a panel needs it
    Eigen::Vector3d herpolhode_space = Eigen::Vector3d::Zero();  // if requested, as in MotionSample
    EulerAngles euler;                                           // if requested
    double film_s = 0.0;                                         // second of the film
    std::optional<RotationState>
        comparison{};  // state of the comparison motion, if a panel shows it
};

// A view under construction: its shapes, and the labels that are not placed yet.
struct ViewBuilder {
    View view;
    std::vector<LabelRequest> requests;
};

// Adds the shapes of one instant to a builder; refers to the stage's geometry and owns none.
using Drawer = std::function<void(const FrameInput&, ViewBuilder&)>;

// Poinsot's construction in picture axes: the fixed centre is the origin, z is up, and the
// ellipsoid's largest half-axis is 1. If the plane is below, L points down along −z: this is the
// picture with L up, rotated by half a turn about its x axis (not mirrored), so that the right-hand
// rule holds for every arrow.
struct ConstructionPicture {
    PoinsotConstruction construction;
    Polhode polhode;
    std::optional<RollingCones> cones;
    double picture_per_rho = 1.0;
    Eigen::Quaterniond picture_from_space = Eigen::Quaterniond::Identity();
    Eigen::Vector3d half_axes = Eigen::Vector3d::Ones();
    Eigen::Vector3d normal = -Eigen::Vector3d::UnitZ();  // n = L/|L|, from the centre to the plane
    double plane_distance = 1.0;
    double herpolhode_radius = 0.0;  // outer radius of the annulus
    // Whether internal friction reduces T: then the plane's distance at an instant is that
    // instant's √(2T)/L, and ρ is computed with the instant's T. The values above are those at the
    // start.
    bool dissipates = false;

    // `plane`: "below" or "above", as [construction] says.
    ConstructionPicture(const MotionProblem& problem, std::string_view plane);

    // Foot of L on the plane; of a dissipating body, at the start or at an instant.
    Eigen::Vector3d foot() const { return plane_distance * normal; }
    Eigen::Vector3d foot(const FrameInput& instant) const;
    // √(T(0)/T) for this ω: 1 if T is conserved.
    double rho_growth(const Eigen::Vector3d& omega_body) const;
    // ρ = ω/√(2T) in body axes, in the ellipsoid's lengths.
    Eigen::Vector3d contact_body(const Eigen::Vector3d& omega_body) const;

    // Columns are e1, e2, e3 in picture axes.
    Eigen::Matrix3d principal_axes(const FrameInput& instant) const;
    Eigen::Quaterniond picture_from_body(const FrameInput& instant) const;
    // The tip of ρ, where ellipsoid and plane touch.
    Eigen::Vector3d contact(const FrameInput& instant) const;
};

struct Panel;
struct StageData;

struct StageData {
    Scene scene;
    CountedMotion motion;
    std::optional<CountedMotion> comparison;  // by the scene's second method
    StageOptions options;
    Theme user_theme;  // the scene's theme, with its [style]
    const Theme* theme = &user_theme;
    double px = 1.0;            // pixels of the picture for one pixel at 1080 rows
    double curve_px = 0.05;     // largest distance of polylines from their curves
    double film_first_s = 0.0;  // time span of the film and of time axes
    double film_last_s = 1.0;

    std::optional<ConstructionPicture> rolling;  // of motions that rotate and conserve L
    std::optional<double> polhode_period_s;      // if it has one
    double turn_rate_rad_s = 0.0;  // of the shown space axes about L (co-precessing camera)

    Timeline timeline;
    std::set<std::string, std::less<>> can_fade;  // names that fades may use

    // Created once for all instants; addresses stay valid for the stage's lifetime.
    TextCache type_case{options.samples, options.least};
    std::deque<CurveGeometry> curves;
    std::deque<MeshGeometry> meshes;
    std::deque<Panel> panels;
    const CurveGeometry* unit_circle = nullptr;   // about z, from x towards y
    const CurveGeometry* unit_segment = nullptr;  // from the origin to x
    std::vector<Drawer> overlays;                 // title, caption, clock: over the whole picture
    Quantities needs = omega_alone;               // what all panels together read of an instant
    bool shows_comparison = false;                // whether one of them shows the motion beside
    double curve_error_px = 0.0;                  // the greatest of all curves kept
    std::vector<std::string> notes;

    StageData(const Scene& scene, const Motion& motion, const StageOptions& options,
              const Motion* comparison);
    ~StageData();
    StageData(const StageData&) = delete;
    StageData& operator=(const StageData&) = delete;

    // Keeps a curve whose polyline is so many pixels from it at most: the only way that one gets
    // into a picture, so that the bound which records state covers it. Throws SceneError where that
    // is more than the picture allows; `what` the curve is.
    const CurveGeometry* keep(CurveGeometry geometry, double off_px, std::string_view what);
    const MeshGeometry* keep(MeshGeometry geometry);

    // Adds a note that is not there yet.
    void note(std::string text);

    // The nearest boundary between final pixels: a shape placed there does not move with the number
    // of samples per pixel.
    double at_whole_pixel(double at_px) const {
        return options.samples * std::round(at_px / options.samples);
    }

    // The state at an instant, with only the quantities that the panels read; attitude and
    // herpolhode in the shown space axes.
    FrameInput instant_at(const FilmTime& moment) const;

    // Rotation from space axes to the shown axes. For a co-precessing camera, the camera, its light
    // and its view of the plane turn about L together; this equals a fixed camera and
    // rotating space axes. Both axes coincide at the film's start.
    bool turns() const { return turn_rate_rad_s != 0.0; }
    Eigen::Quaterniond turned_from_space(double time_s) const;

    // An upper bound of |ω|, rad/s: from the energy at the start and the work of gravity.
    double quickest_rate_rad_s() const;

    // The numbers that captions may refer to, at an instant.
    static std::vector<LiveValue> live_values(const Scene& scene, const FrameInput& instant);
    // A caption with these numbers, in the scene's units and language.
    static std::string live_text(const Scene& scene, std::string_view text,
                                 const FrameInput& instant);

 private:
    void make_construction();
    void widen_herpolhode();
    void make_panels();
    void check_fades() const;
    void check_unlabelled() const;
    void check_keyframes() const;
};

}  // namespace poinsot
