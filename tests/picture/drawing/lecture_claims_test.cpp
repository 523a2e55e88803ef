// The lecture, claim by claim: the drawings of the scenes satisfy the claims that the scenes
// illustrate. Expected values are computed from the inertia and ω in the scene files alone.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/stage/live_values.h"
#include "places.h"
#include "scene/files/load_scene.h"
#include "scene/film_clock.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A scene of the lecture on its stage.
struct Lecture {
    Scene scene;
    double last_time_s;
    StagedScene staged;

    explicit Lecture(const std::string& name)
        : scene(load_scene(source_folder() / "scenes" / (name + ".toml"),
                           std::vector<Override>{{"crossings", "through"}})),  // whole curves
          last_time_s(scene.film.start_s + scene.film.duration_s.value_or(default_film_s)),
          staged(scene, last_time_s) {}

    std::vector<double> instants(int n = 7) const {
        std::vector<double> times;
        for (int k = 0; k < n; ++k) {
            times.push_back(scene.film.start_s +
                            (last_time_s - scene.film.start_s) * (k + 0.37) / n);
        }
        return times;
    }
    const Theme& theme() const { return staged.stage.context().theme; }
    Vector3d moments() const { return scene.body.inertia.moments_kg_m2(); }
    // √(2T)/L in units of the largest half-axis, from the scene's numbers.
    double distance() const {
        const Vector3d omega =
            scene.body.inertia.body_from_principal().transpose() * scene.start.omega_rad_s;
        const Vector3d momentum = moments().cwiseProduct(omega);
        return std::sqrt(omega.dot(momentum)) / momentum.norm() * std::sqrt(moments().minCoeff());
    }
};

const Arrow& arrow_of(const View& view, const Colour& colour) {
    for (const Arrow& arrow : view.arrows) {
        if (arrow.colour == colour) return arrow;
    }
    throw std::runtime_error("no arrow of this colour");
}

// Curves with this colour.
std::vector<const Curve*> curves_of(const View& view, const Colour& colour) {
    std::vector<const Curve*> found;
    for (const Curve& curve : view.curves) {
        if (curve.colour == colour) found.push_back(&curve);
    }
    return found;
}

Vector3d end_of(const Curve& line) { return line.placement * line.geometry->points.back(); }
Vector3d start_of(const Curve& line) { return line.placement * line.geometry->points.front(); }

// The drawn e1, e2, e3.
Matrix3d axes_of(const View& view, const Theme& theme) {
    Matrix3d axes;
    for (int i = 0; i < 3; ++i) axes.col(i) = arrow_of(view, theme.axes[i]).tip.normalized();
    return axes;
}

// F(ρ) = ρ·Iρ of a point in picture lengths.
double form(const Ellipsoid& ellipsoid, const Vector3d& point) {
    return (ellipsoid.half_axes.inverse() * point).squaredNorm();
}

// Whether a label of a view has a text.
bool says(const View& view, std::string_view text) {
    return std::any_of(view.labels.begin(), view.labels.end(), [text](const Label& label) {
        return label.mask->source.text.find(text) != std::string::npos;
    });
}

bool shows(const View& view, std::string_view element) {
    const auto is_one = [element](const auto& shape) {
        return shape.name.element == element && shape.opacity > 0.5;
    };
    return std::any_of(view.arrows.begin(), view.arrows.end(), is_one) ||
           std::any_of(view.curves.begin(), view.curves.end(), is_one) ||
           std::any_of(view.planes.begin(), view.planes.end(), is_one);
}

