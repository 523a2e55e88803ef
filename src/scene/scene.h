// Everything a scene file may say, as plain values with defaults.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "mechanics/inertia.h"
#include "mechanics/motion_problem.h"
#include "mechanics/solids.h"
#include "mesh/triangle_mesh.h"

namespace poinsot {

// Whether a scene may name files that lie outside of its own folder.
enum class OutsideFiles { refused, allowed };

// Where a value stands. line 0: it came from --set (then `file` is "--set key=value") or is a
// default.
struct SourceLocation {
    std::string file;
    int line = 0;    // from 1
    int column = 0;  // from 1, in characters
    // "file:line:column: ", "--set key=value: " or "file: ", safe to print on a terminal.
    std::string prefix() const;
};

// One closed surface of the body, drawn in one colour.
struct BodySurface {
    TriangleMesh mesh;                          // m, body axes, from the centre of mass
    std::optional<std::array<double, 3>> srgb;  // sRGB-encoded, 0…1; absent: the theme's
};

// [body]: how the inertia was given, and the tensor that follows from it.
struct BodySpec {
    enum class Given { moments, tensor, solid, masses, object, mesh };
    Given given = Given::moments;
    InertiaTensor inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    std::string shape;              // solid: name of the solid
    std::vector<double> size_m;     // solid
    double mass_kg = 1.0;           // solid, object, mesh, or the sum of the masses
    std::vector<PointMass> masses;  // masses, moved so that the centre of mass is the origin
    Eigen::Vector3d centre_of_mass_m_body = Eigen::Vector3d::Zero();  // as given, before that
    std::vector<PointMass> masses_as_given;                           // before that
    Eigen::Matrix3d tensor_kg_m2 = Eigen::Matrix3d::Identity();       // tensor, symmetric
    std::string object;                   // object: its name in the table of mesh/
    std::string mesh;                     // mesh: its file, as given
    double scale = 1.0;                   // object, mesh: metres for one unit of their lengths
    std::optional<double> density_kg_m3;  // mesh, if it was given so
    bool allow_unphysical = false;
};

// [[object.pictures]]: a picture on a flat face of the body.
struct FacePictureSpec {
    std::string face;  // of body_faces()
    std::string file;  // as given
    std::string up;    // of body_faces(): where its upper side points; empty: as it fits best
    Image image;       // what is in the file
};

// [object]: what a body looks like whose moments or tensor say nothing of its form.
struct ObjectSpec {
    std::string name;         // in the table of mesh/
    std::string mesh;         // or a file, as given
    std::string marked_face;  // of body_faces(); empty: none
    std::vector<FacePictureSpec> pictures;
};

// [start]: ω and attitude at t = 0, or the top's Euler angles and rates.
struct StartSpec {
    Eigen::Vector3d omega_rad_s = Eigen::Vector3d::Zero();  // body axes
    Eigen::Quaterniond space_from_body = Eigen::Quaterniond::Identity();
    std::optional<TopStart> top;
};

// Length of a film whose scene does not say how long it lasts, in seconds of film.
constexpr double default_film_s = 10.0;

// [film]: which instants become video frames. Frame k shows second k/fps of the film; which instant
// of the motion that is, see FilmClock.
struct FilmSpec {
    double start_s = 0.0;
    std::optional<double> duration_s;  // of the motion shown; absent: what length_s shows
    std::optional<double> length_s;    // of the film
    std::optional<double> still_s;     // instant of the motion that stands for it in a still
    std::string loop;          // "p/q", "period", or empty: the film does not run into itself
    std::string loop_changes;  // of loop_values(); empty: the one that need change least
    std::int64_t fps_numerator = 30, fps_denominator = 1;
    int width_px = 1920, height_px = 1080;
    double speed = 1.0;  // seconds of motion a second of film, until a keyframe changes it
    std::string quality = "lecture";
};

// [camera]: about the picture's vertical, which is −L where the plane lies below, L where above.
struct CameraSpec {
    double azimuth_deg = -40.0;
    double elevation_deg = 14.0;
    double distance = 5.2;                  // in units of the largest half-axis, from the target
    double field_deg = 28.0;                // vertical
    std::optional<Eigen::Vector3d> target;  // picture axes; absent: what look_at names
    std::string look_at = "middle";         // of camera_aims()
    std::string view;              // of camera_views(), which set what is not said otherwise
    std::string motion = "fixed";  // fixed, co-precessing
    std::string projection = "perspective";  // of camera_projections()
};

// [panels.camera]: what the camera of one panel says otherwise than [camera], or than where that
// panel is seen from by itself. Empty and absent: not said.
struct PanelCameraSpec {
    std::optional<double> azimuth_deg, elevation_deg, distance, field_deg;
    std::optional<Eigen::Vector3d> target;
    std::string look_at, view, projection;
};

// [construction]: how Poinsot's construction is laid into the picture, and what runs over the film.
struct ConstructionSpec {
    std::string plane = "below";  // or "above": where the invariable plane lies in the picture
    std::string sweep;  // "axis", "energy": what the film runs through instead of the motion;
                        // empty: nothing
};

// [trail]: how much of the paths of the contact point is shown, and how.
struct TrailSpec {
    std::string polhode = "whole";       // or "history", "fading"
    std::string herpolhode = "history";  // likewise
    std::optional<double> length_s;      // of a fading trail; absent: one polhode period
    bool direction_marks = false;        // chevrons that show which way it runs
};

// [[keyframes]]: what has been reached at a second of the film. Where a keyframe does not say a
// value, it does not bend that value's way.
struct KeyframeSpec {
    double at_s = 0.0;              // of the film
    std::optional<int> panel;       // whose camera moves; absent: of all that [camera] moves
    std::string easing = "smooth";  // how the values go here from the keyframe before
    std::string view;               // sets what of the camera is not said otherwise
    std::optional<double> azimuth_deg, elevation_deg, distance, field_deg;
    std::optional<Eigen::Vector3d> target;
    std::string look_at;
    std::optional<double> speed;
};

// [[fades]]: elements, overlays or panels that come, go or grow pale.
struct FadeSpec {
    double at_s = 0.0;  // of the film, when it begins
    double over_s = 1.0;
    std::string easing = "smooth";
    std::vector<std::string> elements;
    double opacity = 1.0;  // in the end
};

// [[chapters]]: named sections of the film, each up to the next.
struct ChapterSpec {
    double at_s = 0.0;  // of the film
    std::string title;
};

// [[captions]]: text that comes and goes in the film's own seconds.
struct TimedCaptionSpec {
    double at_s = 0.0;             // of the film
    std::optional<double> over_s;  // that it stands; absent: until the next in its place
    std::string text;              // with live numbers, as the caption
    std::string place = "bottom";  // bottom, top
};

// [symbols]: what quantities are called in labels, as formulas; empty: by their own names.
struct SymbolsSpec {
    std::string omega, momentum, rho, e1, e2, e3;
};

// How one quantity or surface is drawn, where [style] says so; the rest is as the theme has it.
struct LookSpec {
    std::optional<std::array<double, 3>> srgb;  // sRGB-encoded, 0…1
    std::optional<double> weight;               // times the usual
    std::optional<double> opacity_percent;      // of a surface, or of the ground
    std::string line;                           // of line_kinds(); empty: as ever
};

// [style]: what is drawn otherwise than the theme says.
struct StyleSpec {
    std::map<std::string, LookSpec, std::less<>> looks;  // by the names of style_roles()
    // Factors on the type of each kind.
    std::optional<double> title_scale, caption_scale, heading_scale, label_scale, chart_scale;
};

// [[marks]]: a point of the user's own.
struct MarkSpec {
    std::string on = "ellipsoid";               // of mark_places()
    Eigen::Vector3d at{0.0, 0.0, 0.0};          // as the place has it
    std::string name;                           // in mathematics; empty: none
    bool trail = false;                         // whether the way that it went is shown
    std::optional<std::array<double, 3>> srgb;  // absent: as the contact
};

// [[panels]]: one view of the motion, in cells of the grid.
struct PanelSpec {
    std::string kind = "space";
    int column = 0, row = 0;           // of its upper left cell
    int columns = 1, rows = 1;         // cells that it spans
    std::string quantity;              // of a plot, by name; empty: the one that suits the motion
    std::optional<int> curves;         // of the body panel's families, each; absent: what fills it
    std::optional<std::string> title;  // over the panel, "" for none; absent: the kind's own
    PanelCameraSpec camera;
};

// Columns or rows of a grid.
inline constexpr int most_cells = 64;

// [grid]: relative widths of the columns and heights of the rows.
struct GridSpec {
    std::vector<double> columns{1.0};
    std::vector<double> rows{1.0};
};

struct Scene {
    std::string name = "scene";  // the file's stem
    std::filesystem::path file;
    std::string title;
    std::string caption;
    BodySpec body;
    ObjectSpec object;
    std::vector<BodySurface> surfaces;  // of an object or a mesh; empty: the body has another form
    StartSpec start;
    Torque torque;
    std::optional<double> half_life_s;  // of a dissipation given so; its rate follows
    MethodChoice method;
    std::optional<MethodChoice> beside;  // a second method, shown beside the first as a ghost
    FilmSpec film;
    CameraSpec camera;
    ConstructionSpec construction;
    TrailSpec trail;
    std::vector<KeyframeSpec> keyframes;     // in order of at_s
    std::vector<FadeSpec> fades;             // likewise
    std::vector<ChapterSpec> chapters;       // likewise
    std::vector<TimedCaptionSpec> captions;  // likewise
    SymbolsSpec symbols;
    std::vector<std::string> units;  // that numbers are shown in, for what they measure; else SI
    std::string language = "en";     // of the built-in words, of languages()
    std::optional<bool> clock;       // whether it is shown; absent: where the film has one
    double type_scale = 1.0;         // of all type in the picture
    std::vector<std::string> show;  // elements by name; empty: the defaults for this kind of motion
    bool labels = true;             // whether elements have their names beside them
    std::vector<std::string> unlabelled;  // elements that have none
    std::vector<MarkSpec> marks;
    GridSpec grid;
    std::vector<PanelSpec> panels;  // empty: the space panel alone
    std::string theme = "light";    // of a file of a theme, what that extends
    StyleSpec style;                // what that file says otherwise, and the scene above it
    std::string hidden;     // pale, dashed, omitted: what lies behind; empty: as the theme says
    std::string crossings;  // through, gap: where lines pass over others; likewise
    double accuracy_px = 0.1;

    std::vector<std::string> notes;  // what the reader changed and the user should know

    std::map<std::string, SourceLocation>
        locations;  // of every key that was given, by dotted path: "start.omega_rad_s"

    // Location of a key, or of the nearest table above it that was given, or the file's beginning.
    SourceLocation location_of(const std::string& key) const;
    // The prefix of that: "file:line:column: ".
    std::string where(const std::string& key) const;
};

// The mechanics' problem: inertia, start, torque, method, and the span of the film, which holds
// t = 0.
MotionProblem problem_of(const Scene& scene);

// How far beyond a problem's span its curves are drawn, in s.
double overshoot_s(const MotionProblem& problem);

}  // namespace poinsot
