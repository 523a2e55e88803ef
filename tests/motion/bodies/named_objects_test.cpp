// The built-in bodies have closed parts, principal axes as documented, and moments that agree with
// closed forms and with published values of the real objects.
#include "bodies/named_objects.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "bodies/solid_check.h"
#include "error/error.h"

namespace poinsot {
namespace {

using std::numbers::pi;

BodyProperties properties_of_object(std::string_view name) {
    return properties_of(object_named(name).make());
}

Eigen::Vector3d moments_of(std::string_view name) {
    return properties_of_object(name).inertia_kg_m2.diagonal();
}

class NamedObjects : public testing::TestWithParam<NamedObject> {};

TEST_P(NamedObjects, HaveClosedParts) {
    std::size_t n_triangles = 0;
    std::set<std::string_view> names;
    for (const ObjectPart& part : GetParam().make()) {
        const EdgeFaults faults = edge_faults(part.mesh);
        EXPECT_TRUE(faults.none())
            << part.name << ": " << faults.n_open << " open, " << faults.n_crowded << " crowded, "
            << faults.n_reversed << " reversed";
        EXPECT_GT(mass_properties(part.mesh).volume_m3, 0.0) << part.name;
        EXPECT_GT(part.density_kg_m3, 0.0) << part.name;
        EXPECT_TRUE(names.insert(part.name).second) << part.name;
        for (const double c : part.srgb) EXPECT_TRUE(c >= 0.0 && c <= 1.0) << part.name;
        if (part.use != PartUse::mass_only) n_triangles += part.mesh.triangles.size();
    }
    EXPECT_LE(n_triangles, 20000u);
}

TEST_P(NamedObjects, HavePrincipalAxesAlongXYZ) {
    const auto parts = GetParam().make();
    const BodyProperties body = properties_of(parts);
    double size = 0.0;
    for (const ObjectPart& part : parts) {
        for (const Eigen::Vector3d& v : part.mesh.vertices) size = std::max(size, v.norm());
    }
    EXPECT_LT(body.centre_of_mass_m.norm(), 1e-15 * size);  // measured 2e-17
    EXPECT_TRUE(body.inertia_kg_m2.isDiagonal(0.0)) << body.inertia_kg_m2;
    const Eigen::Vector3d I = body.inertia_kg_m2.diagonal();
    EXPECT_GT(I.minCoeff(), 0.0);
    EXPECT_LE(I.maxCoeff(), (I.sum() - I.maxCoeff()) * (1.0 + 1e-14));
    if (I.x() != I.y()) {
        EXPECT_GT(I.x(), I.y());
        EXPECT_GT(I.y(), I.z());
    }
}

TEST_P(NamedObjects, AreShadedWithUnitNormals) {
    for (const ObjectPart& part : GetParam().make()) {
        const ShadedCorners corners = shaded_corners(part.mesh);
        ASSERT_EQ(corners.normals.size(), 3 * part.mesh.triangles.size());
        ASSERT_EQ(corners.positions.size(), corners.normals.size());
        for (const Eigen::Vector3f& n : corners.normals) ASSERT_NEAR(n.norm(), 1.0f, 1e-6f);
    }
}

INSTANTIATE_TEST_SUITE_P(Table, NamedObjects,
                         testing::ValuesIn(named_objects().begin(), named_objects().end()),
                         [](const testing::TestParamInfo<NamedObject>& row) {
                             std::string name(row.param.name);
                             std::erase(name, '-');
                             return name;
                         });

TEST(NamedObjectMoments, OfSymmetricBodiesAreEqualInPairs) {
    for (const char* name :
         {"football", "plate", "disc", "coin", "cylinder", "cone", "torus", "earth"}) {
        const Eigen::Vector3d I = moments_of(name);
        EXPECT_EQ(I.x(), I.y()) << name;
        EXPECT_NE(I.x(), I.z()) << name;
    }
    const Eigen::Vector3d sphere = moments_of("sphere");
    EXPECT_EQ(sphere.x(), sphere.y());
    EXPECT_EQ(sphere.y(), sphere.z());
}

// What is only seen has no mass, and what has mass but is not seen is drawn otherwise.
TEST(NamedObjectParts, OfLookAloneChangeNoMoment) {
    int n_looks = 0;
    for (const NamedObject& object : named_objects()) {
        auto parts = object.make();
        const BodyProperties whole = properties_of(parts);
        n_looks +=
            static_cast<int>(std::ranges::count(parts, PartUse::look_only, &ObjectPart::use));
        std::erase_if(parts, [](const ObjectPart& part) { return part.use == PartUse::look_only; });
        EXPECT_EQ(properties_of(parts).inertia_kg_m2, whole.inertia_kg_m2) << object.name;
        EXPECT_EQ(properties_of(parts).mass_kg, whole.mass_kg) << object.name;
    }
    // Laces, line and foot of the plate, strings, bump and lenses of the phone, two lobes of
    // Toutatis.
    EXPECT_EQ(n_looks, 8);
}

// The laces lie on the football's surface, half sunk into it, on one side of it.
TEST(NamedObjectParts, OfTheFootballHaveLacesOnOneSeam) {
    const auto parts = object_named("football").make();
    const auto laces = std::ranges::find(parts, std::string_view("laces"), &ObjectPart::name);
    ASSERT_NE(laces, parts.end());
    constexpr double girth_radius_m = 21.125 * 0.0254 / (2.0 * pi);
    double most = 0.0;
    for (const Eigen::Vector3d& v : laces->mesh.vertices) {
        EXPECT_LT(v.x(), -0.06);
        EXPECT_LT(std::abs(v.y()), 0.0151);
        EXPECT_LT(std::abs(v.z()), 0.07);
        most = std::max(most, v.head<2>().norm());
    }
    EXPECT_GT(most, girth_radius_m + 0.002);
    EXPECT_LT(most, girth_radius_m + 0.005);
}

// The moments of a uniform slab of these edges, but for the air before the rim; the bump is seen at
// the back, the glass in front, and none of it has mass.
TEST(NamedObjectParts, OfThePhoneAreGlassAndABump) {
    const auto parts = object_named("phone").make();
    const BodyProperties body = properties_of(parts);
    const double x = 7.80e-3, y = 71.6e-3, z = 147.6e-3;
    EXPECT_NEAR(body.mass_kg, 0.171, 1e-15);
    const Eigen::Vector3d slab =
        0.171 / 12.0 * Eigen::Vector3d(y * y + z * z, z * z + x * x, x * x + y * y);
    const Eigen::Vector3d I = body.inertia_kg_m2.diagonal();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(I[i], slab[i], 0.015 * slab[i]) << i;
    for (const ObjectPart& part : parts) {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& v : part.mesh.vertices) box.extend(v);
        if (part.name == "glass") {
            // The air before the rim, of 2 mm around a glass of 0.8 mm, moves the centre of mass.
            const double air = 0.8e-3 * (y * z - (y - 4e-3) * (z - 4e-3));
            EXPECT_NEAR(box.max().x(), 0.5 * x + air * 3.5e-3 / (x * y * z - air), 1e-15);
        }
        if (part.use != PartUse::look_only) continue;
        EXPECT_LT(box.min().x(), -0.5 * x - 1e-3) << part.name;
        EXPECT_GT(box.min().z(), 0.0) << "above the middle";
    }
}

// Closed forms; the error of the facets is below 2e-6.
TEST(NamedObjectMoments, OfPlainSolidsAgreeWithTheTextbook) {
    const auto expect = [](std::string_view name, double mass, const Eigen::Vector3d& per_mass) {
        const BodyProperties body = properties_of_object(name);
        EXPECT_NEAR(body.mass_kg, mass, 1e-13 * mass) << name;
        const Eigen::Vector3d error = body.inertia_kg_m2.diagonal() - mass * per_mass;
        EXPECT_LT(error.norm(), 2e-6 * mass * per_mass.norm()) << name;
    };
    const auto about_z = [](double across, double along) {
        return Eigen::Vector3d(across, across, along);
    };
    const Eigen::Vector3d brick = Eigen::Vector3d(0.065, 0.1025, 0.215).cwiseAbs2();
    expect("box", 1900.0 * 0.065 * 0.1025 * 0.215,
           Eigen::Vector3d(brick.y() + brick.z(), brick.z() + brick.x(), brick.x() + brick.y()) /
               12.0);
    const double d2 = 0.03917 * 0.03917;
    expect("cylinder", 1.0, about_z(7.0 / 48.0 * d2, d2 / 8.0));
    expect("cone", 705.0 * pi * 0.0025 * 0.15 / 3.0,
           about_z(3.0 / 80.0 * (4.0 * 0.0025 + 0.0225), 0.3 * 0.0025));
    expect("sphere", 0.163, Eigen::Vector3d::Constant(0.1 * 0.05715 * 0.05715));
    expect("torus", 2.5, about_z((4.0 * 0.09 + 5.0 * 0.01) / 8.0, 0.09 + 0.75 * 0.01));
    const Eigen::Vector3d a2 = Eigen::Vector3d(513e3, 852e3, 1161e3).cwiseAbs2();
    expect("ellipsoid", 1885.0 * 4.0 / 3.0 * pi * 513e3 * 852e3 * 1161e3,
           Eigen::Vector3d(a2.y() + a2.z(), a2.z() + a2.x(), a2.x() + a2.y()) / 5.0);
    const double r2 = 0.0075 * 0.0075 + 0.06 * 0.06;
    expect("disc", 1200.0 * pi * (0.06 * 0.06 - 0.0075 * 0.0075) * 0.0012,
           about_z((3.0 * r2 + 0.0012 * 0.0012) / 12.0, r2 / 2.0));
    const double c2 = 0.012875 * 0.012875;
    expect("coin", 0.0085, about_z((3.0 * c2 + 0.0022 * 0.0022) / 12.0, c2 / 2.0));
}

// Boxes with the parallel-axis theorem, computed from the measurements alone.
TEST(NamedObjectMoments, OfTheBookAgreeWithSumOfBoxes) {
    const auto parts = object_named("book").make();
    const Eigen::Vector3d pages(0.022, 0.156, 0.234);
    const Eigen::Vector3d cover(0.0025, 0.159, 0.240);
    const Eigen::Vector3d spine(0.027, 0.0025, 0.240);
    const double m[] = {0.080 / 0.11e-3 * pages.prod(), 650.0 * cover.prod(), 650.0 * spine.prod()};
    const double y[] = {0.078, 0.0795, -0.00125};
    const double mass = m[0] + 2.0 * m[1] + m[2];
    const double centre = (m[0] * y[0] + 2.0 * m[1] * y[1] + m[2] * y[2]) / mass;
    // About z: (x² + y²)/12 plus the squared distances in x and y.
    const auto about_z = [&](const Eigen::Vector3d& edges, double mass_kg, double x, double at_y) {
        return mass_kg * ((edges.x() * edges.x() + edges.y() * edges.y()) / 12.0 + x * x +
                          (at_y - centre) * (at_y - centre));
    };
    const double expected = about_z(pages, m[0], 0.0, y[0]) +
                            2.0 * about_z(cover, m[1], 0.01225, y[1]) +
                            about_z(spine, m[2], 0.0, y[2]);
    const BodyProperties body = properties_of(parts);
    EXPECT_NEAR(body.mass_kg, mass, 1e-14);
    EXPECT_NEAR(body.inertia_kg_m2(2, 2), expected, 1e-14 * expected);  // measured 7e-16
}

// Bar and stem as cylinders. The bar hollows the end of the stem, which removes π r² (R − mean of
// √(R² − x²)) from a stem that begins at the bar's crest.
TEST(NamedObjectMoments, OfTheTHandleAreMiddleAboutTheStem) {
    const BodyProperties body = properties_of_object("t-handle");
    const double R = 0.008;
    const double r = 0.006;
    double hollow = 0.0;  // ∫ (R − √(R² − x²)) over the stem's disc, by the midpoint rule
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double x = r * (2.0 * (i + 0.5) / n - 1.0);
        hollow += (R - std::sqrt(R * R - x * x)) * 2.0 * std::sqrt(r * r - x * x) * 2.0 * r / n;
    }
    const double mass = 2700.0 * (pi * R * R * 0.1 + pi * r * r * 0.06 + hollow);
    EXPECT_NEAR(body.mass_kg, mass, 2e-5 * mass);  // measured 9e-6: the facets of the stem's end
    const double bar = 2700.0 * pi * R * R * 0.1;
    const double stem = mass - bar;
    const double about_stem = bar * (3.0 * R * R + 0.01) / 12.0 + stem * r * r / 2.0;
    EXPECT_NEAR(body.inertia_kg_m2(1, 1), about_stem, 1e-3 * about_stem);
    EXPECT_NEAR(body.inertia_kg_m2(0, 0) / body.inertia_kg_m2(1, 1), 1.541, 0.005);
    EXPECT_NEAR(body.inertia_kg_m2(2, 2) / body.inertia_kg_m2(1, 1), 0.585, 0.005);
}

