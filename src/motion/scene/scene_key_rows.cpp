#include "scene/scene_key_rows.h"

#include <utility>

#include "scene/scene_error.h"

namespace poinsot {

const SceneDraft& draft_by_default() {
    static const SceneDraft draft = [] {
        SceneDraft grown;
        for (const SceneArray& array : scene_arrays()) array.grow(grown);
        grown.scene.body.masses_as_given = grown.masses;
        return grown;
    }();
    return draft;
}

SceneKey&& SceneKey::without_default() && {
    has_no_default = true;
    omits_initial = false;
    return std::move(*this);
}

SceneKey&& SceneKey::or_text(std::string_view words, std::string_view pattern) && {
    type.or_text = words;
    type.or_pattern = pattern;
    return std::move(*this);
}

SceneKey&& SceneKey::checked_by(std::function<void(const std::string&)> check) && {
    read = [check = std::move(check), store = std::move(read)](const GivenValue& given,
                                                               SceneDraft& draft) {
        try {
            check(given.text());
        } catch (const SceneError&) {
            throw;
        } catch (const InputError& error) {
            throw SceneError(given.value().where, error.what());
        }
        store(given, draft);
    };
    return std::move(*this);
}

SceneKey&& SceneKey::written_by(Writer writer) && {
    value = std::move(writer);
    if (initial.empty()) initial = value(draft_by_default().scene, 0);
    return std::move(*this);
}

SceneKey&& SceneKey::written_if(bool (*says)(const Scene&)) && {
    value = [says, written = std::move(value)](const Scene& scene, std::size_t item) {
        return says(scene) ? written(scene, item) : "";
    };
    return std::move(*this);
}

}  // namespace poinsot
