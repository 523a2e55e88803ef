// What every picture and film says of itself: how it was made, and the scene as resolved. One text
// in the file's metadata, readable without poinsot, enough to make the same bytes again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "production/picture.h"
#include "production/session.h"

namespace poinsot {

struct Record {
    std::string version;     // of poinsot
    std::string scene_name;  // the scene file's stem
    std::string scene_hash;  // SHA-256 of scene_toml, mesh_hash after it
    std::string mesh_hash;   // SHA-256 of what came from a mesh file; empty without one
    std::string method;      // of the motion
    std::string bounds;      // what was promised of motion and picture
    bool portable = false;   // profile
    std::string renderer;    // GL_RENDERER
    std::string mesa;        // version of Mesa, or all of GL_VERSION where that names none
    int width_px = 0, height_px = 0;
    std::optional<double> time_s;                                 // of a still
    std::optional<double> dpi, type_pt;                           // of one for print
    int bit_depth = 8;                                            // of a still
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // of a film, inclusive
    std::string scene_toml;                                       // every key, defaults included

    bool operator==(const Record&) const = default;
};

// SHA-256 of the surfaces and the inertia that a scene has from a mesh file; empty without one.
std::string mesh_hash_of(const Scene& scene);

// The record of pictures of a session, without time or frames.
Record record_of(const Session& session, const PictureMaker& pictures, bool portable);

// "poinsot VERSION", a line "key: value" each, an empty line, the scene.
std::string to_text(const Record& record);

// Reads such a text; unknown keys are passed over. `name` stands in messages. Throws InputError for
// what is not a record, and for a scene that is not the one its hash names.
Record parse_record(std::string_view text, const std::string& name);

// The record that a PNG or film carries. Throws InputError if the file cannot be read or carries
// none.
Record read_record(const std::filesystem::path& file);

}  // namespace poinsot
