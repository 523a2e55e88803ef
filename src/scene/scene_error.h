// What is thrown for a scene that cannot be used: an InputError that knows where it stands.
#pragma once

#include <string>
#include <string_view>

#include "error/error.h"
#include "scene/scene.h"
#include "text/printable.h"

namespace poinsot {

// "file:line:column: what is wrong; what to do".
class SceneError : public InputError {
 public:
    SceneError(SourceLocation where, std::string_view what_and_remedy)
        : InputError(where.prefix() + std::string(what_and_remedy)), where_(std::move(where)) {}

    const SourceLocation& where() const { return where_; }

 private:
    SourceLocation where_;
};

// What is thrown where a file that a scene names cannot be used: the scene itself may be right.
class SceneFileError : public SceneError {
 public:
    using SceneError::SceneError;
};

// Calls what may throw an InputError without a place: what it refuses is wrong at this key.
template <typename Call>
decltype(auto) at_scene_key(const Scene& scene, const std::string& key, Call call) {
    try {
        return call();
    } catch (const SceneError&) {
        throw;
    } catch (const InputError& error) {
        throw SceneError(scene.location_of(key), error.what());
    }
}

// The same where a file is read that the key names.
template <typename Call>
decltype(auto) at_file_key(const Scene& scene, const std::string& key, Call call) {
    try {
        return call();
    } catch (const SceneFileError&) {
        throw;
    } catch (const InputError& error) {
        throw SceneFileError(scene.location_of(key), error.what());
    }
}

}  // namespace poinsot
