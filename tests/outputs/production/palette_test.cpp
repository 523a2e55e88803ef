// Colours of lines and letters on the surfaces that they lie on, as rendered: every surface is
// drawn in its own scene, lit and shaded, and measured in the pixels. Any two lines that can touch
// are told apart by every kind of colour vision, or by their dashes or widths. OKLab and the
// contrast are computed here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/style/colour_vision.h"
#include "drawing/style/theme.h"
#include "drawing/style/theme_contrast.h"
#include "drawing/style/theme_roles.h"
#include "image/image.h"
#include "places.h"
#include "production/session/session.h"
#include "production/stills/picture.h"
#include "production/stills/prepared_still.h"
#include "scene/files/load_scene.h"
#include "shapes/outlines.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::testing::palette_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

double linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
Vector3d linear(const Colour& c) { return {linear(c.r), linear(c.g), linear(c.b)}; }

// Björn Ottosson, "A perceptual color space for image processing" (2020).
Vector3d oklab(const Vector3d& light) {
    static const Matrix3d cones{{0.4122214708, 0.5363325363, 0.0514459929},
                                {0.2119034982, 0.6806995451, 0.1073969566},
                                {0.0883024619, 0.2817188376, 0.6299787005}};
    static const Matrix3d axes{{0.2104542553, 0.7936177850, -0.0040720468},
                               {1.9779984951, -2.4285922050, 0.4505937099},
                               {0.0259040371, 0.7827717662, -0.8086757660}};
    return axes * (cones * light).unaryExpr([](double x) { return std::cbrt(x); });
}

double distance(const Colour& a, const Colour& b, const Matrix3d& seen) {
    const auto clipped = [&](const Colour& c) -> Vector3d {
        return (seen * linear(c)).cwiseMax(0.0).cwiseMin(1.0);
    };
    return (oklab(clipped(a)) - oklab(clipped(b))).norm();
}

double luminance(const Colour& c) { return Vector3d(0.2126, 0.7152, 0.0722).dot(linear(c)); }

double contrast_of(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

Colour role(const Theme& theme, std::string_view name) {
    Theme copy = theme;
    return *look_of(copy, name).colour;
}

// The luminances of a surface's pixels, from the shaded to the lit side. The outermost tenths are
// left out: the rim, along which lines run into the outline, and the middle of the highlight.
struct Tones {
    std::string surface;
    double shaded = 0.0, lit = 0.0;
};

Tones tones_of(std::string surface, std::vector<double> luminances) {
    EXPECT_GT(luminances.size(), 400u) << surface;
    if (luminances.empty()) return {std::move(surface)};
    std::sort(luminances.begin(), luminances.end());
    const auto share = [&](double s) {
        return luminances[static_cast<std::size_t>(s * static_cast<double>(luminances.size() - 1))];
    };
    return {std::move(surface), share(0.1), share(0.9)};
}

using Change = std::function<void(View&)>;

// The surfaces of one panel of a scene, without lines on them.
class Surfaces {
 public:
    Surfaces(LazyRenderer& renderer, const Theme& theme, const std::string& scene,
             std::string_view panel, const std::string& size = "[640, 360]")
        : renderer_(renderer),
          panel_(panel),
          still_(prepare_still(
              session_of(scene_of(theme, scene, size), SessionRequest{installed_fonts()}), {})) {}

    static Scene scene_of(const Theme& theme, const std::string& scene,
                          const std::string& size = "[640, 360]") {
        const std::vector<Override> settings{{"film.size", size},
                                             {"theme", std::string(theme.name)}};
        return load_scene(source_folder() / "scenes" / (scene + ".toml"), settings);
    }

    // The picture of the panel's surfaces after a change of its view.
    Image drawn(const Change& change) {
        Drawing drawing = drawing_of(still_);
        std::erase_if(drawing.views, [&](const View& view) { return view.name != panel_; });
        EXPECT_EQ(drawing.views.size(), 1u) << panel_;
        for (View& view : drawing.views) {
            view.curves.clear();
            view.arrows.clear();
            view.dots.clear();
            view.labels.clear();
            for (Ellipsoid& each : view.ellipsoids) each.section_px = each.ruling_px = 0.0;
            for (Plane& each : view.planes) each.grid_px = 0.0;
            for (Cone& each : view.cones) each.rim_px = 0.0;
            change(view);
        }
        return renderer_.renderer().render(drawing);
    }

    // The arrows and curves of the panel, before any are taken away.
    View view() const {
        for (const View& each : drawing_of(still_).views)
            if (each.name == panel_) return each;
        return {};
    }

    // Luminances in a picture where two others differ, two pixels within that area's outline.
    static std::vector<double> where_differ(const Image& of, const Image& a, const Image& b,
                                            int within_px = 2) {
        std::vector<double> found;
        for (const Vector3d& light : light_where_differ(of, a, b, within_px))
            found.push_back(Vector3d(0.2126, 0.7152, 0.0722).dot(light));
        return found;
    }

    static std::vector<Vector3d> light_where_differ(const Image& of, const Image& a, const Image& b,
                                                    int within_px) {
        const auto differs = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= a.width() || y >= a.height()) return false;
            const Rgba8 &p = a.at(x, y), &q = b.at(x, y);
            return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 9;
        };
        std::vector<Vector3d> found;
        const int n = within_px;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                if (differs(x, y) && differs(x - n, y) && differs(x + n, y) && differs(x, y - n) &&
                    differs(x, y + n)) {
                    const Rgba8& p = of.at(x, y);
                    found.push_back(linear(Colour{p.r / 255.0, p.g / 255.0, p.b / 255.0}));
                }
        return found;
    }

 private:
    LazyRenderer& renderer_;
    std::string panel_;
    PreparedStill still_;
};

