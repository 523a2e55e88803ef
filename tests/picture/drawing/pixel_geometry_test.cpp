// Position errors of the drawing in pixels of a 1080p frame, over whole films.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "places.h"
#include "scene/files/load_scene.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot {
namespace {

constexpr double largest_px = 0.1;

// A scene of the repository on its stage.
struct FilmScene {
    Scene scene;
    double last_time_s;

    explicit FilmScene(const std::string& name)
        : scene(load_scene(source_folder() / "scenes" / (name + ".toml"),
                           std::vector<Override>{{"crossings", "through"}})),  // whole curves
          last_time_s(scene.film.start_s + scene.film.duration_s.value_or(default_film_s)) {}
    double time_of(int k, int n) const {
        return scene.film.start_s + (last_time_s - scene.film.start_s) * k / n;
    }
};

// The curves of the space panel in the order of its elements: polhode, the edge of the herpolhode,
// herpolhode.
const Curve& polhode_of(const View& view) { return view.curves.at(0); }
const Curve& herpolhode_of(const View& view) { return view.curves.at(2); }

// In single precision, as the renderer receives them.
Eigen::Vector3d point_of(const Curve& curve, std::size_t k) {
    const auto& points = curve.geometry->points;
    return curve.placement * points[k % points.size()].cast<float>().cast<double>();
}

double px_per_unit(const View& view, const Eigen::Vector3d& point) {
    return 1.0 / units_per_pixel(view, project(view, point).depth);
}

// Distance of a point from the ellipsoid, to first order: (|u| − 1) divided by the gradient of |u|.
double distance_from(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point) {
    const Eigen::Matrix3d to_u = ellipsoid.half_axes.inverse();
    const Eigen::Vector3d u = to_u * (point - ellipsoid.centre);
    return std::abs(u.norm() - 1.0) / (to_u.transpose() * u).norm() * u.norm();
}

class LectureFilm : public testing::TestWithParam<const char*> {};

TEST_P(LectureFilm, PolhodeLiesOnTheDrawnSurface) {
    const FilmScene film(GetParam());
    const StagedScene staged(film.scene, film.last_time_s);
    double worst = 0.0;
    constexpr int n_instants = 12;
    for (int i = 0; i <= n_instants; ++i) {
        const Drawing drawing = staged.stage.at(film.time_of(i, n_instants));
        const View& view = drawing.views.at(0);
        const Curve& polhode = polhode_of(view);
        const std::size_t n = polhode.geometry->points.size();
        // Points and, where a chord is farthest from its arc, middles.
        for (std::size_t k = 0; k + (polhode.geometry->closed ? 0 : 1) < n; ++k) {
            const Eigen::Vector3d corner = point_of(polhode, k);
            const Eigen::Vector3d middle = 0.5 * (corner + point_of(polhode, k + 1));
            for (const Eigen::Vector3d& point : {corner, middle}) {
                worst = std::max(
                    worst, distance_from(view.ellipsoids.at(0), point) * px_per_unit(view, point));
            }
        }
    }
    RecordProperty("worst_px", std::to_string(worst));
    EXPECT_LT(worst, largest_px);  // measured 0.031; chords are sampled to 0.05
}

TEST_P(LectureFilm, ContactPointLiesOnPlaneSurfaceAndBothCurves) {
    const FilmScene film(GetParam());
    const StagedScene staged(film.scene, film.last_time_s);
    double from_plane = 0.0;
    double from_surface = 0.0;
    double from_herpolhode = 0.0;
    double from_polhode = 0.0;
    constexpr int n_instants = 60;
    for (int i = 1; i <= n_instants; ++i) {
        const Drawing drawing = staged.stage.at(film.time_of(i, n_instants));
        const View& view = drawing.views.at(0);
        const auto dot = std::find_if(view.dots.begin(), view.dots.end(), [](const Dot& each) {
            return each.name.element == "contact";
        });
        ASSERT_NE(dot, view.dots.end());
        const Eigen::Vector3d contact = dot->at;
        const double scale = px_per_unit(view, contact);
        const ConstructionPicture& rolling = *staged.stage.context().rolling;
        std::vector<Eigen::Vector3d> feet{rolling.foot()};
        for (const Plane& plane : view.planes) feet.push_back(plane.centre);  // if it is shown
        for (const Eigen::Vector3d& foot : feet)
            from_plane = std::max(from_plane, scale * std::abs(rolling.normal.dot(contact - foot)));
        from_surface =
            std::max(from_surface, scale * distance_from(view.ellipsoids.at(0), contact));

        // The herpolhode ends at the contact.
        const Curve& trail = herpolhode_of(view);
        const double last =
            std::min(trail.last, static_cast<double>(trail.geometry->points.size() - 1));
        const auto k = static_cast<std::size_t>(last);
        const Eigen::Vector3d end =
            point_of(trail, k) +
            (last - static_cast<double>(k)) *
                (point_of(trail, std::min(k + 1, trail.geometry->points.size() - 1)) -
                 point_of(trail, k));
        from_herpolhode = std::max(from_herpolhode, scale * (end - contact).norm());

        // The polhode passes through the contact.
        const Curve& polhode = polhode_of(view);
        const std::size_t n = polhode.geometry->points.size();
        double nearest = 1e300;
        for (std::size_t j = 0; j + (polhode.geometry->closed ? 0 : 1) < n; ++j) {
            const Eigen::Vector3d a = point_of(polhode, j);
            const Eigen::Vector3d run = point_of(polhode, j + 1) - a;
            const double t =
                std::clamp((contact - a).dot(run) / std::max(run.squaredNorm(), 1e-300), 0.0, 1.0);
            nearest = std::min(nearest, (a + t * run - contact).norm());
        }
        from_polhode = std::max(from_polhode, scale * nearest);
    }
    EXPECT_LT(from_plane, largest_px);       // both are computed from one ω
    EXPECT_LT(from_surface, largest_px);     // both are computed from one ω
    EXPECT_LT(from_herpolhode, largest_px);  // curves are sampled to 0.05
    EXPECT_LT(from_polhode, largest_px);     // curves are sampled to 0.05
}

Eigen::AlignedBox2d box_of(const Label& label) {
    return {label.top_left_px,
            label.top_left_px + Eigen::Vector2d(label.mask->width, label.mask->height)};
}

TEST_P(LectureFilm, LabelsFollowTheirArrowsAndDoNotOverlap) {
    const FilmScene film(GetParam());
    const StagedScene staged(film.scene, film.last_time_s);
    const double fps = 1.0 * film.scene.film.fps_numerator / film.scene.film.fps_denominator;
    const double step_s = film.scene.film.speed / fps;
    const int n_frames =
        std::min(600, static_cast<int>((film.last_time_s - film.scene.film.start_s) / step_s));
    // Positions of labels relative to their arrows' tips, by the names of the arrows.
    using Name = std::pair<std::string_view, int>;
    std::map<Name, Eigen::Vector2d> before;
    double largest_step_px = 0.0;
    double largest_share = 0.0;
    int n_labels = 0;
    for (int k = 0; k < n_frames; ++k) {
        const Drawing drawing = staged.stage.at(film.scene.film.start_s + k * step_s);
        const View& view = drawing.views.at(0);
        std::map<Name, Eigen::Vector2d> now;
        std::vector<Eigen::AlignedBox2d> boxes;
        for (const Label& label : view.labels) {
            if (label.opacity < 0.5 || label.mask->letters.empty()) continue;
            const Eigen::AlignedBox2d box = box_of(label);
            for (const Eigen::AlignedBox2d& other : boxes) {
                const Eigen::AlignedBox2d both = box.intersection(other);
                if (both.isEmpty()) continue;
                largest_share =
                    std::max(largest_share, both.volume() / std::min(box.volume(), other.volume()));
            }
            boxes.push_back(box);
            const Name name{label.name.element, label.name.number};
            for (const Arrow& arrow : view.arrows) {
                if (Name{arrow.name.element, arrow.name.number} != name) continue;
                ++n_labels;
                now[name] = box.center() - project(view, arrow.tip).px;
                if (const auto was = before.find(name); was != before.end())
                    largest_step_px = std::max(largest_step_px, (now[name] - was->second).norm());
            }
        }
        before = now;
    }
    EXPECT_GT(n_labels, 3 * n_frames);
    RecordProperty("largest_step_px", std::to_string(largest_step_px));
    RecordProperty("largest_share", std::to_string(largest_share));
    // Measured: 24 px in the racket's turn and 23 px on the separatrix, shown at twice its speed,
    // where the arrow's own tip moves by 90 px per frame; at most 13 px elsewhere. If a label
    // changed sides abruptly: 34 px.
    // stable_largest: 45 px, where a name of 25 px moves out of another's way.
    EXPECT_LT(largest_step_px, 48.0);
    EXPECT_LT(largest_share, 0.1);  // measured 0.031
}

INSTANTIATE_TEST_SUITE_P(Scenes, LectureFilm,
                         testing::Values("generic", "tennis_racket", "separatrix",
                                         "symmetric_oblate", "symmetric_prolate", "stable_largest"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace
}  // namespace poinsot
