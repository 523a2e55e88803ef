// A scene that is written and read again is exactly the same scene.
#include "scene/write_scene.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "places.h"
#include "scene/camera_views.h"
#include "scene/frame_rate.h"
#include "scene/toml_text.h"
#include "scene_text.h"

namespace poinsot {

namespace {

// The same cases in every run.
const bool seeded = ::setenv("RC_PARAMS", "seed=4179 max_success=300", 1) == 0;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Any finite double, by its bits, including subnormal ones and −0.
double any_double() {
    const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    return std::isfinite(value) ? value : -0.0;
}

double number_from(double least, double most) {
    const double part =
        static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1'000'000'007)) / 1e9;
    return least + part * (most - least);
}

template <typename Vector>
Vector any_vector() {
    Vector vector;
    for (double& entry : vector.reshaped()) entry = any_double();
    return vector;
}

std::string any_text() {
    // Quotes, backslashes, line ends, tabs, characters of two to four bytes.
    std::string text;
    for (int n = *rc::gen::inRange(0, 12); n > 0; --n) {
        text += *rc::gen::elementOf(std::vector<std::string>{"a", "\"", "\\", "'", "\n", "\t", "ω",
                                                             "₁", "𝐋", "#", "{", "="});
    }
    return text;
}

// Equal in every value of a scene file; each of them has its own text.
void expect_same(const Scene& a, const Scene& b) {
    RC_ASSERT(to_toml(a) == to_toml(b));
    for (int i = 0; i < 3; ++i) {
        RC_ASSERT(bits(a.start.omega_rad_s[i]) == bits(b.start.omega_rad_s[i]));
        RC_ASSERT(bits(a.body.inertia.moments_kg_m2()[i]) ==
                  bits(b.body.inertia.moments_kg_m2()[i]));
        RC_ASSERT(bits(a.body.centre_of_mass_m_body[i]) == bits(b.body.centre_of_mass_m_body[i]));
    }
    for (int i = 0; i < 4; ++i) {
        RC_ASSERT(bits(a.start.space_from_body.coeffs()[i]) ==
                  bits(b.start.space_from_body.coeffs()[i]));
    }
    RC_ASSERT(a.title == b.title);
    RC_ASSERT(a.caption == b.caption);
    RC_ASSERT(a.torque.index() == b.torque.index());
    RC_ASSERT(b.notes.empty());
}

TEST(RoundTrip, EveryDoubleIsReadBack) {
    ASSERT_TRUE(seeded);
    for (const double value : {0.0, -0.0, 1.0, 1e20, 1e21, 5e-324, -1.7976931348623157e308,
                               2.2250738585072014e-308, 0.1, 1e-5}) {
        const Scene scene = scene_of(a_scene + "[film]\nstart_s = " + toml_text(value) + "\n");
        EXPECT_EQ(bits(scene.film.start_s), bits(value)) << toml_text(value);
    }
    EXPECT_TRUE(rc::check([] {
        const double value = any_double();
        const Scene scene = scene_of(a_scene + "[film]\nstart_s = " + toml_text(value) + "\n");
        RC_ASSERT(bits(scene.film.start_s) == bits(value));
    }));
}

TEST(RoundTrip, EveryTextIsReadBack) {
    EXPECT_TRUE(rc::check([] {
        const std::string text = any_text();
        RC_ASSERT(scene_of("title = " + toml_text(std::string_view(text)) + "\n" + a_scene).title ==
                  text);
    }));
}

TEST(RoundTrip, MomentsAndFilmAreReadBack) {
    EXPECT_TRUE(rc::check([] {
        std::string text = "title = " + toml_text(std::string_view(any_text())) + "\n";
        const double I1 = number_from(1.0, 2.0);
        const double I2 = number_from(1.0, 2.0);
        text +=
            "[body]\nmoments_kg_m2 = " + toml_text(Eigen::Vector3d(I1, I2, number_from(1.0, 2.0))) +
            "\n";
        text += "[start]\nomega_rad_s = " + toml_text(any_vector<Eigen::Vector3d>()) + "\n";
        text += "[film]\nfps = \"" + text_of_rate({*rc::gen::inRange<std::int64_t>(1, 1000), 1}) +
                "\"\nstart_s = " + toml_text(number_from(-1e3, 1e3)) + "\n";
        const double x = number_from(-1e4, 1e4), y = number_from(-1e4, 1e4);
        text +=
            "[camera]\ntarget = " + toml_text(Eigen::Vector3d(x, y, number_from(-1e4, 1e4))) + "\n";
        const Scene scene = scene_of(text);
        expect_same(scene, scene_of(to_toml(scene)));
    }));
}

TEST(RoundTrip, NormalisedAttitudesAreReadBack) {
    EXPECT_TRUE(rc::check([] {
        Eigen::Vector4d q;
        for (double& entry : q.reshaped()) entry = number_from(-1.0, 1.0);
        RC_PRE(q.norm() > 0.0);
        q *= std::ldexp(1.0, *rc::gen::inRange(-900, 900));
        const Scene scene = scene_of(a_scene + "attitude = " + toml_text(q) + "\n");
        // measured 3e-16
        RC_ASSERT(std::abs(scene.start.space_from_body.norm() - 1.0) < 1e-15);
        RC_ASSERT(scene.start.space_from_body.w() >= 0.0);
        expect_same(scene, scene_of(to_toml(scene)));
    }));
}

TEST(RoundTrip, TensorsAreReadBack) {
    EXPECT_TRUE(rc::check([] {
        // Diagonally dominant, moments within a factor of two: physical.
        Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
        for (int i = 0; i < 3; ++i) {
            tensor(i, i) = number_from(2.0, 2.5);
            for (int j = 0; j < i; ++j) tensor(i, j) = tensor(j, i) = number_from(-0.1, 0.1);
        }
        const Scene scene = scene_of("[body]\ntensor_kg_m2 = " + toml_text(tensor) + a_start);
        const Scene again = scene_of(to_toml(scene));
        expect_same(scene, again);
        RC_ASSERT(again.body.tensor_kg_m2 == tensor);
        RC_ASSERT(again.body.inertia.body_from_principal() ==
                  scene.body.inertia.body_from_principal());
    }));
}

TEST(RoundTrip, MassesAreReadBack) {
    EXPECT_TRUE(rc::check([] {
        // Around the corners of a tetrahedron, so that the body has extent in every direction.
        std::string text;
        const Eigen::Vector3d corners[] = {
            {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {-1.0, -1.0, -1.0}};
        for (const Eigen::Vector3d& corner : corners) {
            const Eigen::Vector3d offset(number_from(-0.3, 0.3), number_from(-0.3, 0.3),
                                         number_from(-0.3, 0.3));
            text += "[[body.masses]]\nmass_kg = " + toml_text(number_from(0.5, 2.0)) +
                    "\nat_m = " + toml_text(Eigen::Vector3d(corner + offset)) + "\n";
        }
        const Scene scene = scene_of(text + a_start);
        expect_same(scene, scene_of(to_toml(scene)));
    }));
}

TEST(RoundTrip, TopsAreReadBack) {
    EXPECT_TRUE(rc::check([] {
        const Scene scene = scene_of(
            "[body]\nmoments_kg_m2 = [1.0, 1.0, 0.5]\n[start]\ntheta_rad = " +
            toml_text(number_from(0.0, 3.14)) + "\ntheta_dot_rad_s = " + toml_text(any_double()) +
            "\nphi_dot_rad_s = " + toml_text(any_double()) +
            "\nomega3_rad_s = " + toml_text(any_double()) +
            "\n[torque]\nkind = \"gravity\"\nmgl_N_m = " + toml_text(any_double()) + "\n");
        const Scene again = scene_of(to_toml(scene));
        expect_same(scene, again);
        RC_ASSERT(bits(scene.start.top->phi_dot_rad_s) == bits(again.start.top->phi_dot_rad_s));
    }));
}

// In TOML a line belongs to the header above it.
TEST(RoundTrip, KeysWithoutATableAreWrittenFirst) {
    const std::string given =
        "show = [\"plane\"]\nlabels = false\nunlabelled = [\"omega\"]\n"
        "[symbols]\nomega = \"w\"\n" +
        a_scene;
    const Scene scene = scene_of(given);
    const std::string written = to_toml(scene);
    for (const char* key : {"\nshow = ", "\nlabels = ", "\nunlabelled = "})
        EXPECT_LT(written.find(key), written.find("\n[")) << written;
    const Scene again = scene_of(written);
    EXPECT_EQ(to_toml(again), written);
    EXPECT_EQ(again.show, scene.show);
    EXPECT_FALSE(again.labels);
    EXPECT_EQ(again.unlabelled, scene.unlabelled);
    EXPECT_EQ(again.symbols.omega, "w");
}

TEST(RoundTrip, NamesAndMovedLabelsAreReadBack) {
    const Scene scene = scene_of(
        "names = [\"polhode\", \"body-cone\"]\n[symbols]\npolhode = \"p\"\n"
        "body-cone = \"$K$\"\n[labels]\nomega.offset_pt = [1.5, -2.0]\n"
        "invariable-plane.offset_pt = [0.0, 1e-3]\n" +
        a_scene);
    const Scene again = scene_of(to_toml(scene));
    EXPECT_EQ(to_toml(again), to_toml(scene));
    ASSERT_TRUE(again.names);
    EXPECT_EQ(*again.names, (std::vector<std::string>{"polhode", "body-cone"}));
    EXPECT_EQ(again.symbols.things.at("body-cone"), "$K$");
    EXPECT_EQ(again.label_offsets_pt.at("omega"), Eigen::Vector2d(1.5, -2.0));
    EXPECT_EQ(again.label_offsets_pt.at("invariable-plane"), Eigen::Vector2d(0.0, 1e-3));
    EXPECT_EQ(again.label_offsets_pt.size(), 2u);
    // true is the default, and false is no name at all.
    EXPECT_FALSE(scene_of("names = true\n" + a_scene).names);
    const Scene none = scene_of(to_toml(scene_of("names = false\n" + a_scene)));
    ASSERT_TRUE(none.names);
    EXPECT_TRUE(none.names->empty());
}

// A view's aim is not written together with a target, which contradicts it.
TEST(RoundTrip, TargetsWithAViewAreReadBack) {
    for (const CameraView& view : camera_views()) {
        const Scene scene = scene_of(a_scene + "[camera]\nview = \"" + std::string(view.name) +
                                     "\"\ntarget = [1.0, 2.0, 3.0]\n");
        const Scene again = scene_of(to_toml(scene));
        EXPECT_EQ(again.camera.target, Eigen::Vector3d(1.0, 2.0, 3.0)) << view.name;
        EXPECT_EQ(to_toml(again), to_toml(scene)) << view.name;
    }
}

TEST(RoundTrip, NegativeZerosOfAnAttitudeAreReadBack) {
    // Also for −1, 0, 0, 0, whose sign is changed.
    for (const char* attitude : {"[1.0, -0.0, 0.0, 0.0]", "[-1.0, 0.0, 0.0, 0.0]"}) {
        const Scene scene = scene_of(a_scene + "attitude = " + attitude + "\n");
        const Scene again = scene_of(to_toml(scene));
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(bits(again.start.space_from_body.coeffs()[i]),
                      bits(scene.start.space_from_body.coeffs()[i]))
                << attitude;
    }
}

TEST(RoundTrip, SmallestElementsOfATensorAreReadBack) {
    const Scene scene =
        scene_of("[body]\ntensor_kg_m2 = [[2, 5e-324, 0], [5e-324, 2, 0], [0, 0, 3]]\n" + a_start);
    EXPECT_EQ(scene.body.tensor_kg_m2(0, 1), 5e-324);
    EXPECT_EQ(scene_of(to_toml(scene)).body.tensor_kg_m2, scene.body.tensor_kg_m2);
}

// A printed still has as many pixels as its size in inches times its dots per inch.
TEST(RoundTrip, LargestStillsAreReadBack) {
    Scene scene = scene_of(a_scene);
    scene.film.width_px = 65536;
    scene.film.height_px = 16385;
    const Scene again = scene_of(to_toml(scene));
    EXPECT_EQ(again.film.width_px, 65536);
    EXPECT_EQ(again.film.height_px, 16385);
}

TEST(RoundTrip, EverySceneOfTheLectureIsReadBack) {
    int n_scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        ++n_scenes;
        const Scene scene = load_scene(entry.path());
        const Scene again =
            parse_scene(to_toml(scene), entry.path().string(), {}, files_of_folder());
        EXPECT_EQ(to_toml(again), to_toml(scene)) << entry.path();
    }
    EXPECT_GE(n_scenes, 10);
}

}  // namespace

}  // namespace poinsot
