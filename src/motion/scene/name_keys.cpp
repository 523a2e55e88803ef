// Keys of the names of curves and surfaces, and of labels that are moved by hand.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_key_rows.h"

namespace poinsot {

namespace {

// `names`: true for all, false for none, or a list.
void read_names(const GivenValue& given, SceneDraft& draft) {
    std::optional<std::vector<std::string>>& names = draft.scene.names;
    if (given.value().type != TomlValue::Type::boolean)
        names = given.texts();
    else if (given.boolean())
        names.reset();
    else
        names.emplace();
}

std::string names_text(const Scene& scene, std::size_t) {
    if (!scene.names) return "";
    return scene.names->empty() ? "false" : toml_text(std::span<const std::string>(*scene.names));
}

// The name of a curve or surface. The deque holds the texts to which its string views refer.
SceneKey thing_row(std::string_view name) {
    static std::deque<std::string> words;
    std::string thing(name);
    std::replace(thing.begin(), thing.end(), '-', ' ');
    return key_rows::row(
               words.emplace_back(fmt::format("symbols.{}", name)), {.kind = ValueType::Kind::text},
               R"("rolling curve")",
               words.emplace_back(fmt::format("text of the label \"{}\", with $formulas$", thing)))
        .read_by([name](const GivenValue& given, SceneDraft& draft) {
            draft.scene.symbols.things.insert_or_assign(std::string(name), given.text());
        })
        .written_by([name](const Scene& scene, std::size_t) {
            const auto found = scene.symbols.things.find(name);
            return found == scene.symbols.things.end() ? ""
                                                       : toml_text(std::string_view(found->second));
        })
        .default_is("its name in `language`");
}

// How far a label is moved by hand.
SceneKey offset_row(std::string_view name) {
    static std::deque<std::string> words;
    ValueType type{.kind = ValueType::Kind::number, .bounds = within(-1000.0, 1000.0)};
    type.unit = "points";
    type.size = ValueType::Size{2, 2};
    return key_rows::row(words.emplace_back(fmt::format("labels.{}.offset_pt", name)), type,
                         "[6.0, -4.0]",
                         words.emplace_back(fmt::format(
                             "how far the label of {} is moved to the right and down; on screens a "
                             "picture is 540 points high",
                             name)))
        .read_by([name](const GivenValue& given, SceneDraft& draft) {
            const std::vector<double> xy = given.numbers();
            draft.scene.label_offsets_pt.insert_or_assign(std::string(name),
                                                          Eigen::Vector2d(xy[0], xy[1]));
        })
        .written_by([name](const Scene& scene, std::size_t) -> std::string {
            const auto found = scene.label_offsets_pt.find(name);
            // A file has either labels = false or [labels].
            if (found == scene.label_offsets_pt.end() || !scene.labels) return "";
            const Eigen::Vector2d& xy = found->second;
            return toml_text(std::span<const double>(xy.data(), 2));
        })
        .default_is("[0, 0]");
}

}  // namespace

std::span<const SceneKey> name_keys() {
    static const std::vector<SceneKey> rows = [] {
        std::vector<SceneKey> made;
        made.push_back(key_rows::texts("names", &Scene::names, R"(["polhode", "herpolhode"])",
                                       "curves and surfaces that have their names in the picture: "
                                       "all, none, or those of the list")
                           .values_from(named_things)
                           .or_boolean()
                           .default_is("true")
                           .read_by(read_names)
                           .written_by(names_text));
        for (const std::string_view name : named_things) made.push_back(thing_row(name));
        for (const std::string_view name : named_things) made.push_back(offset_row(name));
        for (const std::string_view name : named_quantities) made.push_back(offset_row(name));
        return made;
    }();
    return rows;
}

}  // namespace poinsot
