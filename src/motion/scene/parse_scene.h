// Reads a scene: TOML → Scene, with the place of each error. Who reads a scene says where the bytes
// of the files that it names come from: the scene's folder (scene/files/), or memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "scene/override.h"
#include "scene/scene.h"

namespace poinsot {

// The largest file of a picture on a face.
constexpr std::uintmax_t most_face_picture_bytes = std::uintmax_t{128} << 20;
// The largest table of a measured motion: some 200,000 rows.
constexpr std::size_t most_table_bytes = std::size_t{16} << 20;

// A file that a key of the scene names.
struct NamedFile {
    enum class Kind { mesh, picture, theme, table };
    Kind kind = Kind::mesh;
    std::string key;                   // "body.mesh"
    std::string name;                  // as given
    bool is_of_command_line = false;   // given by --set or its like
    std::filesystem::path scene_file;  // of the scene that names it
};

struct FileBytes {
    std::string name;  // for messages
    std::string bytes;
};

// Returns the bytes of a file, or throws InputError.
using SceneFiles = std::function<FileBytes(const NamedFile& file)>;

// For a scene without files: throws InputError.
FileBytes no_scene_file(const NamedFile& file);

// Reads a scene from text; `file_name` is used in messages, for the scene's name and for its
// folder. The overrides replace values of the text, in order; a value that is not TOML is taken as
// a text. `files` gives the bytes of the files that the scene names. Throws SceneError.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const Override> overrides = {},
                  const SceneFiles& files = no_scene_file);

}  // namespace poinsot
