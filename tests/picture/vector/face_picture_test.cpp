// Pictures on faces in vector output, at points projected by a pinhole camera.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "painted_face.h"
#include "pinhole.h"
#include "vector/picture.h"

namespace poinsot::vector::face_picture_tests {
namespace {

using testing::quarters;

constexpr double pt_per_px = 0.24;

template <class Kind>
std::vector<Kind> all_of(const SheetOfPaper& paper) {
    std::vector<Kind> found;
    for (const Item& item : paper.items)
        if (const auto* one = std::get_if<Kind>(&item)) found.push_back(*one);
    return found;
}

// R, G, B and alpha at a point of the paper; transparent outside the picture.
std::array<int, 4> pixel_at(const Picture& picture, const Eigen::Vector2d& at_pt) {
    const Eigen::Array2d part = (at_pt - picture.corner_pt).array() / picture.size_pt.array();
    if ((part < 0.0).any() || (part >= 1.0).any()) return {};
    const auto column = static_cast<std::size_t>(part.x() * picture.raster.width);
    const auto row = static_cast<std::size_t>(part.y() * picture.raster.height);
    const std::size_t at = 4 * (row * static_cast<std::size_t>(picture.raster.width) + column);
    std::array<int, 4> pixel{};
    for (std::size_t k = 0; k < 4; ++k) pixel[k] = picture.raster.rgba[at + k];
    return pixel;
}

// The colour of a fill at a point of the paper.
Colour colour_of(const Fill& fill, const Eigen::Vector2d& at) {
    if (const auto* ink = std::get_if<PaperInk>(&fill.paint)) return ink->colour;
    const auto& fade = std::get<LinearFade>(fill.paint);
    const Eigen::Vector2d run = fade.to - fade.from;
    const double t = run.dot(at - fade.from) / run.squaredNorm();
    const Colour &a = fade.stops.front().ink.colour, &b = fade.stops.back().ink.colour;
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

// A picture's quarters appear at the face's quarters, each with the colour of a plain face of its
// colour; outside the face the picture is empty.
TEST(FacePicture, HasPositionAndShadingOfItsFace) {
    Eigen::Affine3d turned = Eigen::Affine3d::Identity();
    turned.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.2, 1.0, 0.3).normalized()));
    turned.translate(Eigen::Vector3d(0.1, -0.1, 0.2));
    const auto on_page = [&](const Drawing& drawing, double right, double down) {
        const Eigen::Vector3d point =
            turned * Eigen::Vector3d(2.0 * right - 1.0, 0.6 - 1.2 * down, 0.0);
        return Eigen::Vector2d(pt_per_px * testing::Pinhole(drawing.views[0]).place(point));
    };
    std::uint64_t id = 9800;
    for (const int side_px : {8, 64, 2048}) {
        MeshGeometry face = testing::page(++id);
        face.picture = testing::of_quarters(side_px);
        const Drawing drawing = testing::drawing_of(face, turned, {90, 90, 90});
        const auto pictures = all_of<Picture>(paper_of(drawing, {.pt_per_px = pt_per_px}));
        ASSERT_EQ(pictures.size(), 1u);
        for (std::size_t k = 0; k < quarters.size(); ++k) {
            MeshGeometry plain = testing::page(++id);
            plain.places.clear();
            const auto fills = all_of<Fill>(paper_of(
                testing::drawing_of(plain, turned, quarters[k]), {.pt_per_px = pt_per_px}));
            ASSERT_FALSE(fills.empty());
            for (const double u : {0.05, 0.25, 0.45})
                for (const double v : {0.05, 0.25, 0.45}) {
                    const Eigen::Vector2d at =
                        on_page(drawing, u + 0.5 * static_cast<double>(k % 2),
                                v + 0.5 * static_cast<double>(k / 2));
                    const auto pixel = pixel_at(pictures[0], at);
                    const Colour colour = colour_of(fills.back(), at);
                    const double levels[] = {colour.r, colour.g, colour.b, 1.0};
                    for (std::size_t c = 0; c < 4; ++c)
                        EXPECT_NEAR(pixel[c], 255.0 * levels[c], 4.0)
                            << side_px << " quarter " << k << " component " << c;
                }
        }
        for (const double out : {-0.02, 1.02}) {
            EXPECT_EQ(pixel_at(pictures[0], on_page(drawing, out, 0.5))[3], 0);
            EXPECT_EQ(pixel_at(pictures[0], on_page(drawing, 0.5, out))[3], 0);
        }
    }
}

// An object in front of a face covers its picture, in either order.
TEST(FacePicture, IsHiddenByObjectsInFrontOfIt) {
    MeshGeometry face = testing::page(9890), before = testing::page(9891);
    face.picture = testing::of_quarters(64);
    before.places.clear();
    Drawing drawing =
        testing::drawing_of(before, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5)), {9, 9, 9});
    Mesh behind = drawing.views[0].meshes[0];
    behind.geometry = &face;
    // First the front face covers the picture entirely; then a part extends beyond it to the right.
    for (const double right : {0.0, 1.1}) {
        behind.placement =
            Eigen::Affine3d(Eigen::Translation3d(right, 0, 0.3) * Eigen::Scaling(0.4));
        drawing.views[0].meshes.resize(1);
        drawing.views[0].meshes.push_back(behind);
        for (int turn = 0; turn < 2; ++turn) {
            const auto alpha_at = [&](double x) {
                const Eigen::Vector2d at =
                    pt_per_px * testing::Pinhole(drawing.views[0])
                                    .place(behind.placement * Eigen::Vector3d(x, 0.1, 0.0));
                int alpha = 0;
                for (const Picture& picture :
                     all_of<Picture>(paper_of(drawing, {.pt_per_px = pt_per_px})))
                    alpha = std::max(alpha, pixel_at(picture, at)[3]);
                return alpha;
            };
            EXPECT_EQ(alpha_at(-0.9), 0) << right << " " << turn;
            EXPECT_EQ(alpha_at(0.9), right > 0.0 ? 255 : 0) << right << " " << turn;
            std::swap(drawing.views[0].meshes[0], drawing.views[0].meshes[1]);
        }
    }
}

}  // namespace
}  // namespace poinsot::vector::face_picture_tests
