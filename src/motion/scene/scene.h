// All values of a scene file, as plain data with defaults.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bodies/triangle_mesh.h"
#include "image/image.h"
#include "measured/measured_motion.h"
#include "mechanics/free/polhode_start.h"
#include "mechanics/inertia.h"
#include "mechanics/motion_problem.h"
#include "mechanics/solids.h"

namespace poinsot {

// Where a value was given. line 0: by --set (then `file` is "--set key=value"), or it is a default.
struct SourceLocation {
    std::string file;
    int line = 0;    // from 1
    int column = 0;  // from 1, in characters
    // "file:line:column: ", "--set key=value: " or "file: ", safe to print on a terminal.
    std::string prefix() const;
};

// A closed surface of the body in one colour.
struct BodySurface {
    TriangleMesh mesh;                          // m, body axes, from the centre of mass
    std::optional<std::array<double, 3>> srgb;  // sRGB-encoded, 0…1; absent: the theme's
};

// [body]: how the inertia was given, and the resulting tensor.
struct BodySpec {
    enum class Given { moments, tensor, solid, masses, object, mesh };
    Given given = Given::moments;
    InertiaTensor inertia = InertiaTensor::from_principal_moments({3.0, 2.0, 1.0});
    std::string shape;              // solid: name of the solid
    std::vector<double> size_m;     // solid
    double mass_kg = 1.0;           // solid, object, mesh, or the sum of the masses
    std::vector<PointMass> masses;  // masses, relative to the centre of mass
    Eigen::Vector3d centre_of_mass_m_body = Eigen::Vector3d::Zero();  // of the masses as given
    std::vector<PointMass> masses_as_given;                           // at their given places
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
    std::string up;    // of body_faces(): where its top points; empty: the best fit
    Image image;       // the contents of the file
};

// [object]: how a body looks that is given by its moments or tensor.
struct ObjectSpec {
    std::string name;         // in the table of mesh/
    std::string mesh;         // or a file, as given
    std::string marked_face;  // of body_faces(); empty: none
    std::vector<FacePictureSpec> pictures;
};

// ω at t = 0 as given by T, and by L or the plane's distance.
struct ConservedStartSpec {
    ConservedQuantities quantities;
    std::optional<Eigen::Vector3d> direction_rad_s;  // ω as given: where on the polhode
    PolhodeStart start;                              // what follows
};

// [start]: ω and attitude at t = 0, or the top's Euler angles and rates.
struct StartSpec {
    Eigen::Vector3d omega_rad_s = Eigen::Vector3d::Zero();  // body axes
    std::optional<ConservedStartSpec> conserved;            // if ω follows from it
    Eigen::Quaterniond space_from_body = Eigen::Quaterniond::Identity();
    std::optional<TopStart> top;

    // How ω was given by conserved quantities; null if it was not, or was changed since, as for a
    // loop.
    const ConservedStartSpec* given_by_conserved() const {
        return conserved && conserved->start.omega_body == omega_rad_s ? &*conserved : nullptr;
    }
};

// Length of a film whose scene gives no length, in seconds of film.
constexpr double default_film_s = 10.0;

// [measured]: a motion that an instrument or another program recorded, to be shown beside the
// scene's.
struct MeasuredSpec {
    std::string file;       // as given; empty: none
    MeasuredMotion motion;  // its rows, with ω; their times are times of the scene
    // Whether a point of the file has no ω of its own: then it comes from differences of attitudes.
    bool has_derived_omega = false;

