// Every row of the key table is read, refused when invalid, and written back.
#include "scene/scene_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh_folder.h"
#include "refusal.h"
#include "scene/scene_key_rows.h"
#include "scene/toml/toml_document.h"
#include "scene/write_scene.h"
#include "scene_key_claims.h"
#include "scene_text.h"

namespace poinsot::scene_keys_tests {
namespace {

// The folder with the wedge and the cover.
const MeshFolder folder;

// The header lines of a key's table; one of an item, such as [panels.camera], is below its item.
std::string header_of(const SceneKey& key) {
    if (key.table().empty()) return "";
    const std::string table(key.table());
    const std::size_t item = table.find("[].");
    return (item == std::string::npos ? "" : fmt::format("[[{}]]\n", table.substr(0, item))) +
           written_table(table) + "\n";
}

// The line of the example, in its table.
std::string example_of(const SceneKey& key, const std::string& value) {
    return fmt::format("{}{} = {}\n", header_of(key), key.leaf(), value);
}

TEST(SceneKeys, EveryRowRefusesAWrongTypeWithItsExample) {
    for (const SceneKey& key : scene_keys()) {
        // A key that is also a table: labels.
        if (is_scene_table(key.path)) continue;
        const std::string message = refusal(example_of(key, "{a = 1}"));
        EXPECT_NE(message.find("is a table; it must be " + key.expectation()), std::string::npos)
            << message;
        EXPECT_NE(message.find(fmt::format("as in {} = {}", key.leaf(), key.example)),
                  std::string::npos)
            << message;
    }
}

TEST(SceneKeys, NumbersMustBeFinite) {
    // Each number of the example in turn is replaced.
    for (const SceneKey& key : scene_keys()) {
        const std::string example(key.example);
        if (key.type.kind == ValueType::Kind::integer || example.front() == '"') continue;
        for (std::size_t i = 0; i < example.size();) {
            const std::size_t from = example.find_first_of("-0123456789", i);
            if (from == std::string::npos) break;
            const std::size_t to =
                std::min(example.find_first_not_of("-+.e0123456789", from), example.size());
            for (const std::string bad : {"nan", "-inf"}) {
                std::string value = example;
                value.replace(from, to - from, bad);
                const std::string message = refusal(example_of(key, value));
                EXPECT_NE(message.find("give a finite number"), std::string::npos)
                    << value << ": " << message;
            }
            i = to;
        }
    }
}

TEST(SceneKeys, EveryMistypedKeySuggestsItsRow) {
    // The last letter of the name is missing.
    for (const SceneKey& key : scene_keys()) {
        std::string name(key.leaf());
        name.pop_back();
        if (name.size() < 2) continue;  // e1 and e2 have the same remainder
        if (find_scene_key(
                fmt::format("{}{}{}", key.table(), key.table().empty() ? "" : ".", name))) {
            continue;
        }
        const std::string message = refusal(fmt::format("{}{} = 1\n", header_of(key), name));
        EXPECT_NE(message.find(fmt::format("did you mean \"{}\"?", key.leaf())), std::string::npos)
            << message;
    }
}

TEST(SceneKeys, EveryRowIsExplained) {
    for (const SceneKey& key : scene_keys()) {
        EXPECT_FALSE(key.summary.empty()) << key.path;
        EXPECT_FALSE(key.example.empty()) << key.path;
    }
}

// The error message for a value of a key, read by its row alone. Empty: the value is then in the
// draft.
std::string said_of(const SceneKey& key, const std::string& text, SceneDraft& draft) {
    const TomlValue document = parse_toml("value = " + text, "scenes/a.toml");
    return refusal_message<SceneError>([&] {
        key.read(GivenValue(key, std::string(key.path), 0, document.entries.at(0).value), draft);
    });
}
std::string said_of(const SceneKey& key, const std::string& text) {
    SceneDraft draft = draft_by_default();
    return said_of(key, text, draft);
}

// The values of all rows that a draft's scene has.
std::vector<std::string> values_of(const SceneDraft& draft) {
    std::vector<std::string> values;
    for (const SceneKey& key : scene_keys()) values.push_back(key.value(draft.scene, 0));
    return values;
}

TomlValue toml_value(const std::string& text) {
    return parse_toml("value = " + text, "scenes/a.toml").entries.at(0).value;
}

TEST(SceneKeys, EveryExampleIsReadIntoItsOwnMemberAlone) {
    const std::vector<std::string> before = values_of(draft_by_default());
    std::set<std::string_view> paths;
    for (std::size_t row = 0; row < scene_keys().size(); ++row) {
        const SceneKey& key = scene_keys()[row];
        EXPECT_TRUE(paths.insert(key.path).second) << "two rows of " << key.path;
        SceneDraft draft = draft_by_default();
        ASSERT_EQ(said_of(key, std::string(key.example), draft), "") << key.path;
        if (claims.contains(std::string(key.path))) continue;
        // A default as the example would change nothing.
        std::vector<std::string> values{
            std::string(key.example), "true", "false", "2", "0.5", "\"x\"", "\"linear\""};
        for (const std::string_view name : key.type.names) values.push_back(toml_text(name));
        const auto given =
            std::find_if(values.begin(), values.end(), [&](const std::string& value) {
                return value != before[row] && said_of(key, value) == "";
            });
        EXPECT_NE(given, values.end()) << key.path;
        if (given == values.end()) continue;
        ASSERT_EQ(said_of(key, *given, draft), "") << key.path;
        std::vector<std::string> after = values_of(draft);
        EXPECT_NE(after[row], "") << key.path;
        if (after[row].empty()) continue;
        EXPECT_TRUE(same(toml_value(after[row]), toml_value(*given)))
            << key.path << " = " << after[row];
        // The first key of a table may create the others.
        for (std::size_t other = 0; other < after.size(); ++other) {
            const bool may_appear =
                before[other].empty() && scene_keys()[other].table() == key.table();
            if (other == row || may_appear) continue;
            EXPECT_EQ(after[other], before[other])
                << key.path << " is read into " << scene_keys()[other].path;
        }
    }
}

TEST(SceneKeys, EveryClaimHoldsForTheSceneAndAsWritten) {
    for (const auto& [path, claim] : claims) {
        EXPECT_NE(find_scene_key(path), nullptr) << path;
        const Scene scene = scene_of(claim.text);
        EXPECT_TRUE(claim.holds(scene)) << path;
        const std::string text = to_toml(scene);
        EXPECT_TRUE(claim.holds(scene_of(text))) << path << "\n" << text;
    }
}

// A number as TOML text, or a list of equal numbers.
std::string numbers_text(const ValueType& type, double number) {
    const std::string one = type.kind == ValueType::Kind::integer
                                ? toml_text(static_cast<int>(number))
                                : toml_text(number);
    if (!type.size) return one;
    std::vector<std::string> all(std::max<std::size_t>(type.size->least, 1), one);
    const std::string row = fmt::format("[{}]", fmt::join(all, ", "));
    return type.n_rows == 0 ? row : fmt::format("[{}, {}, {}]", row, row, row);
}

TEST(SceneKeys, EveryBoundHoldsExactlyAtItsEdges) {
    int n_edges = 0;
    for (const SceneKey& key : scene_keys()) {
        const ValueType& type = key.type;
        if (type.kind != ValueType::Kind::number && type.kind != ValueType::Kind::integer) continue;
        const bool whole = type.kind == ValueType::Kind::integer;
        const double infinity = std::numeric_limits<double>::infinity();
        const auto expect_edge = [&](double inside, double outside) {
            ++n_edges;
            EXPECT_EQ(said_of(key, numbers_text(type, inside)), "") << key.path;
            const std::string said = said_of(key, numbers_text(type, outside));
            EXPECT_NE(said.find(type.bounds.words()), std::string::npos)
                << key.path << ": " << said;
            EXPECT_NE(said.find("give a"), std::string::npos) << key.path << ": " << said;
        };
        const Bounds& bounds = type.bounds;
        if (bounds.least && bounds.without_least)
            expect_edge(std::nextafter(*bounds.least, infinity), *bounds.least);
        else if (bounds.least)
            expect_edge(*bounds.least,
                        whole ? *bounds.least - 1 : std::nextafter(*bounds.least, -infinity));
        if (bounds.most)
            expect_edge(*bounds.most,
                        whole ? *bounds.most + 1 : std::nextafter(*bounds.most, infinity));
        if (bounds.least || bounds.most) continue;
        for (const double extreme : {1.0, -1.0}) {
            const double largest = extreme * std::numeric_limits<double>::max();
            EXPECT_EQ(said_of(key, numbers_text(type, largest)), "") << key.path;
        }
    }
    EXPECT_GT(n_edges, 80);
}

TEST(SceneKeys, EveryListHasAsManyValuesAsItsRowSays) {
    int n_lists = 0;
    for (const SceneKey& key : scene_keys()) {
        const ValueType& type = key.type;
        if (!type.size || type.kind == ValueType::Kind::text) continue;
        const auto list_of = [&](std::size_t n) {
            const std::vector<std::string> ones(n, "1");
            const std::string row = fmt::format("[{}]", fmt::join(ones, ", "));
            return type.n_rows == 0 ? row : fmt::format("[{}, {}, {}]", row, row, row);
        };
        const bool is_limited = type.size->most != ValueType::Size{}.most;
        ++n_lists;
        EXPECT_EQ(said_of(key, list_of(type.size->least)), "") << key.path;
        EXPECT_EQ(said_of(key, list_of(is_limited ? type.size->most : 100)), "") << key.path;
        if (type.size->least > 0) {
            EXPECT_NE(said_of(key, list_of(type.size->least - 1)), "") << key.path;
        }
        if (is_limited) {
            EXPECT_NE(said_of(key, list_of(type.size->most + 1)), "") << key.path;
        }
        if (type.n_rows > 0) {
            EXPECT_NE(said_of(key, "[[1, 1, 1], [1, 1, 1]]"), "") << key.path;
        }
    }
    EXPECT_GT(n_lists, 12);
}

TEST(SceneKeys, EveryNameOfAFixedListIsReadAndNoOther) {
    int n_names = 0;
    for (const SceneKey& key : scene_keys()) {
        for (const std::string_view name : key.type.names) {
            ++n_names;
            SceneDraft draft = draft_by_default();
            const std::string given = key.type.size ? "[" + toml_text(name) + "]" : toml_text(name);
            EXPECT_EQ(said_of(key, given, draft), "") << key.path;
            // The scene has no torque before all of its keys are read.
            const std::string kept = key.path == "torque.kind"
                                         ? toml_text(std::string_view(draft.torque_kind))
                                         : key.value(draft.scene, 0);
            EXPECT_EQ(kept, given) << key.path;
        }
        if (key.type.names.empty()) continue;
        EXPECT_NE(said_of(key, key.type.size ? "[\"no such name\"]" : "\"no such name\"")
                      .find("; choose from: "),
                  std::string::npos)
            << key.path;
        EXPECT_NE(said_of(key, "\"\""), "") << key.path;
    }
    EXPECT_GT(n_names, 60);
}

// The numbers of a torque have one name, here and in Python.
TEST(SceneKeys, EveryNumberOfATorqueIsAKeyOfItsKind) {
    std::set<std::pair<std::size_t, std::string>> numbers, keys;
    std::size_t kind = 0;
    const auto add = [&](const auto& row_of_kind) {
        std::apply(
            [&](const auto&... number) {
                (numbers.insert({kind, "torque." + std::string(number.name)}), ...);
            },
            row_of_kind);
        ++kind;
    };
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        (add(KindOfTorque<std::variant_alternative_t<k, Torque>>::numbers), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Torque>>());
    for (const SceneKey& key : scene_keys())
        if (key.torque_kind) keys.insert({*key.torque_kind, std::string(key.path)});
    // The half-life depends on the start too.
    EXPECT_EQ(keys.erase({index_of_torque<InternalFriction>, "torque.half_life_s"}), 1u);
    EXPECT_EQ(keys, numbers);
    EXPECT_EQ(numbers.size(), 8u);
}

TEST(SceneKeys, EveryDefaultIsTheValueOfASceneWithoutTheKey) {
    // Scenes with the required keys only, and an item in every array of tables.
    const std::string items =
        a_picture +
        "[[panels]]\n[[marks]]\nat = [1, 2, 3]\n[[keyframes]]\nat_s = 1\nspeed = 2\n"
        "[[fades]]\nat_s = 1\nelements = [\"plane\"]\n[[captions]]\nat_s = 1\ntext = \"a\"\n"
        "[[chapters]]\nat_s = 1\ntitle = \"b\"\n[[stops]]\nat_s = 1\n";
    const std::array scenes{scene_of(a_scene + items), scene_of(a_top + gravity)};
    int n_defaults = 0;
    for (const SceneKey& key : scene_keys()) {
        if (key.default_text().empty()) continue;
        ++n_defaults;
        EXPECT_EQ(said_of(key, std::string(key.default_text())), "") << key.path;
        const bool is_of_item = key.path.find("[]") != std::string_view::npos;
        bool is_there = false;
        for (const Scene& scene : scenes) {
            const bool has_items = !scene.panels.empty();
            const std::string value = is_of_item && !has_items ? "" : key.value(scene, 0);
            if (value.empty() || scene.locations.contains(std::string(key.path))) continue;
            is_there = true;
            EXPECT_EQ(value, key.default_text()) << key.path;
        }
        EXPECT_TRUE(is_there) << key.path;
    }
    EXPECT_GE(n_defaults, 40);
}

TEST(SceneKeys, AnOmittedDefaultIsNotWritten) {
    for (const SceneKey& key : scene_keys()) {
        SceneDraft draft = draft_by_default();
        if (!key.omits_initial || key.path == "torque.kind") continue;
        EXPECT_EQ(key.write(draft.scene, 0), "") << key.path;
        const std::string other = key.type.kind == ValueType::Kind::boolean
                                      ? (key.initial == "true" ? "false" : "true")
                                      : std::string(key.example);
        ASSERT_EQ(said_of(key, other, draft), "") << key.path;
        EXPECT_NE(key.value(draft.scene, 0), key.initial) << key.path;
        const bool says = key.path != "body.shape";  // written for a solid only
        EXPECT_EQ(key.write(draft.scene, 0), says ? key.value(draft.scene, 0) : "") << key.path;
    }
}

// A scene that gives the key.
std::string given_with(const SceneKey& key) {
    const auto claim = claims.find(std::string(key.path));
    if (claim != claims.end()) return claim->second.text;
    std::string line = example_of(key, std::string(key.example));
    if (key.leaf() == "step_s") line += "method = \"rk4\"\n";
    if (key.leaf() == "tolerance") line += "method = \"dopri5\"\n";
    if (key.leaf() == "order") line += "method = \"dmv\"\n";
    if (key.leaf() == "loop_changes") line += "loop = \"5/3\"\n";
    return key.table().empty() ? line + a_scene : a_scene + line;
}

TEST(SceneKeys, EveryRowMayBeSetOnTheCommandLine) {
    for (const SceneKey& key : scene_keys()) {
        if (key.path.find("[]") != std::string::npos) continue;
        const std::string set = fmt::format("{}={}", key.path, key.example);
        const Scene scene = scene_of(given_with(key), {set});
        const std::string path(key.path);
        EXPECT_EQ(scene.locations.at(path).line, 0) << path;
        EXPECT_EQ(scene.where(path), fmt::format("--set {}: ", set));
    }
}

}  // namespace
}  // namespace poinsot::scene_keys_tests
