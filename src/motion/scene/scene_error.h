// The errors of a scene that cannot be used: an InputError with the place of the cause.
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
        : InputError({where.file, where.line, where.column},
                     where.prefix() + std::string(what_and_remedy)),
          where_(std::move(where)) {}

    const SourceLocation& where() const { return where_; }

 private:
    SourceLocation where_;
};

// The error of a file that a scene names and that cannot be used; the scene itself may be valid.
class SceneFileError : public SceneError {
 public:
    using SceneError::SceneError;
};

// Calls a function and turns an InputError without a place into a SceneError at this key.
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

// The same for a function that reads the file which the key names.
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
