// The renderer's only input: a flat list of plain shapes in views, with nothing of the physics in
// it.
//
// Lengths are in *picture units*: each view has its own axes, chosen by the drawing layer so that
// everything that matters has a size of order one (the largest half-axis of the ellipsoid is 1).
// Sizes that end in _px are pixels of the final picture. Colours are sRGB-encoded components in [0,
// 1]; the renderer mixes them in linear light.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace poinsot {

struct Colour {
    double r = 0.0, g = 0.0, b = 0.0;  // sRGB-encoded, 0…1
    bool operator==(const Colour&) const = default;
};

// Where a view is seen from. Orthographic views use height_units instead of the angle.
struct Camera {
    Eigen::Vector3d eye{3.0, -4.0, 2.0};
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    double vertical_field_rad = 0.6;  // full angle, top to bottom of the view
    bool orthographic = false;
    double height_units = 2.0;  // full height of the view, orthographic only
    bool operator==(const Camera&) const = default;
};

// One light from a direction, plus an even sky light.
struct Light {
    Eigen::Vector3d towards{0.3, -0.6,
                            0.8};  // unit; from the scene towards the light, picture axes
    double key = 0.75;
    double sky = 0.35;
    bool operator==(const Light&) const = default;
};

// A vertical gradient behind a view; alpha 0 leaves the picture transparent.
struct Background {
    Colour top{0.93, 0.95, 0.98};
    Colour bottom{1.0, 1.0, 1.0};
    double alpha = 1.0;
    bool operator==(const Background&) const = default;
};

// Ray-cast ellipsoid: x = centre + half_axes·u with |u| = 1. Columns of half_axes are orthogonal
// vectors. Ruled by body-fixed lines: its three principal sections, and meridians and parallels
// about the axis of column 2.
struct Ellipsoid {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Matrix3d half_axes = Eigen::Matrix3d::Identity();
    Colour colour{0.85, 0.62, 0.33};
    double opacity = 0.75;  // of the front surface seen face on; more towards the limb
    double presence = 1.0;  // 0…1: while it comes or goes; of all of it, lines and shadow too
    Colour line_colour{0.35, 0.22, 0.08};
    double section_px = 1.6;  // principal sections (0: none)
    double ruling_px = 0.8;   // meridians and parallels (0: none)
    double ruling_opacity = 0.35;
    int n_meridians = 12;
    int n_parallels = 5;       // between the poles
    bool casts_shadow = true;  // contact shadow on the planes below it
};

// A disc with a grid of lines through its centre, fading out to its rim.
struct Plane {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit
    Eigen::Vector3d along =
        Eigen::Vector3d::UnitX();  // unit, in the plane: direction of one family of lines
    double radius = 3.0;
    double fade_from = 0.55;  // fraction of the radius where it begins to fade
    double grid_spacing = 0.25;
    double grid_px = 1.0;
    Colour colour{0.80, 0.85, 0.92};
    Colour grid_colour{0.45, 0.52, 0.62};
    double opacity = 0.9;
    bool operator==(const Plane&) const = default;
};

// Open right circular cone from its apex, drawn translucent with its rim.
struct Cone {
    Eigen::Vector3d apex = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, from the apex into the cone
    double half_angle_rad = 0.5;                      // 0…π/2
    double length = 1.0;                              // along the axis
    Colour colour{0.4, 0.6, 0.8};
    double opacity = 0.35;
    double presence = 1.0;  // as of an ellipsoid
    double rim_px = 1.5;
    int n_rulings = 12;      // generators, so that rolling is seen
    double phase_rad = 0.0;  // of ruling 0, from `reference`
    Eigen::Vector3d reference = Eigen::Vector3d::UnitX();
};

// Points of a curve, made once and shared by all video frames; owned by the stage, which outlives
// its drawings. `id` is unique in the process, so that a renderer may keep the uploaded geometry.
struct CurveGeometry {
    std::uint64_t id = 0;
    std::vector<Eigen::Vector3d> points;
    bool closed = false;  // the last point joins the first (not repeated)
};

enum class Occlusion {
    none,      // always drawn in full: it lies on top of everything
    by_solids  // parts behind or inside an ellipsoid, mesh or plane are drawn in the hidden style
};