void nothing(View& view) {
    view.ellipsoids.clear();
    view.planes.clear();
    view.cones.clear();
    view.meshes.clear();
}

std::vector<Tones> surfaces_of(LazyRenderer& renderer, const Theme& theme) {
    std::vector<Tones> found;
    {
        Surfaces of(renderer, theme, "generic", "space");
        const Image bare = of.drawn(nothing);
        const Image body = of.drawn([](View& view) { view.planes.clear(); });
        const Image both = of.drawn([](View&) {});
        found.push_back(tones_of("body", Surfaces::where_differ(body, body, bare)));
        found.push_back(tones_of("body over its shadow", Surfaces::where_differ(both, body, bare)));
        const Image plane = of.drawn([](View& view) {
            view.ellipsoids.clear();
            view.planes.front().fade_from = 0.95;
        });
        found.push_back(tones_of("plane", Surfaces::where_differ(plane, plane, bare)));
    }
    {
        Surfaces of(renderer, theme, "momentum_sphere", "momentum");
        const Image bare = of.drawn(nothing), both = of.drawn([](View&) {});
        found.push_back(tones_of("sphere and ellipsoid", Surfaces::where_differ(both, both, bare)));
    }
    {
        Surfaces of(renderer, theme, "heavy_top_looping", "top");
        const Image bare = of.drawn(nothing);
        const Image disc = of.drawn([](View& view) { view.ellipsoids.clear(); });
        found.push_back(tones_of("disc", Surfaces::where_differ(disc, disc, bare)));
        const Image sphere = of.drawn([](View& view) { view.meshes.clear(); });
        found.push_back(tones_of("unit sphere", Surfaces::where_differ(sphere, sphere, bare)));
    }
    {
        Surfaces of(renderer, theme, "symmetric_prolate", "space");
        const Image bare = of.drawn(nothing);
        const Image cones = of.drawn([](View& view) {
            view.ellipsoids.clear();
            view.planes.clear();
        });
        found.push_back(tones_of("cones", Surfaces::where_differ(cones, cones, bare)));
    }
    for (const auto& [name, ground] : {std::pair{"ground, top", theme.background.top},
                                       std::pair{"ground, bottom", theme.background.bottom}})
        found.push_back({name, luminance(ground), luminance(ground)});
    return found;
}

// A line that does not reach the contrast, or a pair that is not told apart by its colours, and why
// it may be so.
struct Exception {
    std::string_view theme;  // empty: every theme
    std::string_view a, b;
    std::string_view why;
};