// Stops of the lecture show what their titles name.
TEST(LectureClaims, StopsShowWhatTheyName) {
    const Lecture lecture("lecture");
    const FilmClock clock(lecture.scene);
    const auto at_stop = [&](std::size_t number) {
        const double film_s = lecture.scene.stops.at(number - 1).at_s;
        return lecture.staged.stage.at(FilmTime{clock.time_at(film_s), film_s});
    };
    // 1: ω, whose product with L moves L in the body.
    Drawing drawing = at_stop(1);
    EXPECT_TRUE(shows(drawing.views.front(), "omega"));
    // 4: an axis n with I(n), before ρ is defined; 5: ρ and its path.
    drawing = at_stop(4);
    EXPECT_TRUE(says(drawing.views.front(), "\\mathbf{n}"));
    EXPECT_FALSE(says(drawing.views.front(), "rho"));
    EXPECT_FALSE(shows(drawing.views.front(), "trace"));
    drawing = at_stop(5);
    EXPECT_TRUE(says(drawing.views.front(), "rho"));
    EXPECT_TRUE(shows(drawing.views.front(), "trace"));
    // 7: n along ω with its moment.
    drawing = at_stop(7);
    EXPECT_TRUE(shows(drawing.views.front(), "spin-direction"));
    EXPECT_TRUE(says(drawing.views.front(), "2T/"));
    // 8 and 9: the tangent plane, and ∇F at right angles to it.
    for (const std::size_t number : {8u, 9u}) {
        drawing = at_stop(number);
        EXPECT_TRUE(says(drawing.views.front(), "tangent plane")) << number;
        EXPECT_TRUE(shows(drawing.views.front(), "tangent")) << number;
        const auto& curves = drawing.views.front().curves;
        EXPECT_EQ(
            std::count_if(curves.begin(), curves.end(),
                          [](const Curve& curve) { return curve.name.element == "gradient"; }),
            2)
            << number;
    }
    // 10: the projection, with its right angle on L: two lines and the two legs of the mark.
    drawing = at_stop(10);
    const auto& lines = drawing.views.front().curves;
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const Curve& curve) {
                                return curve.name.element == "projection" && curve.opacity > 0.5;
                            }),
              4);
    // 15: the herpolhode fills more than half of the picture's height, and all of it is seen.
    drawing = at_stop(15);
    const View& view = drawing.views.front();
    double top = 1e9, bottom = -1e9;
    for (const Curve& curve : view.curves) {
        if (curve.name.element != "herpolhode") continue;
        for (const Vector3d& point : curve.geometry->points) {
            const double y = project(view, curve.placement * point).px.y();
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    EXPECT_GT(bottom - top, 0.55 * view.height_px);
    EXPECT_GT(top, 0.0);
    EXPECT_LT(bottom, 0.92 * view.height_px);
    // 16 and 17: the body turns beside the construction.
    for (const std::size_t number : {16u, 17u})
        EXPECT_TRUE(shows(at_stop(number).views.front(), "body-beside"));
    EXPECT_FALSE(shows(at_stop(14).views.front(), "body-beside"));
}

TEST(LectureClaims, PrincipalAxesMakeTheTensorDiagonal) {  // pages 2–5
    const Lecture lecture("tensor");
    const Drawing drawing = lecture.staged.stage.at(3.0);
    const View& view = drawing.views.front();
    const Matrix3d principal = axes_of(view, lecture.theme());
    Matrix3d given;
    int n = 0;
    for (const Arrow& arrow : view.arrows) {
        if (arrow.colour == lecture.theme().potential) given.col(n++) = arrow.tip.normalized();
    }
    ASSERT_EQ(n, 3);
    const Matrix3d turn = given.transpose() * principal;  // the components of e_i along x, y, z
    const Matrix3d diagonal = turn.transpose() * lecture.scene.body.tensor_kg_m2 * turn;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(diagonal(i, i), lecture.moments()[i], 1e-14);
        EXPECT_NEAR(diagonal(i, (i + 1) % 3), 0.0, 1e-14);
    }
    EXPECT_NEAR(turn.determinant(), 1.0, 1e-14);
    // An arc ends on each principal axis, before its tip.
    n = 0;
    for (const Arrow& head : view.arrows) {
        if (!(head.colour == lecture.theme().angles[0])) continue;
        const Vector3d e = principal.col(n);
        EXPECT_NEAR(head.tip.normalized().dot(e), 1.0, 1e-12);
        EXPECT_LT(head.tip.norm(), arrow_of(view, lecture.theme().axes[n]).tip.norm());
        ++n;
    }
    EXPECT_EQ(n, 3);
    // The axis of the drawn rotation is invariant.
    const Vector3d axis = end_of(*curves_of(view, lecture.theme().angles[0]).front()).normalized();
    EXPECT_LT((given * (turn * (given.transpose() * axis)) - axis).norm(), 1e-13);
}

TEST(LectureClaims, MomentumRestsInSpaceAndMovesInTheBody) {  // pages 6, 8
    const Lecture lecture("four_views");
    Vector3d in_space, in_body;
    double turned = 0.0;
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const Vector3d space = arrow_of(drawing.views.at(0), lecture.theme().momentum).tip;
        const Vector3d body = arrow_of(drawing.views.at(1), lecture.theme().momentum).tip;
        if (t == lecture.instants().front()) in_space = space, in_body = body;
        EXPECT_EQ(space, in_space);
        turned = std::max(turned, body.normalized().cross(in_body.normalized()).norm());
    }
    EXPECT_GT(turned, 0.5);
    // The numbers of the caption, from the state at the instant.
    const double T = 0.5 * lecture.moments().dot(lecture.scene.start.omega_rad_s.cwiseAbs2());
    for (const double t : lecture.instants()) {
        FrameInput instant;
        instant.state = lecture.staged.motion.at(t);
        for (const LiveValue& value : live_values(lecture.scene, instant)) {
            if (value.name == "kinetic_energy_J") {
                EXPECT_NEAR(value.value, T, 4e-15 * T);
            }
        }
    }
}

