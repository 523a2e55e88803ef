// Everyday objects. The sources of their numbers are in the table in named_objects.cpp.
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "bodies/object_makers.h"
#include "bodies/object_shapes.h"
#include "bodies/solid_meshes.h"

namespace poinsot::object_makers {

namespace {

using std::numbers::pi;

TriangleMesh box_between(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) {
    return placed(box_mesh(high_m - low_m),
                  Eigen::Affine3d(Eigen::Translation3d(0.5 * (low_m + high_m))));
}

std::vector<ProfilePoint> rectangle(double inner_m, double outer_m, double height_m) {
    const double h = 0.5 * height_m;
    return {{inner_m, -h}, {outer_m, -h}, {outer_m, h}, {inner_m, h}};
}

// Parallel strings: how many, and how far apart.
struct Strings {
    int n = 0;
    double apart_m = 0.0;
};

// The strings of a racket, between the inner sides of its hoop.
std::vector<TriangleMesh> strings_in(const EllipticBar& hoop, double hoop_z_m, const Strings& along,
                                     const Strings& across, double radius_m) {
    const double inside_y_m = hoop.half_axis_y_m - hoop.half_width_in_plane_m;
    const double inside_z_m = hoop.half_axis_z_m - hoop.half_width_in_plane_m;
    std::vector<TriangleMesh> strings;
    for (int i = 0; i < along.n; ++i) {
        const double y = along.apart_m * (i - 0.5 * (along.n - 1));
        const double z = inside_z_m * std::sqrt(1.0 - std::pow(y / inside_y_m, 2));
        strings.push_back(placed(cylinder_mesh(radius_m, 2.0 * z, 8),
                                 Eigen::Affine3d(Eigen::Translation3d(0.0, y, hoop_z_m))));
    }
    for (int i = 0; i < across.n; ++i) {
        const double z = across.apart_m * (i - 0.5 * (across.n - 1));
        const double y = inside_y_m * std::sqrt(1.0 - std::pow(z / inside_z_m, 2));
        strings.push_back(
            straight_bar({0.0, -y, hoop_z_m + z}, {0.0, y, hoop_z_m + z}, radius_m, radius_m));
    }
    return strings;
}

// A surface of revolution near a height: its radius and the slope of its radius.
struct Meridian {
    std::function<double(double z_m)> radius_m;
    double slope(double z_m) const {
        constexpr double step_m = 1e-4;
        return (radius_m(z_m + step_m) - radius_m(z_m - step_m)) / (2.0 * step_m);
    }
};

// A box on the outside of a surface of revolution, on the side of −x, half sunk into it.
TriangleMesh box_on(const Meridian& surface, double z_m, double width_m, double length_m,
                    double thickness_m) {
    const Eigen::Vector3d outward = Eigen::Vector3d(-1.0, 0.0, -surface.slope(z_m)).normalized();
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear().col(0) = outward;
    placement.linear().col(1) = -Eigen::Vector3d::UnitY();
    placement.linear().col(2) = outward.cross(placement.linear().col(1));
    placement.translation() = Eigen::Vector3d(-surface.radius_m(z_m), 0.0, z_m);
    return placed(box_mesh({thickness_m, width_m, length_m}), placement);
}

// The laces of a football along one of its seams: eight stitches over a cord.
TriangleMesh laces_on(const Meridian& ball) {
    std::vector<TriangleMesh> laces;
    constexpr double apart_m = 0.014;
    laces.reserve(17);
    for (int i = 0; i < 8; ++i)
        laces.push_back(box_on(ball, apart_m * (i - 3.5), 0.030, 0.0055, 0.0060));
    for (int i = 0; i < 9; ++i)
        laces.push_back(box_on(ball, apart_m * (i - 4.0), 0.0055, 1.1 * apart_m, 0.0050));
    return joined(laces);
}

}  // namespace

// Crossbar along z, stem along −y: the moment about the stem is the middle one.
std::vector<ObjectPart> t_handle() {
    constexpr double bar_radius_m = 0.008;
    constexpr double bar_length_m = 0.100;
    constexpr double stem_radius_m = 0.006;
    constexpr double stem_length_m = 0.060;
    constexpr double aluminium_kg_m3 = 2700.0;
    return centred(
        {{"bar", cylinder_mesh(bar_radius_m, bar_length_m), {0.80, 0.30, 0.18}, aluminium_kg_m3},
         {"stem",
          rod_on_bar(bar_radius_m, stem_radius_m, stem_length_m),
          {0.72, 0.74, 0.78},
          aluminium_kg_m3}});
}

// Handle and long axis along z, strings in the y-z plane. The masses of the parts are chosen to
// give typical values: mass 340 g, balance 327 mm from the butt, swingweight (about an axis 100 mm
// from the butt) 0.033 kg m² and twistweight 0.0016 kg m². The ends of the throat lie inside the
// hoop and count twice there.
std::vector<ObjectPart> racket() {
    constexpr double length_m = 0.6858;
    constexpr double handle_length_m = 0.200;
    constexpr EllipticBar hoop{0.1285, 0.170, 0.0115, 0.0060};
    constexpr double hoop_z_m = length_m - hoop.half_axis_z_m - hoop.half_width_in_plane_m;
    // Visible on white paper and on a dark slide.
    constexpr std::array<double, 3> frame{0.60, 0.24, 0.28};

    const Eigen::Affine3d to_hoop(Eigen::Translation3d(0.0, 0.0, hoop_z_m));
    TriangleMesh ring = placed(elliptic_ring(hoop), to_hoop);

    // The throat runs from the handle to the point of the hoop 50° from its lowest point.
    const double at = 50.0 * pi / 180.0;
    std::vector<TriangleMesh> throat;
    for (const double side : {1.0, -1.0}) {
        throat.push_back(straight_bar({0.0, side * 0.010, handle_length_m},
                                      {0.0, side * hoop.half_axis_y_m * std::sin(at),
                                       hoop_z_m - hoop.half_axis_z_m * std::cos(at)},
                                      0.010, 0.0060));
    }

    // Sixteen strings along the racket and nineteen across, 1.3 mm thick. They are narrower than a
    // pixel of most pictures, so half as many are drawn, twice as thick.
    const std::vector<TriangleMesh> strings =
        strings_in(hoop, hoop_z_m, {16, 0.0125}, {19, 0.0155}, 0.00065);
    const std::vector<TriangleMesh> thick_strings =
        strings_in(hoop, hoop_z_m, {8, 0.0250}, {10, 0.0295}, 0.0013);

    std::vector<ObjectPart> parts;
    const auto add = [&](double mass_kg, ObjectPart part) {
        parts.push_back(of_mass({std::move(part)}, mass_kg).front());
    };
    add(0.1559, {"hoop", std::move(ring), frame});
    add(0.0314, {"throat", joined(throat), frame});
    add(0.1357,
        {"handle", octagonal_prism(0.029, 0.033, 0.008, 0.0, handle_length_m), {0.30, 0.28, 0.27}});
    constexpr std::array<double, 3> gut{0.70, 0.66, 0.52};
    add(0.0170, {"strings", joined(strings), gut});
    parts.back().use = PartUse::mass_only;
    parts.push_back({"thick strings", joined(thick_strings), gut, 1.0, PartUse::look_only});
    return centred(std::move(parts));
}

// Thickness along x, width along y, height along z; the spine is at the negative end of y.
std::vector<ObjectPart> book() {
    constexpr double page_width_m = 0.156;
    constexpr double page_height_m = 0.234;
    constexpr double leaves = 200.0;
    constexpr double leaf_m = 0.11e-3;
    constexpr double paper_kg_m3 = 0.080 / leaf_m;
    constexpr double board_m = 0.0025;
    constexpr double overhang_m = 0.003;
    constexpr double board_kg_m3 = 650.0;
    constexpr std::array<double, 3> cover{0.55, 0.12, 0.14};
    constexpr double x = 0.5 * leaves * leaf_m;
    constexpr double z = 0.5 * page_height_m;
    const TriangleMesh front = box_between(
        {x, 0.0, -z - overhang_m}, {x + board_m, page_width_m + overhang_m, z + overhang_m});
    const TriangleMesh back = placed(front, Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)));
    return centred({{"pages",
                     box_between({-x, 0.0, -z}, {x, page_width_m, z}),
                     {0.96, 0.94, 0.87},
                     paper_kg_m3},
                    {"front cover", front, cover, board_kg_m3},
                    {"back cover", back, {0.42, 0.09, 0.11}, board_kg_m3},
                    {"spine",
                     box_between({-x - board_m, -board_m, -z - overhang_m},
                                 {x + board_m, 0.0, z + overhang_m}),
                     {0.36, 0.08, 0.09},
                     board_kg_m3}});
}

