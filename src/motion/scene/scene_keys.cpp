#include "scene/scene_keys.h"

#include <fmt/format.h>

#include <vector>

#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"

namespace poinsot {

namespace {

std::vector<SceneKey> all_sections() {
    std::vector<SceneKey> keys;
    for (const auto& section :
         {picture_keys(), name_keys(), body_keys(), motion_keys(), film_keys(), camera_keys(),
          story_keys(), panel_keys(), style_keys(), mark_keys()}) {
        keys.insert(keys.end(), section.begin(), section.end());
    }
    return keys;
}

// A TOML value for use in a sentence: a string without its quotes, 1.0 as 1.
std::string_view plain(std::string_view value) {
    if (value.starts_with('"')) return value.substr(1, value.size() - 2);
    if (value.ends_with(".0")) value.remove_suffix(2);
    return value;
}

const SceneArray arrays[] = {
    {"body.masses", [](SceneDraft& d) { d.masses.emplace_back(); },
     [](const Scene& s) { return s.body.masses_as_given.size(); }},
    {"object.pictures", [](SceneDraft& d) { d.scene.object.pictures.emplace_back(); },
     [](const Scene& s) { return s.object.pictures.size(); }},
    {"panels", [](SceneDraft& d) { d.scene.panels.emplace_back(); },
     [](const Scene& s) { return s.panels.size(); }},
    {"marks", [](SceneDraft& d) { d.scene.marks.emplace_back(); },
     [](const Scene& s) { return s.marks.size(); }},
    {"keyframes", [](SceneDraft& d) { d.scene.keyframes.emplace_back(); },
     [](const Scene& s) { return s.keyframes.size(); }},
    {"fades", [](SceneDraft& d) { d.scene.fades.emplace_back(); },
     [](const Scene& s) { return s.fades.size(); }},
    {"captions", [](SceneDraft& d) { d.scene.captions.emplace_back(); },
     [](const Scene& s) { return s.captions.size(); }},
    {"chapters", [](SceneDraft& d) { d.scene.chapters.emplace_back(); },
     [](const Scene& s) { return s.chapters.size(); }},
    {"stops", [](SceneDraft& d) { d.scene.stops.emplace_back(); },
     [](const Scene& s) { return s.stops.size(); }},
};

}  // namespace

std::string SceneKey::expectation() const {
    return fmt::format("{}, as in {} = {}", type.words(), leaf(), example);
}

std::string_view SceneKey::default_text() const {
    const bool says_nothing = initial == "\"\"" || initial == "[]";
    return has_no_default || says_nothing || !default_words.empty() ? std::string_view() : initial;
}

std::string SceneKey::explanation() const {
    std::string text = fmt::format("{}; {}", type.words(), summary);
    if (!default_words.empty()) return fmt::format("{}; default: {}", text, default_words);
    if (default_text().empty()) return text;
    return fmt::format("{}; default {}", text, plain(default_text()));
}

std::string SceneKey::write(const Scene& scene, std::size_t item) const {
    std::string text = value(scene, item);
    return omits_initial && text == initial ? std::string() : text;
}

std::span<const SceneKey> scene_keys() {
    static const std::vector<SceneKey> table = all_sections();
    return table;
}

std::span<const SceneArray> scene_arrays() { return arrays; }

}  // namespace poinsot