TEST(LectureClaims, MomentumMovesInTheBodyByMinusOmegaCrossL) {  // page 6
    const Lecture lecture("momentum_sphere");
    const auto view_at = [&](double t) { return lecture.staged.stage.at(t).views.front(); };
    const auto momentum_at = [&](double t) {
        return arrow_of(view_at(t), lecture.theme().momentum).tip;
    };
    double factor = 0.0;
    for (const double t : lecture.instants()) {
        const View view = view_at(t);
        const Vector3d L = arrow_of(view, lecture.theme().momentum).tip;
        const Arrow& arrow = arrow_of(view, lecture.theme().potential);
        EXPECT_EQ(arrow.tail, L);
        const Vector3d velocity = arrow.tip - arrow.tail;
        // ω = L/I along its arrow, and −ω × L along the other.
        const Vector3d omega = L.cwiseQuotient(lecture.moments());
        EXPECT_GT(arrow_of(view, lecture.theme().omega).tip.normalized().dot(omega.normalized()),
                  1.0 - 1e-14);
        EXPECT_GT(velocity.normalized().dot(L.cross(omega).normalized()), 1.0 - 1e-14);
        // The drawn L moves as this arrow says, with one scale for all instants.
        constexpr double h = 1e-4;
        const Vector3d moved = (momentum_at(t + h) - momentum_at(t - h)) / (2.0 * h);
        if (factor == 0.0) factor = moved.norm() / velocity.norm();
        EXPECT_LT((moved - factor * velocity).norm(), 1e-6 * factor);
    }
}

TEST(LectureClaims, EnergyAndMomentumStayExceptByEulersMethod) {  // page 8
    const Lecture lecture("euler_drift");
    const StageContext& stage = lecture.staged.stage.context();
    const PlotQuantity& quantity = plot_quantity_of(stage, lecture.scene.panels.back().quantity);
    MotionProblem problem = problem_of(lecture.scene);
    problem.method = *lecture.scene.beside;
    const Motion euler(problem);
    const Vector3d omega = lecture.scene.start.omega_rad_s;
    const Vector3d momentum = lecture.moments().cwiseProduct(omega);
    const double T = 0.5 * omega.dot(momentum);
    for (const double t : lecture.instants()) {
        FrameInput instant;
        instant.state = lecture.staged.motion.at(t);
        EXPECT_NEAR(quantity.values(stage, instant)[0], T, 4e-15 * T);
        EXPECT_NEAR(quantity.values(stage, instant)[1], momentum.norm(), 4e-15 * momentum.norm());
    }
    FrameInput last;
    last.state = euler.at(lecture.last_time_s);
    EXPECT_GT(quantity.values(stage, last)[0], 1.5 * T);
    EXPECT_GT(quantity.values(stage, last)[1], 1.2 * momentum.norm());
}

TEST(LectureClaims, TorqueAlongAPrincipalAxisChangesThatRateEvenly) {  // page 7
    for (const std::string name : {"torque_axis", "torque_symmetric"}) {
        const Lecture lecture(name);
        const auto& torque = std::get<ConstantTorqueInBody>(lecture.scene.torque);
        const double rate = torque.torque_body_N_m[0] / lecture.moments()[0];
        for (const double t : lecture.instants()) {
            const Vector3d omega = lecture.staged.motion.at(t).omega_body;
            EXPECT_NEAR(omega[0], lecture.scene.start.omega_rad_s[0] + rate * t, 1e-7) << name;
            // N as an arrow, along e1.
            const Drawing drawing = lecture.staged.stage.at(t);
            const View& view = drawing.views.front();
            const Arrow& N = arrow_of(view, lecture.theme().torque);
            const Vector3d e1 = arrow_of(view, lecture.theme().axes[0]).tip.normalized();
            EXPECT_GT((N.tip - N.tail).normalized().dot(e1), 1.0 - 1e-12) << name;
        }
    }
    const Lecture symmetric("torque_symmetric");
    EXPECT_EQ(symmetric.moments()[1], symmetric.moments()[2]);
    EXPECT_NE(symmetric.scene.start.omega_rad_s[1], 0.0);
}

