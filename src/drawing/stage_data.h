// What panels and elements draw from: the scene, its motion, the theme, and geometry made once.
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
#include "drawing/type/labels.h"
#include "drawing/type/live_text.h"
#include "shapes/views.h"

namespace poinsot {

// One instant as the panels see it.
struct Instant {
    double time_s = 0.0;
    RotationState state;  // the attitude is the identity unless a panel asks for it
    Eigen::Vector3d herpolhode_space = Eigen::Vector3d::Zero();  // if asked for, as in MotionSample
    EulerAngles euler;                                           // if asked for
    double film_s = 0.0;                                         // second of the film
    std::optional<RotationState> beside{};  // by the method beside, if a panel shows it
};

// A view in the making: its shapes, and the labels that still look for their place.
struct Sheet {
    View view;
    std::vector<LabelWish> wishes;
};

// Adds the shapes of one instant to a sheet; owns nothing, refers to the stage's geometry.
using Drawer = std::function<void(const Instant&, Sheet&)>;

// Poinsot's construction in picture axes: the fixed centre is the origin, z is upwards, and the
// ellipsoid's largest half-axis is 1. Where the plane lies below, L points down along −z: the
// picture with L up turned by half a turn about its x axis, never mirrored, so that the right-hand
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
    // Whether friction inside the body takes T away: then the plane of an instant stands at that
    // instant's √(2T)/L, and ρ is over its T. The numbers above are those of the start.
    bool dissipates = false;

    // `plane`: "below" or "above", as [construction] says.
    ConstructionPicture(const InertiaTensor& inertia, const RotationState& start,
                        std::string_view plane);

    // Where L meets the plane; of a body that dissipates, at the start or at an instant.
    Eigen::Vector3d foot() const { return plane_distance * normal; }
    Eigen::Vector3d foot(const Instant& instant) const;
    // √(T(0)/T) at an ω: 1 where T stays.
    double rho_growth(const Eigen::Vector3d& omega_body) const;
    // ρ = ω/√(2T) in body axes, in the ellipsoid's lengths.
    Eigen::Vector3d contact_body(const Eigen::Vector3d& omega_body) const;

    // Columns are e1, e2, e3 in picture axes.
    Eigen::Matrix3d principal_axes(const Instant& instant) const;
    Eigen::Quaterniond picture_from_body(const Instant& instant) const;
    // The tip of ρ, where ellipsoid and plane touch.
    Eigen::Vector3d contact(const Instant& instant) const;
};

struct Panel;
struct StageData;

struct StageData {
    Scene scene;
    CountedMotion motion;
    std::optional<CountedMotion> beside;  // by the scene's second method
    StageOptions options;
    Theme own_theme;  // the scene's, with its [style]
    const Theme* theme = &own_theme;
    double px = 1.0;         // pixels of the picture for one pixel at 1080 rows
    double curve_px = 0.05;  // what polylines may leave their curves by
    double film_first_s =
        0.0;  // the stretch that time axes span: the film's, and all that is drawn
    double film_last_s = 1.0;

    std::optional<ConstructionPicture> rolling;  // motions that turn and keep L
    std::optional<double> polhode_period_s;      // where it has one
    double turn_rate_rad_s = 0.0;  // of the space axes shown about L: a co-precessing camera's

    Timeline timeline;
    std::set<std::string, std::less<>> can_fade;  // names that a fade may say here

    // Made once for all instants; addresses stay valid for the stage's life.
    TypeCase type_case{options.samples, options.least};
    std::deque<CurveGeometry> curves;
    std::deque<MeshGeometry> meshes;
    std::deque<Panel> panels;
    const CurveGeometry* unit_circle = nullptr;   // about z, from x towards y
    const CurveGeometry* unit_segment = nullptr;  // from the origin to x
    std::vector<Drawer> overlays;                 // title, caption, clock: over the whole picture
    Quantities asks = omega_alone;                // what all panels together read of an instant
    bool shows_beside = false;                    // whether one of them shows the motion beside
    double curve_error_px = 0.0;                  // the greatest of all curves kept
    std::vector<std::string> notes;

    StageData(const Scene& scene, const Motion& motion, const StageOptions& options,
              const Motion* beside);
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

    // The nearest place between pixels of the picture that is looked at: what stands there stands
    // there however many samples a pixel has.
    double at_whole_pixel(double at_px) const {
        return options.samples * std::round(at_px / options.samples);
    }

    // What the panels ask for at an instant, and nothing else; attitude and herpolhode in the space
    // axes shown.
    Instant instant_at(const FilmMoment& moment) const;

    // A co-precessing camera, the lamp that goes with it, and the plane as it sees it, turn about L
    // together; the same picture comes of axes that turn while they stand still. From space axes
    // to those; they coincide at the film's start.
    bool turns() const { return turn_rate_rad_s != 0.0; }
    Eigen::Quaterniond turned_from_space(double time_s) const;

    // A rate that |ω| does not exceed, rad/s: from the energy at the start and what gravity can
    // add.
    double quickest_rate_rad_s() const;

    // The numbers that captions may name, at an instant.
    static std::vector<LiveValue> live_values(const Scene& scene, const Instant& instant);

 private:
    void make_construction();
    void widen_herpolhode();
    void make_panels();
    void check_fades() const;
    void check_unlabelled() const;
    void check_keyframes() const;
};

}  // namespace poinsot
