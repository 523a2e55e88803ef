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
    initial_goes_unsaid = false;
    return std::move(*this);
}

SceneKey&& SceneKey::default_is(std::string_view words) && {
    otherwise = words;
    return std::move(*this);
}

SceneKey&& SceneKey::unsaid_by_default() && {
    initial_goes_unsaid = true;
    return std::move(*this);
}

SceneKey&& SceneKey::said_if_empty() && {
    initial_goes_unsaid = false;
    return std::move(*this);
}

SceneKey&& SceneKey::or_text(std::string_view words, std::string_view pattern) && {
    type.or_text = words;
    type.or_pattern = pattern;
    return std::move(*this);
}

SceneKey&& SceneKey::from_list(std::string_view list) && {
    type.list = list;
    return std::move(*this);
}

SceneKey&& SceneKey::values_named(std::string_view names) && {
    type.names_of_values = names;
    return std::move(*this);
}

SceneKey&& SceneKey::with_size(std::size_t least, std::size_t most) && {
    type.size = {least, most};
    return std::move(*this);
}

SceneKey&& SceneKey::read_by(std::function<void(const GivenValue&, SceneDraft&)> reader) && {
    read = std::move(reader);
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

SceneKey&& SceneKey::written_by(std::function<std::string(const Scene&, std::size_t)> writer) && {
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