TEST(LectureClaims, PointsOfLengthOneOverRootIMakeTheEllipsoid) {  // pages 9–10
    const Lecture lecture("inertia_ellipsoid");
    ASSERT_TRUE(lecture.scene.start.omega_rad_s.isZero(0.0));  // at rest
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d rho = arrow_of(view, lecture.theme().rho).tip;
        const Vector3d n = rho.normalized();
        const double I = lecture.moments().dot(n.cwiseAbs2());
        EXPECT_NEAR(rho.norm(), std::sqrt(lecture.moments().minCoeff() / I), 1e-14);
        EXPECT_NEAR(form(view.ellipsoids.front(), rho), 1.0, 1e-14);
        const Arrow& axis = arrow_of(view, lecture.theme().text);
        EXPECT_LT(axis.tip.normalized().cross(n).norm(), 1e-14);
        // The half-axes 1/√Iᵢ along e₁, e₂, e₃.
        for (int i = 0; i < 3; ++i) {
            const Vector3d end = end_of(*curves_of(view, lecture.theme().axes[i]).front());
            const double half_axis = std::sqrt(lecture.moments().minCoeff() / lecture.moments()[i]);
            EXPECT_LT((end - half_axis * Vector3d::Unit(i)).norm(), 1e-14);
        }
        // The traced curve ends at the tip of ρ, on the surface.
        const Curve& trace = *curves_of(view, lecture.theme().rho).front();
        const auto last = static_cast<std::size_t>(std::ceil(trace.last));
        EXPECT_LT((trace.geometry->points.at(last) - rho).norm(), 0.2);
        for (std::size_t k = 0; k <= last; k += 37) {
            EXPECT_NEAR(form(view.ellipsoids.front(), trace.geometry->points[k]), 1.0, 1e-14);
        }
    }
}

TEST(LectureClaims, GradientAtTheTipOfRhoIsAlongMomentum) {  // page 11
    const Lecture lecture("gradient");
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d rho = arrow_of(view, lecture.theme().rho).tip;
        const Arrow& gradient = arrow_of(view, lecture.theme().gradient);
        EXPECT_NEAR(form(view.ellipsoids.front(), rho), 1.0, 1e-14);
        EXPECT_EQ(gradient.tail, rho);
        const Vector3d along = (gradient.tip - gradient.tail).normalized();
        const Matrix3d axes = axes_of(view, lecture.theme());
        const Vector3d expected =
            (axes * lecture.moments().cwiseProduct(axes.transpose() * rho)).normalized();
        EXPECT_LT((along - expected).norm(), 1e-14);
        // ∇F, the plane's normal and L are parallel; so are ρ and ω.
        const Vector3d L = arrow_of(view, lecture.theme().momentum).tip.normalized();
        EXPECT_LT((along - L).norm(), 1e-14);
        EXPECT_NEAR(std::abs(view.planes.front().normal.dot(L)), 1.0, 1e-14);
        EXPECT_NEAR(L.dot(view.planes.front().centre), lecture.distance(), 1e-14);
        EXPECT_LT(arrow_of(view, lecture.theme().omega).tip.normalized().cross(rho).norm(), 1e-14);
    }
}

TEST(LectureClaims, ProjectionOfRhoOnMomentumEndsOnThePlane) {  // page 12
    const Lecture lecture("invariable_plane");
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Plane& plane = view.planes.front();
        const Vector3d rho = arrow_of(view, lecture.theme().rho).tip;
        const Vector3d n = arrow_of(view, lecture.theme().momentum).tip.normalized();
        EXPECT_NEAR(plane.normal.dot(rho - plane.centre), 0.0, 1e-14);
        EXPECT_NEAR(n.dot(rho), lecture.distance(), 1e-14);
        // Along L from the centre to the plane, and perpendicularly to the tip of ρ.
        const auto lines = curves_of(view, lecture.theme().rho);
        ASSERT_EQ(lines.size(), 2u);
        EXPECT_LT(start_of(*lines[0]).norm(), 1e-15);
        EXPECT_LT((end_of(*lines[0]) - lecture.distance() * n).norm(), 1e-14);
        EXPECT_LT((start_of(*lines[1]) - rho).norm(), 1e-14);
        EXPECT_LT((end_of(*lines[1]) - lecture.distance() * n).norm(), 1e-14);
    }
}