bool is_excepted(std::span<const Exception> list, std::string_view theme, std::string_view a,
                 std::string_view b) {
    return std::any_of(list.begin(), list.end(), [&](const Exception& each) {
        return (each.theme.empty() || each.theme == theme) &&
               ((each.a == a && each.b == b) || (each.a == b && each.b == a));
    });
}

constexpr std::array<std::string_view, 4> with_ground{"light", "dark", "print", "colour-blind"};

// The lines that can lie on each surface.
const std::vector<std::pair<std::string, std::vector<std::string_view>>> lines_on{
    {"body",
     {"polhode", "separatrix", "omega", "momentum", "rho", "gradient", "e1", "e2", "e3", "mark",
      "measured", "contact"}},
    {"body over its shadow", {"polhode", "separatrix", "omega", "momentum", "contact"}},
    {"plane",
     {"polhode", "herpolhode", "omega", "momentum", "rho", "gradient", "mark", "measured"}},
    {"sphere and ellipsoid",
     {"polhode", "momentum", "omega", "e1", "e2", "e3", "potential", "separatrix"}},
    {"disc", {"solid_lines"}},
    {"unit sphere", {"theta", "phi", "psi", "e1", "e3", "potential", "text"}},
    {"cones", {"momentum", "omega"}},
};

const std::vector<std::string_view> lines_on_ground{
    "polhode", "herpolhode", "omega", "momentum",   "rho",       "gradient",  "torque", "e1",
    "e2",      "e3",         "mark",  "measured",   "contact",   "theta",     "phi",    "psi",
    "energy",  "potential",  "ghost", "separatrix", "body_cone", "space_cone"};

constexpr std::string_view e3_is_an_arrow =
    "told from polhode and ω by its lightness; on the shaded side lies only the foot of its arrow";

// Accepted where the hue that tells a line apart would be lost.
const std::vector<Exception> faint{
    {"light", "e3", "body", e3_is_an_arrow},
    {"print", "e3", "body", e3_is_an_arrow},
    {"dark", "omega", "body", "2.8 at the lit side, where its shaft is lit, too"},
    {"dark", "omega", "body over its shadow", "2.8 at the lit side, where its shaft is lit, too"},
    {"colour-blind", "e3", "body", e3_is_an_arrow},
    {"light", "e3", "sphere and ellipsoid", e3_is_an_arrow},
    {"print", "e3", "sphere and ellipsoid", e3_is_an_arrow},
    {"colour-blind", "e3", "sphere and ellipsoid", e3_is_an_arrow},
    {"colour-blind", "measured", "body", "rows of dots, which no other line has"},
    {"dark", "omega", "sphere and ellipsoid", "a wide arrow; measured 2.1 where the light is"},
    {"dark", "omega", "cones", "the line along which the cones, of other hues, touch"},
};

TEST(Palette, LinesHaveAContrastOfThreeOnEverySurfaceAsRendered) {
    LazyRenderer renderer;
    std::set<std::string> needed;
    for (const std::string_view name : with_ground) {
        const Theme& theme = theme_named(name);
        for (const Tones& tones : surfaces_of(renderer, theme)) {
            const auto found = std::find_if(lines_on.begin(), lines_on.end(), [&](const auto& row) {
                return row.first == tones.surface;
            });
            for (const std::string_view line :
                 found != lines_on.end() ? found->second : lines_on_ground) {
                const double y = luminance(role(theme, line));
                const double least =
                    std::min(contrast_of(y, tones.shaded), contrast_of(y, tones.lit));
                if (is_excepted(faint, name, line, tones.surface)) {
                    // An exception that nothing needs is removed.
                    if (least < 3.0) needed.insert(fmt::format("{} {}", line, tones.surface));
                } else {
                    EXPECT_GE(least, 3.0) << name << ": " << line << " on " << tones.surface << " "
                                          << tones.shaded << " to " << tones.lit;
                }
            }
        }
    }
    for (const Exception& each : faint)
        EXPECT_TRUE(needed.contains(fmt::format("{} {}", each.a, each.b))) << each.a << each.b;
}

