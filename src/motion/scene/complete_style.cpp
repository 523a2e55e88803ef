// Theme files: the theme's values are merged below the scene's own, so that the scene holds all of
// them.
#include <fmt/format.h>

#include "scene/draft_checks.h"
#include "scene/given_value.h"
#include "scene/scene_key_rows.h"
#include "scene/toml/toml_document.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Passes every entry of the file to its row of [style], except `extends`.
void read_theme(const TomlValue& root, SceneDraft& theme) {
    static const SceneKey extends =
        key_rows::text("extends", &Scene::theme, R"("dark")", "the theme that it changes");
    for (const TomlEntry& entry : root.entries) {
        if (entry.key == "style")
            throw SceneError(entry.where,
                             "[style] belongs to scenes; in a theme file its keys stand at the top "
                             "level, so remove this heading and put them before any other");
        const bool is_extends = entry.key == extends.leaf();
        const std::string path = is_extends ? "theme" : "style." + entry.key;
        const SceneKey* key = is_extends ? &extends : find_scene_key(path);
        if (key == nullptr || entry.key.find('.') != std::string::npos)
            throw SceneError(entry.where,
                             fmt::format("unknown key \"{}\" in a theme{}", printable(entry.key),
                                         scene_key_remedy(path, true)));
        theme.scene.locations[path] = entry.where;
        key->read(GivenValue(*key, entry.key, 0, entry.value), theme);
    }
}

}  // namespace

void complete_style(SceneDraft& draft) {
    Scene& scene = draft.scene;
    if (!scene.theme.ends_with(".toml")) return;
    const FileBytes file = file_named(draft, NamedFile::Kind::theme, "theme", scene.theme);
    SceneDraft theme;
    theme.scene.theme = "light";
    read_theme(parse_toml(file.bytes, file.name), theme);

    // The scene's own values take precedence.
    StyleSpec& below = theme.scene.style;
    for (const auto& [name, look] : scene.style.looks) {
        LookSpec& under = below.looks[name];
        if (look.srgb) under.srgb = look.srgb;
        if (look.weight) under.weight = look.weight;
        if (look.opacity_percent) under.opacity_percent = look.opacity_percent;
        if (!look.line.empty()) under.line = look.line;
    }
    for (const auto scale :
         {&StyleSpec::title_scale, &StyleSpec::caption_scale, &StyleSpec::heading_scale,
          &StyleSpec::label_scale, &StyleSpec::chart_scale})
        if (scene.style.*scale) below.*scale = scene.style.*scale;
    scene.style = std::move(below);
    scene.theme = theme.scene.theme;
    for (const auto& [key, where] : theme.scene.locations)
        if (key == "theme" || !draft.has(key)) scene.locations[key] = where;
}

}  // namespace poinsot