TEST(LectureClaims, MatterAtTheContactIsAtRest) {  // page 13
    const Lecture lecture("rolling");
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d contact = view.dots.back().at;
        const Vector3d omega = arrow_of(view, lecture.theme().omega).tip;
        EXPECT_LT((omega - contact).norm(), 1e-15);
        // The axis of rotation is through centre and contact.
        const Curve& axis = *curves_of(view, lecture.theme().omega).front();
        EXPECT_LT(start_of(axis).normalized().cross(contact.normalized()).norm(), 1e-14);
        EXPECT_LT(start_of(axis).dot(contact), 0.0);
        EXPECT_GT(end_of(axis).norm(), contact.norm());
        // "v = 0" is written there.
        EXPECT_TRUE(std::any_of(view.labels.begin(), view.labels.end(), [&](const Label& label) {
            return label.mask->source.text == "\\mathbf{v} = 0" && label.at == contact;
        }));
        // The drawn velocities are ω × r of points of the ellipsoid, with a common factor.
        double factor = 0.0;
        int n = 0;
        for (const Arrow& arrow : view.arrows) {
            if (!(arrow.colour == lecture.theme().mark)) continue;
            EXPECT_NEAR(form(view.ellipsoids.front(), arrow.tail), 1.0, 1e-13);
            const Vector3d expected = omega.normalized().cross(arrow.tail);
            const Vector3d velocity = arrow.tip - arrow.tail;
            if (n++ == 0) factor = velocity.norm() / expected.norm();
            EXPECT_LT((velocity - factor * expected).norm(), 1e-14);
        }
        EXPECT_GT(n, 5);
        // From the attitudes alone: the velocity of the body's point at the contact is zero.
        constexpr double h = 1e-5;
        const Vector3d material =
            lecture.staged.motion.at(t).space_from_body.conjugate() *
            (lecture.staged.stage.context().rolling->picture_from_space.conjugate() * contact);
        const Vector3d moved = lecture.staged.motion.at(t + h).space_from_body * material -
                               lecture.staged.motion.at(t - h).space_from_body * material;
        EXPECT_LT(moved.norm() / (2.0 * h), 1e-8);
    }
}

TEST(LectureClaims, BothCurvesRunThroughTheTipOfRho) {  // page 14
    const Lecture lecture("generic");
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        // ω continues the line of ρ from its tip.
        const Vector3d rho = arrow_of(view, lecture.theme().omega).tail;
        EXPECT_EQ(view.dots.back().at, rho);
        const double px = lecture.staged.stage.panels().front().units_per_px;
        for (const Colour& colour : {lecture.theme().polhode, lecture.theme().herpolhode}) {
            const Curve& curve = *curves_of(view, colour).front();
            double nearest = 1e9;
            const auto& points = curve.geometry->points;
            for (std::size_t k = 1; k < points.size(); ++k) {
                const Vector3d a = curve.placement * points[k - 1];
                const Vector3d b = curve.placement * points[k];
                const double s = std::clamp((rho - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (a + s * (b - a) - rho).norm());
            }
            EXPECT_LT(nearest / px, 0.1);
        }
    }
}

TEST(LectureClaims, SphereHasOneLineAndAStillContact) {  // page 15
    const Lecture lecture("sphere");
    const Vector3d first = lecture.staged.stage.at(0.0).views.at(0).dots.back().at;
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d L = arrow_of(view, lecture.theme().momentum).tip.normalized();
        for (const Arrow& arrow : view.arrows) {
            if (arrow.colour == lecture.theme().omega || arrow.colour == lecture.theme().rho) {
                EXPECT_LT((arrow.tip.normalized() - L).norm(), 1e-14);
            }
        }
        EXPECT_LT((view.dots.back().at - first).norm(), 1e-14);
    }
}

TEST(LectureClaims, PlanesDistanceStandsAmongTheThree) {  // pages 16–17
    struct Case {
        const char* name;
        int near;  // the principal axis with the nearest distance
        double within;
    };
    for (const Case& c : {Case{"stable_largest", 0, 0.06}, Case{"stable_smallest", 2, 0.06},
                          Case{"tennis_racket", 1, 1e-4}, Case{"separatrix", 1, 1e-15}}) {
        const Lecture lecture(c.name);
        const Drawing drawing = lecture.staged.stage.at(lecture.instants().front());
        const View& view = drawing.views.front();
        const Vector3d L = arrow_of(view, lecture.theme().momentum).tip.normalized();
        // The dot on the scale has the height of the plane, the ticks those of the half-axes' ends.
        bool found = false;
        for (const Dot& dot : view.dots) {
            if (std::abs(dot.at.x()) + std::abs(dot.at.y()) < 1.0) continue;
            EXPECT_NEAR(dot.at.dot(L), lecture.distance(), 1e-14) << c.name;
            found = true;
        }
        EXPECT_TRUE(found) << c.name;
        for (int i = 0; i < 3; ++i) {
            const double own = std::sqrt(lecture.moments().minCoeff() / lecture.moments()[i]);
            bool marked = false;
            for (const Curve* line : curves_of(view, lecture.theme().axes[i])) {
                marked = marked || std::abs(end_of(*line).dot(L) - own) < 1e-14;
            }
            EXPECT_TRUE(marked) << c.name << i;
            if (i == c.near) {
                EXPECT_NEAR(lecture.distance() / own, 1.0, c.within) << c.name;
            }
        }
    }
}

