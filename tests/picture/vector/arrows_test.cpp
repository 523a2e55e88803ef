// Visible parts of arrows behind an ellipsoid, point by point of the paper.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "pinhole.h"
#include "vector/picture.h"

namespace poinsot::vector {
namespace {

constexpr double pt_per_px = 0.24;
constexpr double hidden_opacity = 0.3;

View behind_a_sphere() {
    View view;
    view.width_px = 1000;
    view.height_px = 750;
    view.camera.eye = {0.0, -6.0, 1.0};
    view.camera.target = Eigen::Vector3d::Zero();
    Ellipsoid& sphere = view.ellipsoids.emplace_back();
    sphere.half_axes = Eigen::Vector3d(1.0, 0.8, 0.7).asDiagonal();
    sphere.opacity = 1.0;
    sphere.section_px = sphere.ruling_px = 0.0;
    Arrow& arrow = view.arrows.emplace_back();
    arrow.colour = {0.1, 0.2, 0.7};
    arrow.shaft_px = 40.0;
    arrow.head_px = 90.0;
    arrow.head_length_px = 100.0;
    arrow.hidden_opacity = hidden_opacity;
    return view;
}

// Whether the line of sight through a point of the paper meets the ellipsoid.
bool meets(const View& view, const Eigen::Vector2d& at_pt) {
    return testing::Pinhole(view).meets(view.ellipsoids.front(), at_pt / pt_per_px);
}

// Winding number of a path around a point.
int turns_about(const Path& path, const Eigen::Vector2d& point) {
    double angle = 0.0;
    Eigen::Vector2d start = Eigen::Vector2d::Zero(), last = start;
    const auto go = [&](const Eigen::Vector2d& to) {
        const Eigen::Vector2d a = last - point, b = to - point;
        angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        last = to;
    };
    for (const Step& step : path.steps) {
        switch (step.kind) {
            case Step::Kind::move:
                go(start);
                start = last = step.to;
                break;
            case Step::Kind::line:
                go(step.to);
                break;
            case Step::Kind::cubic: {
                const Eigen::Vector2d from = last;
                for (int k = 1; k <= 64; ++k) {
                    const double t = k / 64.0, u = 1.0 - t;
                    go(u * u * u * from + 3.0 * u * u * t * step.control_1 +
                       3.0 * u * t * t * step.control_2 + t * t * t * step.to);
                }
                break;
            }
            case Step::Kind::close:
                go(start);
                break;
        }
    }
    go(start);
    return static_cast<int>(std::lround(angle / (2.0 * std::numbers::pi)));
}

bool holds(const Path& path, bool even_odd, const Eigen::Vector2d& point) {
    const int turns = turns_about(path, point);
    return even_odd ? turns % 2 != 0 : turns != 0;
}

// The opacities of all fills of this colour that cover a point.
std::vector<double> opacities_at(const SheetOfPaper& paper, const Colour& colour,
                                 const Eigen::Vector2d& point) {
    std::vector<double> found;
    std::vector<bool> open;
    for (const Item& item : paper.items) {
        if (const auto* clip = std::get_if<ClipBegin>(&item))
            open.push_back(holds(clip->path, clip->even_odd, point));
        else if (std::holds_alternative<ClipEnd>(item))
            open.pop_back();
        const auto* fill = std::get_if<Fill>(&item);
        const auto* ink = fill ? std::get_if<PaperInk>(&fill->paint) : nullptr;
        if (ink == nullptr || !(ink->colour == colour)) continue;
        if (std::find(open.begin(), open.end(), false) != open.end()) continue;
        if (holds(fill->path, fill->even_odd, point)) found.push_back(ink->alpha);
    }
    return found;
}

struct Found {
    int n_hidden = 0, n_seen = 0, n_wrong = 0;
};

// Whether the arrows of random views are as opaque as `hides` says at random points of the paper:
// the axis crosses the body's outline at all angles, with the tail behind the body; the head is
// outside, or cut by the outline itself. Without shading, an arrow has one ink.
template <typename Hides>
Found found_in(const View& with_body, int n_views, std::mt19937_64::result_type seed,
               double margin_pt, Hides hides) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    Found found;
    for (int k = 0; k < n_views; ++k) {
        View view = with_body;
        Arrow& arrow = view.arrows.front();
        const double angle = 2.0 * std::numbers::pi * part(random);
        arrow.tail = {0.8 * part(random) - 0.4, 1.2, 0.6 * part(random) - 0.3};
        arrow.tip = arrow.tail +
                    (1.2 + part(random)) * Eigen::Vector3d(std::cos(angle), 0.1, std::sin(angle));
        Drawing drawing;
        drawing.width_px = view.width_px;
        drawing.height_px = view.height_px;
        drawing.views.push_back(view);
        const PaperChoices choices{.pt_per_px = pt_per_px, .shading = Shading::none};
        const SheetOfPaper paper = paper_of(drawing, choices);
        drawing.views[0].ellipsoids.clear();
        drawing.views[0].meshes.clear();
        const SheetOfPaper alone = paper_of(drawing, choices);
        for (int n = 0; n < 1000; ++n) {
            // Drawn one after the other: the order of arguments is the compiler's.
            const double right = part(random), down = part(random);
            const Eigen::Vector2d at(view.width_px * pt_per_px * right,
                                     view.height_px * pt_per_px * down);
            // Shaft and head may overlap there.
            if (opacities_at(alone, arrow.colour, at).empty()) continue;
            bool near_outline = false;
            for (const Eigen::Vector2d& off :
                 {Eigen::Vector2d(margin_pt, 0.0), Eigen::Vector2d(0.0, margin_pt)})
                near_outline |= hides(view, at + off) != hides(view, at - off);
            if (near_outline) continue;
            const bool hidden = hides(view, at);
            (hidden ? found.n_hidden : found.n_seen) += 1;
            const std::vector<double> opacities = opacities_at(paper, arrow.colour, at);
            EXPECT_FALSE(opacities.empty()) << k << " at " << at.transpose();
            for (const double opacity : opacities)
                found.n_wrong += std::abs(opacity - (hidden ? hidden_opacity : 1.0)) > 0.01 ? 1 : 0;
        }
    }
    return found;
}

TEST(Arrows, AreCutAlongTheOutline) {
    const Found found = found_in(behind_a_sphere(), 60, 7, 0.02, meets);
    EXPECT_GT(found.n_hidden, 200);
    EXPECT_GT(found.n_seen, 200);
    EXPECT_EQ(found.n_wrong, 0);
}

// A pyramid about the origin, in front of the arrows of the test.
MeshGeometry pyramid() {
    MeshGeometry geometry;
    const Eigen::Vector3f top(0.1f, 0.0f, 0.9f),
        corners[] = {
            {-0.9f, -0.5f, -0.6f}, {0.8f, -0.6f, -0.5f}, {0.9f, 0.5f, -0.7f}, {-0.7f, 0.6f, -0.6f}};
    const auto add = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                         const Eigen::Vector3f& c) {
        geometry.positions.insert(geometry.positions.end(), {a, b, c});
        const Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
        geometry.normals.insert(geometry.normals.end(), 3, normal);
    };
    for (int k = 0; k < 4; ++k) add(corners[k], corners[(k + 1) % 4], top);
    add(corners[2], corners[1], corners[0]);
    add(corners[3], corners[2], corners[0]);
    return geometry;
}

