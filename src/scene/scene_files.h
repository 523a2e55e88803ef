// The files that a scene names. Who reads a scene says where their bytes come from: the scene's
// folder (scene/files/), or memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace poinsot {

// The largest file of a picture on a face.
constexpr std::uintmax_t most_face_picture_bytes = std::uintmax_t{128} << 20;

// A file that a key of the scene names.
struct NamedFile {
    enum class Kind { mesh, picture, theme };
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

}  // namespace poinsot