enum class HiddenStyle { dimmed, dashed, absent };

// A line of constant width in pixels along part of a geometry, with round joins and caps.
struct Curve {
    const CurveGeometry* geometry = nullptr;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();  // view axes from the geometry's axes
    double first =
        0.0;  // range shown, in points (fractions cut a segment); first > last shows nothing
    double last = 1e300;  // clamped to the number of points
    double width_px = 3.0;
    Colour colour;
    double opacity = 1.0;
    double hidden_opacity = 0.3;
    HiddenStyle hidden = HiddenStyle::dimmed;
    double dash_px = 0.0;  // length of a dash; 0: solid
    double gap_px = 0.0;   // between dashes; 0: as long as they
    double fade_points =
        0.0;  // opacity falls linearly to 0 over this many points behind `last`; 0: full history
    Occlusion occlusion = Occlusion::by_solids;
    int on_surface = -1;   // index of the ellipsoid of this view that it lies on: visible where the
                           // surface faces us
    int on_plane = -1;     // index of the plane it lies on
    bool lasting = false;  // whether nothing of it but `last` changes from picture to picture
};

// A straight arrow with a shaded round shaft and a conical head; proportions are kept at any length
// by the drawing layer.
struct Arrow {
    Eigen::Vector3d tail = Eigen::Vector3d::Zero();
    Eigen::Vector3d tip = Eigen::Vector3d::UnitZ();
    Colour colour;
    double shaft_px = 4.0;  // full width
    double head_px = 14.0;  // full width of the head's base
    double head_length_px = 22.0;
    double opacity = 1.0;
    double hidden_opacity = 0.45;
    Occlusion occlusion = Occlusion::by_solids;
};

// A dot with a rim: contact point, point masses.
struct Dot {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double radius_px = 6.0;
    Colour colour;
    Colour rim_colour{1.0, 1.0, 1.0};
    double rim_px = 1.5;
    double opacity = 1.0;
    double hidden_opacity = 0.4;
    Occlusion occlusion = Occlusion::by_solids;
};

// Triangles with one normal a corner, owned by the stage as CurveGeometry is.
struct MeshGeometry {
    std::uint64_t id = 0;
    std::vector<Eigen::Vector3f> positions;  // three a triangle
    std::vector<Eigen::Vector3f> normals;    // as many
};

struct Mesh {
    const MeshGeometry* geometry = nullptr;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    Colour colour{0.6, 0.65, 0.72};
    double opacity = 1.0;
    bool casts_shadow = true;
};

// A shape already flattened to the picture: glyph outlines and rules as one coverage mask.
struct GlyphMask {
    std::uint64_t id = 0;  // unique for its pixels
    int width = 0, height = 0;
    std::vector<std::uint8_t> coverage;  // row 0 on top
};

// Type set beforehand (typeset/), placed in pixels of the whole picture, drawn over everything of
// its view.
struct Label {
    const GlyphMask* mask = nullptr;
    Eigen::Vector2d top_left_px =
        Eigen::Vector2d::Zero();  // picture pixels, y down; whole pixels keep it crisp
    Colour colour;
    Colour halo_colour{1.0, 1.0, 1.0};
    double halo_px = 0.0;
    double opacity = 1.0;
};

// One picture within the picture, with its own axes and camera. Pixels, y down, row 0 on top.
struct View {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    Camera camera;
    Light light;
    Background background;
    std::vector<Plane> planes;
    std::vector<Ellipsoid> ellipsoids;
    std::vector<Cone> cones;
    std::vector<Mesh> meshes;
    std::vector<Curve> curves;
    std::vector<Arrow> arrows;
    std::vector<Dot> dots;
    std::vector<Label> labels;
    std::deque<GlyphMask> live_masks;  // of labels that belong to this drawing alone
};

// A whole video frame or still, or a part of one that is drawn by itself.
struct Drawing {
    int width_px = 0, height_px = 0;
    Background background;
    // Of a part: the rows that the background's gradient spans, from a row above the part or its
    // first; 0 rows: those of the picture.
    int background_top_px = 0, background_rows_px = 0;
    std::vector<View> views;
};

}  // namespace poinsot