// Thickness along x, with the glass at the positive end; width along y, height along z. The bump
// has no mass, so that the principal axes are those of the slab.
std::vector<ObjectPart> phone() {
    constexpr double x = 0.5 * 0.00780;
    constexpr double y = 0.5 * 0.0716;
    constexpr double z = 0.5 * 0.1476;
    constexpr double mass_kg = 0.171;
    constexpr double glass_m = 0.0008;
    constexpr double rim_m = 0.002;
    // The bump is a square in the upper corner, with two lenses on its diagonal.
    constexpr double bump_m = 0.032;
    constexpr double bump_height_m = 0.002;
    constexpr double edge_m = 0.004;
    constexpr double lens_radius_m = 0.0065;
    constexpr double lens_height_m = 0.001;
    // Lighter than the glass, so that both are seen on white paper and on a dark slide.
    constexpr std::array<double, 3> case_colour{0.42, 0.50, 0.60};
    constexpr std::array<double, 3> glass_colour{0.12, 0.13, 0.17};
    std::vector<ObjectPart> parts = of_mass(
        {{"case", box_between({-x, -y, -z}, {x - glass_m, y, z}), case_colour},
         {"glass", box_between({x - glass_m, rim_m - y, rim_m - z}, {x, y - rim_m, z - rim_m}),
          glass_colour}},
        mass_kg);
    const Eigen::Vector3d corner(-x, y - edge_m - bump_m, z - edge_m - bump_m);
    parts.push_back({"bump",
                     box_between(corner - bump_height_m * Eigen::Vector3d::UnitX(),
                                 corner + Eigen::Vector3d(0.0, bump_m, bump_m)),
                     {0.34, 0.41, 0.50},
                     1.0,
                     PartUse::look_only});
    std::vector<TriangleMesh> lenses;
    for (const double share : {0.29, 0.71}) {
        const Eigen::Vector3d at = corner + Eigen::Vector3d(-bump_height_m - 0.5 * lens_height_m,
                                                            share * bump_m, share * bump_m);
        lenses.push_back(placed(
            cylinder_mesh(lens_radius_m, lens_height_m),
            Eigen::Translation3d(at) * Eigen::AngleAxisd(0.5 * pi, Eigen::Vector3d::UnitY())));
    }
    parts.push_back({"lenses", joined(lenses), glass_colour, 1.0, PartUse::look_only});
    return centred(std::move(parts));
}