// Brody, Phys. Teach. 23 (1985) 213 and later measurements: 0.30–0.36 kg, balance 0.31–0.34 m from
// the butt, 0.030–0.035 kg m² about an axis 0.1 m from the butt, 0.0012–0.0017 about the long axis.
TEST(NamedObjectMoments, OfTheRacketAreInTheRangeOfRealRackets) {
    const auto parts = object_named("racket").make();
    const BodyProperties body = properties_of(parts);
    EXPECT_NEAR(body.mass_kg, 0.340, 1e-12);
    double butt = 0.0;
    double tip = 0.0;
    for (const ObjectPart& part : parts) {
        for (const Eigen::Vector3d& v : part.mesh.vertices) {
            butt = std::min(butt, v.z());
            tip = std::max(tip, v.z());
        }
    }
    EXPECT_NEAR(tip - butt, 0.6858, 2e-4);
    EXPECT_NEAR(-butt, 0.327, 0.001);
    const double swing = body.inertia_kg_m2(1, 1) + 0.340 * std::pow(-butt - 0.1, 2);
    EXPECT_NEAR(swing, 0.0331, 0.0002);
    EXPECT_NEAR(body.inertia_kg_m2(2, 2), 0.0016, 0.0001);
    // For a nearly plane body the largest moment is almost the sum of the others.
    EXPECT_NEAR(body.inertia_kg_m2(0, 0), body.inertia_kg_m2(1, 1) + body.inertia_kg_m2(2, 2),
                1e-4);
}