double median(std::vector<double> values) {
    EXPECT_GT(values.size(), 20u);
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

// ρ is the subject of the construction. Of the five arrows through its centre it has the strongest
// colour: in the pixels, shaded, and seen through the body.
TEST(Palette, RhoHasTheStrongestColourOfTheFiveArrows) {
    LazyRenderer renderer;
    for (const std::string_view name : with_ground) {
        const Theme& theme = theme_named(name);
        Surfaces of(renderer, theme, "generic", "space", "[1920, 1080]");
        const View whole = of.view();
        const Image bare = of.drawn([](View&) {});
        const auto chroma_of = [&](std::string_view line) {
            const Colour colour = role(theme, line);
            const Image with = of.drawn([&](View& view) {
                for (const Arrow& arrow : whole.arrows)
                    if (arrow.colour == colour) view.arrows.push_back(arrow);
            });
            std::vector<double> chroma;
            for (const Vector3d& light : Surfaces::light_where_differ(with, with, bare, 1))
                chroma.push_back(oklab(light).tail<2>().norm());
            return median(std::move(chroma));
        };
        const double rho = chroma_of("rho");
        EXPECT_GE(rho, 0.14) << name;  // in OKLab; half-faded red lines have 0.115
        for (const std::string_view line : {"omega", "e1", "e2", "e3"})
            EXPECT_GT(rho, chroma_of(line)) << name << ": " << line;
    }
}

// Each of the two curves is one closed line: the part that the body hides is pale, but seen.
TEST(Palette, TheFarHalvesOfBothCurvesAreSeenThroughTheBody) {
    LazyRenderer renderer;
    for (const std::string_view name : with_ground) {
        const Theme& theme = theme_named(name);
        Surfaces of(renderer, theme, "generic", "space", "[1920, 1080]");
        const View whole = of.view();
        for (const std::string_view curve : {"polhode", "herpolhode"}) {
            const Colour colour = role(theme, curve);
            const auto drawn = [&](bool has_hidden, const Change& change) {
                return of.drawn([&](View& view) {
                    for (Curve each : whole.curves) {
                        if (each.name.element != curve || !(each.colour == colour)) continue;
                        if (!has_hidden) each.hidden = HiddenStyle::absent;
                        view.curves.push_back(each);
                    }
                    change(view);
                });
            };
            const auto as_it_is = [](View&) {};
            const Image with = drawn(true, as_it_is), without = drawn(false, as_it_is);
            const std::vector<double> line = Surfaces::where_differ(with, with, without, 1);
            const std::vector<double> under = Surfaces::where_differ(without, with, without, 1);
            std::vector<double> ratios;
            for (std::size_t k = 0; k < line.size(); ++k)
                ratios.push_back(contrast_of(line[k], under[k]));
            EXPECT_GE(median(std::move(ratios)), 2.0) << name << ": " << curve;
        }
    }
}

// Points of a body's limb in the picture: with the eye at e in axes in which the body is the unit
// sphere, the limb is the circle in which the sphere meets the polar plane u·e = 1.
std::vector<Vector2d> limb_of(const View& view, const Ellipsoid& body) {
    EXPECT_FALSE(view.camera.orthographic);
    const Vector3d eye = body.half_axes.inverse() * (view.camera.eye - body.centre);
    const double distance = eye.norm();
    const Vector3d axis = eye / distance, across = axis.unitOrthogonal(), up = axis.cross(across);
    const double radius = std::sqrt(1.0 - 1.0 / (distance * distance));
    std::vector<Vector2d> points;
    constexpr int n = 360;
    for (int k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n;
        const Vector3d u =
            axis / distance + radius * (std::cos(angle) * across + std::sin(angle) * up);
        points.push_back(project(view, body.centre + body.half_axes * u).px);
    }
    return points;
}

// The share of a body's outline, outside of other bodies, that hardly differs from the ground
// beside it.
double share_that_melts(const Image& image, const View& view, const Ellipsoid& body) {
    const std::vector<Vector2d> limb = limb_of(view, body);
    const auto at = [&](const Vector2d& px) {
        const Rgba8& p = image.at(std::clamp(static_cast<int>(px.x()), 0, image.width() - 1),
                                  std::clamp(static_cast<int>(px.y()), 0, image.height() - 1));
        return luminance({p.r / 255.0, p.g / 255.0, p.b / 255.0});
    };
    // A contour that lies on two pixels has half of its strength in each.
    constexpr double least_contrast = 1.3;
    int n_melting = 0, n_free = 0;
    for (std::size_t k = 0; k < limb.size(); ++k) {
        if (std::any_of(view.ellipsoids.begin(), view.ellipsoids.end(), [&](const Ellipsoid& one) {
                return &one != &body && nearness_to_ellipsoid(view, one, limb[k]) < 1.1;
            }))
            continue;
        ++n_free;
        const Vector2d along = limb[(k + 1) % limb.size()] - limb[k];
        Vector2d out = Vector2d(along.y(), -along.x()).normalized();
        if (out.dot(limb[k] - limb[(k + limb.size() / 2) % limb.size()]) < 0.0) out = -out;
        const double ground = at(limb[k] + 4.0 * out);
        double most = 1.0;
        for (double step_px = -3.0; step_px <= 1.0; step_px += 0.5)
            most = std::max(most, contrast_of(at(limb[k] + step_px * out), ground));
        n_melting += most < least_contrast ? 1 : 0;
    }
    return n_melting / std::max(1.0, static_cast<double>(n_free));
}

TEST(Palette, EveryBodyHasAContour) {
    LazyRenderer renderer;
    const std::vector<std::pair<std::string, std::string>> pictures{
        {"generic", "space"},           {"sphere", "space"},          {"stable_largest", "space"},
        {"symmetric_oblate", "space"},  {"heavy_top_looping", "top"}, {"heavy_top_sleeping", "top"},
        {"momentum_sphere", "momentum"}};
    for (const std::string_view name : with_ground) {
        const Theme& theme = theme_named(name);
        for (const auto& [scene, panel] : pictures) {
            Surfaces of(renderer, theme, scene, panel, "[1280, 720]");
            View drawn;
            const Image image = of.drawn([&](View& view) {
                view.planes.clear();
                view.meshes.clear();
                view.cones.clear();
                drawn = view;
            });
            // Measured: at most 0.031, where the line of one pixel lies on two.
            for (const Ellipsoid& body : drawn.ellipsoids)
                EXPECT_LE(share_that_melts(image, drawn, body), 0.05) << name << ": " << scene;
        }
        // What is measured is there to be found: without the contour a fifth melts.
        Surfaces of(renderer, theme, "generic", "space", "[1280, 720]");
        View drawn;
        const Image image = of.drawn([&](View& view) {
            view.planes.clear();
            for (Ellipsoid& body : view.ellipsoids) body.contour_px = 0.0;
            drawn = view;
        });
        if (name == "light" || name == "dark") {
            EXPECT_GT(share_that_melts(image, drawn, drawn.ellipsoids.front()), 0.1) << name;
        }
    }
}

// Lines of one view that touch or cross: those through the contact and the centre of the
// construction, and those of a top's sphere. The path of e3 is "path".
const std::vector<std::vector<std::string_view>> meeting{
    {"polhode", "herpolhode", "omega", "momentum", "rho", "e1", "e2", "e3"},
    {"gradient", "polhode", "omega", "rho", "momentum"},
    {"gradient", "e1", "e2", "e3"},
    {"torque", "momentum", "omega", "e1", "e2", "e3"},
    {"mark", "herpolhode", "polhode", "omega", "momentum"},
    {"measured", "polhode", "herpolhode", "momentum", "omega"},
    {"theta", "phi", "psi", "e1", "e3"},
    {"path", "phi", "psi"},
    {"path", "theta"},
    {"phi", "momentum", "omega", "e2"},
    {"potential", "polhode", "herpolhode", "momentum"},
};

const std::vector<Exception> alike{};

Colour line_colour(const Theme& theme, std::string_view name) {
    return name == "path" ? path_of_e3(theme) : role(theme, name);
}

TEST(Palette, LinesThatMeetAreToldApartByEveryColourVision) {
    std::set<std::string> needed;
    for (const Theme& theme : themes())
        for (const auto& lines : meeting)
            for (const std::string_view a : lines)
                for (const std::string_view b : lines) {
                    if (!(a < b)) continue;
                    for (const Vision& vision : visions()) {
                        const bool is_normal = vision.eye.empty();
                        const double apart = distance(line_colour(theme, a), line_colour(theme, b),
                                                      vision.seen_from_linear);
                        const double least = is_normal ? 0.12 : 0.07;
                        if (is_excepted(alike, theme.name, a, b)) {
                            if (apart < least) needed.insert(fmt::format("{} {}", a, b));
                        } else {
                            EXPECT_GE(apart, least) << theme.name << ": " << a << " and " << b
                                                    << (is_normal ? "" : vision.eye);
                        }
                    }
                }
    for (const Exception& each : alike)
        EXPECT_TRUE(needed.contains(fmt::format("{} {}", each.a, each.b))) << each.a << each.b;
}

// On paper in black and white, lines of one kind differ in lightness: the two curves, the arrows
// that start in the centre, and the axes. Curves differ from arrows by their heads.
TEST(Palette, PrintIsToldApartByLightnessAlone) {
    const Theme& theme = theme_named("print");
    const std::vector<std::vector<std::string_view>> kinds{{"polhode", "herpolhode"},
                                                           {"momentum", "omega", "rho"},
                                                           {"momentum", "omega", "e1"},
                                                           {"e1", "e2", "e3"}};
    for (const auto& lines : kinds)
        for (const std::string_view a : lines)
            for (const std::string_view b : lines) {
                if (!(a < b)) continue;
                const double apart =
                    std::abs(oklab(linear(role(theme, a))).x() - oklab(linear(role(theme, b))).x());
                EXPECT_GE(apart, 0.07) << a << " and " << b;
            }
    // The floor is quieter than what lies on it.
    for (const Theme& each : themes())
        for (const std::string_view line : {"polhode", "herpolhode"})
            EXPECT_GE(contrast_of(luminance(role(each, line)), luminance(each.plane)),
                      1.8 * contrast_of(luminance(each.grid), luminance(each.plane)))
                << each.name;
}

// The formulas of the two surfaces of momentum are told apart by the colours of their letters.
TEST(Palette, FormulasOfSphereAndEllipsoidDiffer) {
    for (const Theme& theme : themes())
        for (const Vision& vision : visions())
            EXPECT_GE(
                distance(letter_colour(theme, theme.sphere),
                         letter_colour(theme, theme.ellipsoid_lines), vision.seen_from_linear),
                vision.eye.empty() ? 0.12 : 0.07)
                << theme.name << vision.eye;
}

// In the space panel and the plan, a wider line in the colour of halos lies under the herpolhode.
TEST(Palette, HerpolhodeLiesOnAPaleEdge) {
    for (const std::string_view name : with_ground) {
        const Theme& theme = theme_named(name);
        Scene scene = Surfaces::scene_of(theme, "loop_generic");
        scene.crossings = "through";  // whole curves
        const PreparedStill still =
            prepare_still(session_of(scene, SessionRequest{installed_fonts()}), {});
        int n_found = 0;
        const Drawing drawing = drawing_of(still);
        for (const View& view : drawing.views)
            for (std::size_t k = 1; k < view.curves.size(); ++k) {
                const Curve &edge = view.curves[k - 1], &curve = view.curves[k];
                if (edge.name.element != "herpolhode" || edge.name.part != "edge") continue;
                ++n_found;
                EXPECT_EQ(edge.geometry, curve.geometry);
                EXPECT_EQ(edge.colour, theme.halo);
                EXPECT_EQ(curve.colour, Colour(theme.herpolhode));
                EXPECT_GT(edge.width_px, curve.width_px + 1.0);
            }
        EXPECT_EQ(n_found, 2) << name;
    }
}

TEST(Palette, HerpolhodeIsAsStrongAsThePolhode) {
    for (const Theme& theme : themes()) {
        EXPECT_GE(theme.herpolhode_weight, theme.polhode_weight) << theme.name;
        EXPECT_GE(theme.polhode_weight, 1.2) << theme.name;
    }
}

}  // namespace
}  // namespace poinsot::testing::palette_tests
