// Random scenes with every key are read back from their written text, which the record of a picture
// contains.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mesh_folder.h"
#include "random_scene.h"
#include "scene/scene_keys.h"
#include "scene/toml/toml_document.h"
#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot::random_scenes_tests {
namespace {

std::optional<Scene> scene_if_any(const std::string& text) {
    try {
        return scene_of(text);
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

// The values of a document with their paths: "panels[2].camera.view".
void flatten(const TomlValue& value, const std::string& path,
             std::map<std::string, TomlValue>& values) {
    const bool is_array_of_tables = value.type == TomlValue::Type::array && !value.items.empty() &&
                                    value.items[0].type == TomlValue::Type::table;
    if (value.type == TomlValue::Type::table) {
        for (const TomlEntry& entry : value.entries)
            flatten(entry.value, path + (path.empty() ? "" : ".") + entry.key, values);
    } else if (is_array_of_tables) {
        for (std::size_t i = 0; i < value.items.size(); ++i)
            flatten(value.items[i], fmt::format("{}[{}]", path, i), values);
    } else {
        values[path] = value;
    }
}

std::map<std::string, TomlValue> values_of(const std::string& text) {
    std::map<std::string, TomlValue> values;
    flatten(parse_toml(text, "scenes/a.toml"), "", values);
    return values;
}

std::string row_of(const std::string& path) {
    const std::size_t open = path.find('['), close = path.find(']');
    return open == std::string::npos ? path : path.substr(0, open + 1) + path.substr(close);
}

// The text that a row writes for a default scene.
std::string text_by_default(const SceneKey& key) {
    static const Scene plain = [] {
        Scene scene;
        scene.body.masses_as_given.emplace_back();
        scene.object.pictures.emplace_back();
        scene.panels.emplace_back();
        scene.marks.emplace_back();
        scene.keyframes.emplace_back();
        scene.fades.emplace_back();
        scene.captions.emplace_back();
        scene.chapters.emplace_back();
        scene.stops.emplace_back();
        return scene;
    }();
    return key.write(plain, 0);
}

// Values that are not written because the scene is the same without them.
bool goes_without_saying(const std::string& row, const std::string& value) {
    static const std::map<std::string, std::string> defaults{
        {"labels", "true"},
        {"names", "true"},
        {"overlays", "true"},
        {"panel_letters", "false"},
        {"language", "\"en\""},
        {"torque.kind", "\"none\""},
        {"marks[].name", "\"\""},
        {"panels[].quantity", "\"\""},
        {"stops[].title", "\"\""},
        {"stops[].note", "\"\""},
        {"captions[].place", "\"bottom\""},
        {"camera.projection", "\"perspective\""},
        {"trail.axis", "\"history\""}};
    if (row.starts_with("symbols.")) return value == "\"\"";
    const auto found = defaults.find(row);
    return found != defaults.end() && found->second == value;
}

// Attitudes and arms are normalised, and a matrix becomes a quaternion.
bool is_normalised(const std::string& row) {
    return row == "start.attitude" || row == "start.attitude_matrix" || row == "torque.arm_body";
}

// All data that a scene is computed from and that the scene's text does not contain.
void expect_same_state(const Scene& a, const Scene& b, const std::string& text) {
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(bits(a.start.space_from_body.coeffs()[i]),
                  bits(b.start.space_from_body.coeffs()[i]))
            << text;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(bits(a.start.omega_rad_s[i]), bits(b.start.omega_rad_s[i])) << text;
        EXPECT_EQ(bits(a.body.inertia.moments_kg_m2()[i]), bits(b.body.inertia.moments_kg_m2()[i]))
            << text;
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(bits(a.body.inertia.body_from_principal()(i, j)),
                      bits(b.body.inertia.body_from_principal()(i, j)))
                << text;
    }
    EXPECT_EQ(bits(a.body.mass_kg), bits(b.body.mass_kg)) << text;
    EXPECT_EQ(a.torque.index(), b.torque.index()) << text;
    EXPECT_EQ(a.surfaces.size(), b.surfaces.size()) << text;
    EXPECT_EQ(a.object.pictures.size(), b.object.pictures.size()) << text;
}

TEST(RandomScenes, OfEveryKeyAreReadBack) {
    const MeshFolder folder;
    Dice dice(20260301);
    std::set<std::string> said;  // rows with a value other than their default
    constexpr int n_scenes = 1000;
    int n_read = 0;
    for (int n = 0; n < n_scenes && !HasFailure(); ++n) {
        const Text text = random_scene(dice);
        // Some contradict themselves and are not valid scenes.
        const std::optional<Scene> scene = scene_if_any(text.toml());
        if (!scene) continue;
        ++n_read;
        const std::string written = to_toml(*scene);
        std::optional<Scene> again;
        ASSERT_NO_THROW(again = scene_of(written)) << text.toml() << "\nwritten:\n" << written;
        ASSERT_EQ(to_toml(*again), written);
        expect_same_state(*scene, *again, text.toml());
        EXPECT_EQ(again->notes, std::vector<std::string>{}) << written;

        // Every given value is written, or implied.
        const auto given = values_of(text.toml());
        const auto found = values_of(written);
        for (const auto& [path, value] : given) {
            const SceneKey* key = find_scene_key(row_of(path));
            ASSERT_NE(key, nullptr) << path;
            if (is_normalised(row_of(path))) {
                const Eigen::Quaterniond& q = scene->start.space_from_body;
                if (key->path != "torque.arm_body" && std::abs(q.w()) != 1.0)
                    said.emplace(key->path);
                continue;
            }
            const auto there = found.find(path);
            if (there != found.end()) {
                EXPECT_TRUE(same(value, there->second)) << path << "\n" << text.toml() << written;
            } else {
                EXPECT_TRUE(goes_without_saying(row_of(path), text.values().at(path)))
                    << path << " is not written\n"
                    << text.toml();
            }
        }
        for (const auto& [path, value] : found) {
            const SceneKey* key = find_scene_key(row_of(path));
            ASSERT_NE(key, nullptr) << path;
            const std::size_t open = path.find('[');
            const std::size_t item =
                open == std::string::npos ? 0 : std::stoul(path.substr(open + 1));
            if (key->write(*again, item) != text_by_default(*key)) said.emplace(key->path);
        }
    }
    if (HasFailure()) return;
    for (const SceneKey& key : scene_keys())
        EXPECT_TRUE(said.contains(std::string(key.path))) << key.path << " was never said";
    EXPECT_GT(n_read, n_scenes / 4);
}

}  // namespace
}  // namespace poinsot::random_scenes_tests