TEST(LectureClaims, EnergyGoesFromOnePointThroughTheSeparatrixToAnother) {  // pages 16–17
    const Lecture lecture("energy_sweep");
    double before = 0.0;
    for (const double t : lecture.instants(24)) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d L = arrow_of(view, lecture.theme().momentum).tip.normalized();
        EXPECT_EQ(L, -Vector3d::UnitZ());  // fixed
        const double distance = L.dot(view.planes.front().centre);
        EXPECT_GT(distance, before);
        before = distance;
        // Plane and ellipsoid touch: the contact is on both, with the normal along L.
        const Vector3d contact = arrow_of(view, lecture.theme().omega).tip;
        EXPECT_NEAR(L.dot(contact), distance, 1e-14);
        EXPECT_NEAR(form(view.ellipsoids.front(), contact), 1.0, 1e-14);
        const Matrix3d inverse = view.ellipsoids.front().half_axes.inverse();
        const Vector3d normal = (inverse.transpose() * (inverse * contact)).normalized();
        EXPECT_LT((normal - L).norm(), 1e-13);
        // The body was rotated, not mirrored.
        EXPECT_NEAR(axes_of(view, lecture.theme()).determinant(), 1.0, 1e-13);
        // The polhode has this distance: √(F)/|Iρ| is constant along it.
        for (const Curve* curve : curves_of(view, lecture.theme().polhode)) {
            if (curve->name.part == "leader") continue;  // of the polhode's name
            for (std::size_t k = 0; k < curve->geometry->points.size(); k += 11) {
                const Vector3d p = curve->placement * curve->geometry->points[k];
                EXPECT_NEAR(form(view.ellipsoids.front(), p), 1.0, 1e-13);
                EXPECT_NEAR(1.0 / (inverse.transpose() * (inverse * p)).norm(), distance, 1e-13);
            }
        }
    }
    EXPECT_GT(before, 0.99);
}

TEST(LectureClaims, ConesShareTheGeneratorThatOmegaRunsAlong) {  // pages 18–19
    for (const std::string name : {"symmetric_oblate", "symmetric_prolate"}) {
        const Lecture lecture(name);
        const Vector3d omega0 = lecture.scene.start.omega_rad_s;
        for (const double t : lecture.instants()) {
            const Drawing drawing = lecture.staged.stage.at(t);
            const View& view = drawing.views.front();
            const Vector3d contact = view.dots.back().at;
            ASSERT_EQ(view.cones.size(), 2u);
            for (const Cone& cone : view.cones) {
                // The tip of ρ is on the rim.
                EXPECT_NEAR(contact.dot(cone.axis), cone.length, 1e-14) << name;
                const double radius = (contact - cone.length * cone.axis).norm();
                EXPECT_NEAR(radius, cone.length * std::tan(cone.half_angle_rad), 1e-14) << name;
            }
            EXPECT_LT((arrow_of(view, lecture.theme().omega).tip - contact).norm(), 1e-15);

            // ω in the body: ω₃ is constant, (ω₁, ω₂) moves on the circle of radius A at the rate
            // Ω.
            const Vector3d omega = lecture.staged.motion.at(t).omega_body;
            const double A = std::hypot(omega0[0], omega0[1]);
            const double Omega =
                (lecture.moments()[2] - lecture.moments()[0]) * omega0[2] / lecture.moments()[0];
            const double phase = std::atan2(omega0[1], omega0[0]) + Omega * t;
            EXPECT_NEAR(omega[2], omega0[2], 4e-15);
            EXPECT_NEAR(omega[0], A * std::cos(phase), 2e-14);
            EXPECT_NEAR(omega[1], A * std::sin(phase), 2e-14);
            // The drawn circle about e₃ passes through the tip of ω.
            const View& body = drawing.views.at(1);
            const Vector3d tip = arrow_of(body, lecture.theme().omega).tip;
            const Curve& circle = *curves_of(body, lecture.theme().omega).front();
            const Vector3d centre = circle.placement.translation();
            EXPECT_LT(centre.head<2>().norm(), 1e-14);
            EXPECT_NEAR(circle.placement.linear().col(0).norm(), (tip - centre).norm(), 1e-14);
            EXPECT_NEAR((tip - centre).norm() / centre.norm(), A / std::abs(omega0[2]), 1e-13);
        }
    }
}

// The end of an arc that starts at its geometry's first point, from the drawn angle.
struct DrawnArc {
    Vector3d first, last;
    double angle_rad;
};
DrawnArc drawn_arc(const Curve& arc) {
    const double angle =
        2.0 * std::numbers::pi * arc.last / static_cast<double>(arc.geometry->points.size());
    const Vector3d from = arc.placement.linear().col(0).normalized();
    const Vector3d towards = arc.placement.linear().col(1).normalized();
    return {from, std::cos(angle) * from + std::sin(angle) * towards, angle};
}