// Long axis along z. Length, girth and mass are the middle of the ranges that the rule allows: 11
// 1/8 and 21 1/8 inches, 14 1/2 ounces. The meridian is a mean of an ellipse and a parabola, as
// pointed as the smallest allowed long circumference, 28 inches, permits. Bladder and leather
// together are 4 mm thick.
std::vector<ObjectPart> football() {
    constexpr double inch_m = 0.0254;
    constexpr double half_length_m = 0.5 * 11.125 * inch_m;
    const double radius_m = 21.125 * inch_m / (2.0 * pi);
    constexpr double mass_kg = 14.5 * 0.028349523125;
    constexpr double thickness_m = 0.004;
    constexpr double ellipse_share = 0.77;
    constexpr int n_steps = 48;
    const auto meridian = [&](double shrunk_m, double angle) -> ProfilePoint {
        const double s = std::sin(angle);
        return {(radius_m - shrunk_m) * (ellipse_share * s + (1.0 - ellipse_share) * s * s),
                -(half_length_m - shrunk_m) * std::cos(angle)};
    };
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= n_steps; ++i) {
        const double angle = pi * i / n_steps;
        profile.push_back(meridian(0.0, angle));
    }
    profile.front().radius_m = profile.back().radius_m = 0.0;
    for (int i = 2 * n_steps + 1; i-- > n_steps + 1;) {
        const double angle = pi * (i - n_steps - 1) / (n_steps - 1);
        profile.push_back(meridian(thickness_m, angle));
    }
    profile[n_steps + 1].radius_m = profile.back().radius_m = 0.0;
    // Four panels in two alternating shades, lighter than leather, so that the axes stand out.
    constexpr int facets = 64;
    std::vector<ObjectPart> parts =
        of_mass({{"panels", sectors(profile, 4, even_sector, facets), {0.71, 0.45, 0.28}},
                 {"other panels", sectors(profile, 4, odd_sector, facets), {0.62, 0.36, 0.21}}},
                mass_kg);
    const Meridian surface{
        [&](double z_m) { return meridian(0.0, std::acos(-z_m / half_length_m)).radius_m; }};
    parts.push_back({"laces", laces_on(surface), {0.96, 0.95, 0.92}, 1.0, PartUse::look_only});
    return parts;
}