TEST(NamedObjectMoments, OfThePlateGiveAWobbleRateNearTwiceTheSpin) {
    const Eigen::Vector3d I = moments_of("plate");
    EXPECT_NEAR(I.z() / I.x(), 1.979, 0.002);
}

// The rule's circumference along the seam: 28 to 28 1/2 inches.
TEST(NamedObjectMoments, OfTheFootballMatchARegulationBall) {
    const auto parts = object_named("football").make();
    const TriangleMesh& panels = parts.front().mesh;
    std::vector<Eigen::Vector2d> meridian;
    double length = 0.0;
    double radius = 0.0;
    for (const Eigen::Vector3d& v : panels.vertices) {
        length = std::max(length, 2.0 * std::abs(v.z()));
        radius = std::max(radius, v.head<2>().norm());
    }
    for (const Eigen::Vector3d& v : panels.vertices) {
        // The outer seam in the half-plane y = 0, x ≥ 0, as radius by height; the inner seam lies 4
        // mm deeper.
        if (v.y() != 0.0 || v.x() < 0.0) continue;
        const double s = std::sqrt(std::max(0.0, 1.0 - std::pow(2.0 * v.z() / length, 2)));
        if (v.x() > radius * (0.77 * s + 0.23 * s * s) - 1e-4) meridian.emplace_back(v.x(), v.z());
    }
    std::ranges::sort(meridian, {}, [](const Eigen::Vector2d& p) { return p.y(); });
    double half = 0.0;
    for (std::size_t i = 1; i < meridian.size(); ++i)
        half += (meridian[i] - meridian[i - 1]).norm();
    EXPECT_NEAR(2.0 * half / 0.0254, 28.05, 0.05);
    EXPECT_NEAR(length / 0.0254, 11.125, 0.001);
    const BodyProperties ball = properties_of(parts);
    EXPECT_NEAR(ball.mass_kg, 14.5 * 0.028349523125, 1e-12);
    EXPECT_GT(ball.inertia_kg_m2(0, 0) / ball.inertia_kg_m2(2, 2), 1.5);
}

TEST(NamedObjectMoments, OfTheEarthGiveTheEulerPeriod) {
    const BodyProperties earth = properties_of_object("earth");
    EXPECT_NEAR(earth.mass_kg, 5.9722e24, 1e-12 * 5.9722e24);
    const double A = earth.inertia_kg_m2(0, 0);
    const double C = earth.inertia_kg_m2(2, 2);
    EXPECT_NEAR(C / (earth.mass_kg * 6378137.0 * 6378137.0), 0.3307, 1e-5);
    EXPECT_NEAR(A / (C - A), 304.46, 0.3);  // observed: (1/0.0032738) − 1
}

// The radar model's ratios are 3.22 and 3.09 (Hudson & Ostro 1995).
TEST(NamedObjectMoments, OfToutatisMatchTheRadarModel) {
    const Eigen::Vector3d I = moments_of("toutatis");
    EXPECT_NEAR(I.x() / I.z(), 3.22, 0.03);
    EXPECT_NEAR(I.y() / I.z(), 3.09, 0.03);
}

TEST(NamedObjectTable, SuggestsTheNearestName) {
    try {
        object_named("racquet");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean \"racket\"?"), std::string::npos);
    }
}

}  // namespace
}  // namespace poinsot