// Whether a point of the paper is inside the projection of a triangle, by a camera of its own.
bool within_mesh(const View& view, const MeshGeometry& geometry, const Eigen::Vector2d& at_pt) {
    const testing::Pinhole camera(view);
    const auto side = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& p) {
        return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
    };
    for (std::size_t k = 0; k < geometry.positions.size(); k += 3) {
        Eigen::Vector2d p[3];
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = pt_per_px * camera.place(geometry.positions[k + i].cast<double>());
        const double a = side(p[0], p[1], at_pt), b = side(p[1], p[2], at_pt),
                     c = side(p[2], p[0], at_pt);
        if ((a > 0.0) == (b > 0.0) && (b > 0.0) == (c > 0.0)) return true;
    }
    return false;
}

// The cut follows the outline over the full width of shaft and head, not the point at which the
// axis is hidden. Between the lines on which the visibility is computed it is straight: at a corner
// of the outline it differs by less than their distance.
TEST(Arrows, AreCutAlongTheOutlineOfABody) {
    const MeshGeometry geometry = pyramid();
    View view = behind_a_sphere();
    view.ellipsoids.clear();
    view.meshes.emplace_back().geometry = &geometry;
    const auto within = [&](const View& seen, const Eigen::Vector2d& at) {
        return within_mesh(seen, geometry, at);
    };
    const Found found = found_in(view, 20, 11, 0.15, within);
    EXPECT_GT(found.n_hidden, 50);
    EXPECT_GT(found.n_seen, 50);
    // At corners of the outline.
    EXPECT_LE(found.n_wrong, (found.n_hidden + found.n_seen) / 200);
}

}  // namespace
}  // namespace poinsot::vector