// The sense about a direction in which the head of a ring's arrow points.
double drawn_sense(const View& view, const Colour& colour, const Vector3d& direction) {
    for (const Arrow& head : view.arrows) {
        if (!(head.colour == colour) || head.name.element != "precession") continue;
        return std::copysign(1.0, direction.dot(head.tail.cross(head.tip)));
    }
    ADD_FAILURE() << "no ring of this colour";
    return 0.0;
}

// The senses of the drawn rings are those of the motion, and the captions say them: e3 goes round
// L; the body turns about e3, measured from the plane of L and e3; ω goes round e3 in the body.
TEST(LectureClaims, RingsTurnAsTheCaptionsSay) {  // pages 18–19
    for (const auto& [name, is_retrograde] :
         {std::pair{"symmetric_oblate", true}, std::pair{"symmetric_prolate", false}}) {
        const Lecture lecture(name);
        const Motion& motion = lecture.staged.motion;
        const auto e = [&](int axis, double t) {
            return Vector3d(motion.at(t).space_from_body * Vector3d::Unit(axis));
        };
        const RotationState start = motion.at(0.0);
        const Vector3d L =
            start.space_from_body * Vector3d(lecture.moments().cwiseProduct(start.omega_body));
        const auto psi = [&](double t) {
            const Vector3d node = L.cross(e(2, t)), along = e(2, t).cross(node);
            return std::atan2(e(0, t).dot(along) / along.norm(), e(0, t).dot(node) / node.norm());
        };
        for (const double t : lecture.instants()) {
            const double h = 0.01;
            const Drawing drawing = lecture.staged.stage.at(t);
            const View& space = drawing.views.at(0);
            const View& body = drawing.views.at(1);
            const Vector3d drawn_e3 = arrow_of(space, lecture.theme().axes[2]).tip;
            const Vector3d drawn_L = arrow_of(space, lecture.theme().momentum).tip;
            const double about_L = L.dot(e(2, t).cross(e(2, t + h)));
            const double spin = std::remainder(psi(t + h) - psi(t), 2.0 * std::numbers::pi);
            const Vector3d w0 = motion.at(t).omega_body, w1 = motion.at(t + h).omega_body;
            const double in_body = w0.head<2>().x() * w1.y() - w0.y() * w1.x();
            EXPECT_GT(drawn_sense(space, lecture.theme().space_cone, drawn_L) * about_L, 0.0) << t;
            EXPECT_GT(drawn_sense(space, lecture.theme().body_cone, drawn_e3) * spin, 0.0) << t;
            EXPECT_GT(drawn_sense(body, lecture.theme().body_cone, Vector3d::UnitZ()) * in_body,
                      0.0)
                << t;
            EXPECT_EQ(spin * about_L < 0.0, is_retrograde) << name;
        }
        const std::string& caption = lecture.scene.caption;
        EXPECT_NE(caption.find(is_retrograde ? "Retrograde" : "Prograde"), std::string::npos);
        EXPECT_NE(caption.find(is_retrograde ? "the other way" : "the same way"),
                  std::string::npos);
    }
}

// The angles φ, θ, ψ measured from the drawn line of nodes and axes, each about its own axis.
Vector3d drawn_euler_angles(const View& view, const Theme& theme, Vector3d& node) {
    for (const Curve* line : curves_of(view, theme.text)) {
        if (line->dash_px > 0.0) node = (end_of(*line) - start_of(*line)).normalized();
    }
    const Vector3d e1 = arrow_of(view, theme.axes[0]).tip.normalized();
    const Vector3d e3 = arrow_of(view, theme.axes[2]).tip.normalized();
    const Vector3d z = Vector3d::UnitZ();
    const auto about = [](const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
        return std::atan2(axis.dot(from.cross(to)), from.dot(to));
    };
    return {about(z, Vector3d::UnitX(), node), about(node, z, e3), about(e3, node, e1)};
}