    bool given() const { return !motion.rows.empty(); }
};

// [film]: the instants that become video frames. Frame k shows second k/fps of the film; FilmClock
// converts that to an instant of the motion.
struct FilmSpec {
    double start_s = 0.0;
    std::optional<double> duration_s;  // of the motion shown; absent: it follows from length_s
    std::optional<double> length_s;    // of the film
    std::optional<double> still_s;     // instant of the motion that a still shows
    std::string loop;                  // "p/q", "period", or empty: not a loop
    std::string loop_changes;          // of loop_values(); empty: the one with the smallest change
    std::int64_t fps_numerator = 30, fps_denominator = 1;
    int width_px = 1920, height_px = 1080;
    double speed = 1.0;  // seconds of motion per second of film, until a keyframe changes it
    std::string quality = "lecture";
};

// [camera]: its vertical is the picture's: −L where the plane lies below, L where above.
struct CameraSpec {
    double azimuth_deg = -40.0;
    double elevation_deg = 14.0;
    double distance = 5.2;                  // in units of the largest half-axis, from the target
    double field_deg = 28.0;                // vertical
    double roll_deg = 0.0;                  // turns the picture counterclockwise
    std::optional<Eigen::Vector3d> target;  // picture axes; absent: what look_at names
    std::string look_at = "middle";         // of camera_aims()
    std::string view;                       // of camera_views(), which give the values not set here
    std::string motion = "fixed";           // fixed, co-precessing
    std::string projection = "perspective";  // of camera_projections()
};

// [panels.camera]: values by which the camera of one panel differs from [camera] or from that
// panel's own view. Empty and absent: not given.
struct PanelCameraSpec {
    std::optional<double> azimuth_deg, elevation_deg, distance, field_deg;
    std::optional<Eigen::Vector3d> target;
    std::string look_at, view, projection;
};

// [construction]: how Poinsot's construction lies in the picture, and the quantity swept over the
// film.
struct ConstructionSpec {
    std::string plane = "below";  // or "above": where the invariable plane lies in the picture
    std::string sweep;            // "axis", "energy": quantity that varies over the film in place
                                  // of time; empty: none
};

// [trail]: which part of the contact point's paths, and of a top's axis, is drawn, and how.
struct TrailSpec {
    std::string polhode = "whole";       // or "history", "fading"
    std::string herpolhode = "history";  // likewise
    std::string axis = "history";        // likewise: the path of a heavy top's axis
    std::optional<double> length_s;  // of a fading trail; absent: one polhode period or nutation
    bool direction_marks = false;    // chevrons that show the direction of motion
    bool ticks = false;              // at equal lengths of both paths of the contact point
};

// [[keyframes]]: values at a second of the film. A keyframe without a value does not affect the
// course of that value.
struct KeyframeSpec {
    double at_s = 0.0;              // of the film
    std::optional<int> panel;       // whose camera moves; absent: all panels that use [camera]
    std::string easing = "smooth";  // how the values move here from the previous keyframe
    std::string view;               // gives the camera values not set here
    std::optional<double> azimuth_deg, elevation_deg, distance, field_deg;
    std::optional<Eigen::Vector3d> target;
    std::string look_at;
    std::optional<double> speed;
};

// [[fades]]: elements, overlays or panels that appear, disappear or change opacity.
struct FadeSpec {
    double at_s = 0.0;  // of the film: the beginning
    double over_s = 1.0;
    std::string easing = "smooth";
    std::vector<std::string> elements;
    double opacity = 1.0;  // at the end
};

// [[chapters]]: named sections of the film; each ends where the next begins.
struct ChapterSpec {
    double at_s = 0.0;  // of the film
    std::string title;
};

// [[stops]]: instants of the film at which a page waits.
struct StopSpec {
    double at_s = 0.0;  // of the film
    std::string title;
    std::optional<double> loop_s;     // of the film, before the stop: repeated while the page waits
    std::string note;                 // for the lecturer
    std::optional<double> planned_s;  // of the lecture, when the lecturer begins with this stop
};

// [page]: what a page lets its viewers change.
struct PageSpec {
    std::optional<std::vector<std::string>> controls;  // keys as in --set; absent: controls_of()
    std::optional<std::vector<std::string>> elements;  // absent: all that are shown
    std::string next;  // file of the page that follows, in the same folder; empty: none
    std::optional<double> planned_s;  // of the lecture, for this scene
};

// [[captions]]: text shown for some seconds of the film.
struct TimedCaptionSpec {
    double at_s = 0.0;             // of the film
    std::optional<double> over_s;  // duration; absent: until the next in its place
    std::string text;              // with live numbers, like the caption
    std::string place = "bottom";  // bottom, top
};

// The values of `names`, and keys of [symbols] and [labels].
inline constexpr std::array<std::string_view, 9> named_things{
    "polhode",    "herpolhode", "invariable-plane", "inertia-ellipsoid", "body-cone",
    "space-cone", "separatrix", "unit-sphere",      "measured"};

// The quantities of [symbols], which are also keys of [labels].
inline constexpr std::array<std::string_view, 6> named_quantities{"omega", "momentum", "rho",
                                                                  "e1",    "e2",       "e3"};

// [symbols]: names of quantities in labels, as formulas; empty: the default names.
struct SymbolsSpec {
    std::string omega, momentum, rho, e1, e2, e3;
    // Names in words, with formulas between dollars, by the names in named_things.
    std::map<std::string, std::string, std::less<>> things;
};

// [style] of one quantity or surface; values not given are the theme's.
struct LookSpec {
    std::optional<std::array<double, 3>> srgb;  // sRGB-encoded, 0…1
    std::optional<double> weight;               // factor on the default
    std::optional<double> opacity_percent;      // of a surface, or of the ground
    std::string line;                           // of line_kinds(); empty: the default
};

// [style]: what differs from the theme.
struct StyleSpec {
    std::map<std::string, LookSpec, std::less<>> looks;  // by the names of style_roles()
    // Factors on the type size of each kind of text.
    std::optional<double> title_scale, caption_scale, heading_scale, label_scale, chart_scale;
};

// [[marks]]: a point that the user adds.
struct MarkSpec {
    std::string on = "ellipsoid";               // of mark_places()
    Eigen::Vector3d at{0.0, 0.0, 0.0};          // in the coordinates of its place
    std::string name;                           // as a formula; empty: none
    bool trail = false;                         // whether its path is shown
    std::string role = "mark";                  // of style_roles(): its colour in the theme
    std::optional<std::array<double, 3>> srgb;  // its own colour instead
};

// [[panels]]: one view of the motion, in cells of the grid.
struct PanelSpec {
    std::string kind = "space";
    int column = 0, row = 0;           // of its upper left cell
    int columns = 1, rows = 1;         // cells that it spans
    std::string quantity;              // of a plot, by name; empty: chosen for the motion
    std::optional<int> curves;         // of each family in the body panel; absent: as many as fit
    std::optional<std::string> title;  // above the panel, "": none; absent: its kind's default
    std::string inset;                 // corner with a view of the plane from above; empty: none
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
    std::string name = "scene";  // the file name without suffix
    std::filesystem::path file;
    std::string title;
    std::string caption;
    BodySpec body;
    ObjectSpec object;
    std::vector<BodySurface> surfaces;  // of an object or a mesh; empty: the body has no surfaces
    StartSpec start;
    Torque torque;
    std::optional<double> half_life_s;  // of internal friction given by it; determines the rate
    MethodChoice method;
    std::optional<MethodChoice> beside;  // a second method, drawn beside the first as a ghost
    MeasuredSpec measured;
    FilmSpec film;
    CameraSpec camera;
    ConstructionSpec construction;
    TrailSpec trail;
    std::vector<KeyframeSpec> keyframes;     // in order of at_s
    std::vector<FadeSpec> fades;             // in order of at_s
    std::vector<ChapterSpec> chapters;       // in order of at_s
    std::vector<TimedCaptionSpec> captions;  // in order of at_s
    std::vector<StopSpec> stops;             // in order of at_s
    PageSpec page;
    SymbolsSpec symbols;
    std::vector<std::string> units;  // units for displayed numbers; SI for all other quantities
    std::string language = "en";     // of the built-in words, of languages()
    bool overlays = true;            // title, captions and clock
    bool panel_letters = false;      // (a), (b), … before the headings of panels
    std::optional<bool> clock;       // whether it is shown; absent: if the film has one
    double type_scale = 1.0;         // of all text in the picture
    std::vector<std::string> show;  // elements by name; empty: the defaults for this kind of motion
    bool labels = true;             // whether elements are labelled
    std::vector<std::string> unlabelled;  // elements without labels
    // Which of named_things have names in the picture; absent: all that are shown.
    std::optional<std::vector<std::string>> names;
    // [labels]: how far labels are moved, x right and y down, points; by the names in named_things
    // and named_quantities.
    std::map<std::string, Eigen::Vector2d, std::less<>> label_offsets_pt;
    std::vector<MarkSpec> marks;
    GridSpec grid;
    std::vector<PanelSpec> panels;  // empty: the space panel alone
    std::string theme = "light";    // of a theme file: the theme that it extends
    StyleSpec style;                // the changes of that file, overridden by the scene's
    std::string hidden;             // pale, dashed, omitted: hidden lines; empty: as in the theme
    std::string hidden_arrows;      // likewise: hidden shafts of arrows; empty: as `hidden`
    std::string crossings;          // through, gap: where lines cross; empty: as in the theme
    double accuracy_px = 0.1;

    std::vector<std::string> notes;  // for the user: what the reader changed or found

    std::map<std::string, SourceLocation>
        locations;  // of every given key, by dotted path: "start.omega_rad_s"

    // Location of a key, of the nearest given table above it, or of the file's beginning.
    SourceLocation location_of(const std::string& key) const;
    // The prefix of that location: "file:line:column: ".
    std::string where(const std::string& key) const;
};

// The problem for mechanics/: inertia, start, torque, method, and the span of the film, which
// contains t = 0.
MotionProblem problem_of(const Scene& scene);

// The keys that viewers of a page may change: those of [page], or else the start and the moments of
// a free body that the scene gives by numbers. None for loops and measured motions: with other
// values they would not close, or not be what was measured.
std::vector<std::string> controls_of(const Scene& scene);

// How far beyond a problem's span its curves are drawn, in s.
double overshoot_s(const MotionProblem& problem);

}  // namespace poinsot