// Axis along z, the hollow side up: a flat well and a rising rim. One sixteenth of the rim carries
// the medallion.
std::vector<ObjectPart> plate() {
    constexpr double porcelain_kg_m3 = 2400.0;
    constexpr std::array<double, 3> white{0.86, 0.86, 0.84};
    const std::vector<ProfilePoint> well{{0.0, 0.0},      {0.080, 0.0},    {0.095, 0.004},
                                         {0.095, 0.0095}, {0.082, 0.0055}, {0.0, 0.0055}};
    const std::vector<ProfilePoint> rim{
        {0.095, 0.004}, {0.1325, 0.020}, {0.1335, 0.0225}, {0.1320, 0.0245}, {0.095, 0.0095}};
    const auto medallion = [](int sector) { return sector == 0; };
    const auto others = [](int sector) { return sector != 0; };
    // A line on the rim and a foot ring, which are thinner than the model's weight is known.
    constexpr double in_m = 0.1225, out_m = 0.1280, proud_m = 0.0005;
    const auto upper_m = [](double r) { return 0.0095 + (r - 0.095) * 0.015 / 0.037; };
    const std::vector<ProfilePoint> line{{in_m, upper_m(in_m) - proud_m},
                                         {out_m, upper_m(out_m) - proud_m},
                                         {out_m, upper_m(out_m) + proud_m},
                                         {in_m, upper_m(in_m) + proud_m}};
    const std::vector<ProfilePoint> foot{
        {0.066, -0.004}, {0.072, -0.004}, {0.074, 0.002}, {0.064, 0.002}};
    return centred(
        {{"well", welded(revolved_ring(well)), white, porcelain_kg_m3},
         {"rim", sectors(rim, 16, others), white, porcelain_kg_m3},
         {"medallion", sectors(rim, 16, medallion), {0.70, 0.10, 0.12}, porcelain_kg_m3},
         {"line", sectors(line, 16, others), {0.24, 0.36, 0.56}, 1.0, PartUse::look_only},
         {"foot", revolved_ring(foot), {0.72, 0.69, 0.64}, 1.0, PartUse::look_only}});
}

// Axis along z; twelve sectors make the rotation visible.
std::vector<ObjectPart> disc() {
    constexpr double polycarbonate_kg_m3 = 1200.0;
    const std::vector<ProfilePoint> profile = rectangle(0.0075, 0.060, 0.0012);
    constexpr int facets = 144;
    return {{"sectors",
             sectors(profile, 12, even_sector, facets),
             {0.78, 0.80, 0.84},
             polycarbonate_kg_m3},
            {"other sectors",
             sectors(profile, 12, odd_sector, facets),
             {0.58, 0.62, 0.70},
             polycarbonate_kg_m3}};
}

// Axis along z. Core and ring have the same density; twelve narrow sectors of the ring represent
// its stars.
std::vector<ObjectPart> coin() {
    constexpr double diameter_m = 0.02575;
    constexpr double core_diameter_m = 0.01875;
    constexpr double thickness_m = 0.0022;
    constexpr double mass_kg = 0.0085;
    const std::vector<ProfilePoint> ring =
        rectangle(0.5 * core_diameter_m, 0.5 * diameter_m, thickness_m);
    constexpr int facets = 144;
    return of_mass(
        {{"core", cylinder_mesh(0.5 * core_diameter_m, thickness_m, facets), {0.80, 0.66, 0.33}},
         {"ring",
          sectors(
              ring, 72, [](int sector) { return sector % 6 != 0; }, facets),
          {0.74, 0.74, 0.73}},
         {"stars",
          sectors(
              ring, 72, [](int sector) { return sector % 6 == 0; }, facets),
          {0.45, 0.45, 0.46}}},
        mass_kg);
}

}  // namespace poinsot::object_makers