TEST(LectureClaims, EulerAnglesAreTheDrawnAngles) {  // pages 20–21
    const Lecture lecture("euler_angles");
    const double A = lecture.moments()[0];
    const double C = lecture.moments()[2];
    int n_arcs = 0;
    for (const double t : lecture.instants()) {
        const Drawing drawing = lecture.staged.stage.at(t);
        const View& view = drawing.views.front();
        const Vector3d e1 = arrow_of(view, lecture.theme().axes[0]).tip.normalized();
        const Vector3d e3 = arrow_of(view, lecture.theme().axes[2]).tip.normalized();
        Vector3d node = Vector3d::Zero();
        const Vector3d angles = drawn_euler_angles(view, lecture.theme(), node);
        // The line of nodes is in the horizontal plane and in that of the body, along z × e₃.
        EXPECT_LT((node - Vector3d::UnitZ().cross(e3).normalized()).norm(), 1e-14);
        // Each arc starts and ends on the two lines of its angle.
        const Vector3d from[] = {Vector3d::UnitZ(), Vector3d::UnitX(), node};
        const Vector3d to[] = {e3, node, e1};
        const double angle[] = {angles[1], angles[0], angles[2]};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto arcs = curves_of(view, lecture.theme().angles[i]);
            if (arcs.empty()) {
                // Too short to be drawn: at the start, where φ and ψ are zero.
                EXPECT_LT(std::abs(angle[i]), 0.3) << t;
                continue;
            }
            ++n_arcs;
            const DrawnArc arc = drawn_arc(*arcs.back());
            EXPECT_LT((arc.first - from[i]).norm(), 1e-14) << i;
            EXPECT_LT((arc.last - to[i]).norm(), 1e-13) << i;
            EXPECT_NEAR(arc.angle_rad, std::abs(angle[i]), 1e-13) << i;
        }

        // T from the rates of the drawn angles equals T from ω.
        const double h = 1e-5;
        const auto drawn_at = [&](double time_s) {
            Vector3d ignored = Vector3d::Zero();
            return drawn_euler_angles(lecture.staged.stage.at(time_s).views.front(),
                                      lecture.theme(), ignored);
        };
        const Vector3d rates = (drawn_at(t + h) - drawn_at(t - h)) / (2.0 * h);
        const double sine = std::sin(angles[1]);
        const double spin = rates[0] * std::cos(angles[1]) + rates[2];
        const double T = 0.5 * A * (rates[1] * rates[1] + rates[0] * rates[0] * sine * sine) +
                         0.5 * C * spin * spin;
        const Vector3d omega = lecture.staged.motion.at(t).omega_body;
        EXPECT_NEAR(T, 0.5 * omega.dot(lecture.moments().cwiseProduct(omega)), 1e-9);
        EXPECT_NEAR(spin, lecture.scene.start.top->omega3_rad_s, 1e-9);
    }
    EXPECT_GT(n_arcs, 10);
}

TEST(LectureClaims, MomentaAndEnergyOfATopStay) {  // page 22
    const Lecture lecture("heavy_top_conserved");
    const StageContext& stage = lecture.staged.stage.context();
    const PlotQuantity& quantity = plot_quantity_of(stage, "conserved");
    const TopStart& start = *lecture.scene.start.top;
    const double A = lecture.moments()[0];
    const double C = lecture.moments()[2];
    const auto& gravity = std::get<Gravity>(lecture.scene.torque);
    // From the Lagrangian, at the start: p_ψ = Cω₃, p_φ = A φ̇ sin²θ + p_ψ cos θ, E = T + Mgl cos
    // θ.
    const double p_psi = C * start.omega3_rad_s;
    const double sine = std::sin(start.theta_rad);
    const double p_phi = A * start.phi_dot_rad_s * sine * sine + p_psi * std::cos(start.theta_rad);
    const double E = 0.5 * A *
                         (start.theta_dot_rad_s * start.theta_dot_rad_s +
                          start.phi_dot_rad_s * start.phi_dot_rad_s * sine * sine) +
                     0.5 * C * start.omega3_rad_s * start.omega3_rad_s +
                     gravity.mgl_N_m * std::cos(start.theta_rad);
    double theta_least = 9.0, theta_most = 0.0;
    for (const double t : lecture.instants(40)) {
        FrameInput instant;
        instant.time_s = t;
        const MotionSample sample = lecture.staged.motion.sample(
            t, {.attitude = true, .herpolhode = false, .euler_angles = true});
        instant.state = sample.state;
        const PlotValues values = quantity.values(stage, instant);
        EXPECT_NEAR(values[0], p_phi, 1e-14);
        EXPECT_NEAR(values[1], p_psi, 1e-14);
        EXPECT_NEAR(values[2], E, 2e-14);
        EXPECT_NEAR(values[3], gravity.mgl_N_m * std::cos(sample.euler.theta_rad), 1e-14);
        theta_least = std::min(theta_least, sample.euler.theta_rad);
        theta_most = std::max(theta_most, sample.euler.theta_rad);
        // The height of the centre of mass is marked on the vertical.
        const Drawing drawing = lecture.staged.stage.at(t);
        const auto lines = curves_of(drawing.views.front(), lecture.theme().potential);
        ASSERT_GE(lines.size(), 2u);  // and a label's leader
        EXPECT_NEAR(end_of(*lines[1]).z() / start_of(*lines[0]).norm(),
                    std::cos(sample.euler.theta_rad), 1e-13);
    }
    EXPECT_GT(theta_most - theta_least, 0.1);
}

}  // namespace
}  // namespace poinsot
