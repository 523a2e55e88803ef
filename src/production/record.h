// What every picture and film says of itself: how it was made, and the scene as resolved. One text
// in the file's metadata, readable without poinsot, enough to make the same bytes again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "output/frame_sink.h"
#include "production/picture.h"
#include "production/session.h"

namespace poinsot {

struct Record {
    std::string version;     // of poinsot
    std::string scene_name;  // the scene file's stem
    std::string scene_hash;  // SHA-256 of scene_toml, mesh_hash after it
    std::string mesh_hash;   // SHA-256 of what came from meshes and pictures; empty without any
    std::string method;      // of the motion
    std::string bounds;      // what was promised of motion and picture
    bool portable = false;   // profile
    std::string processor;   // what it can do, of a native profile; see system/processor.h
    std::string renderer;    // GL_RENDERER
    std::string mesa;        // version of Mesa, or all of GL_VERSION where that names none
    std::string fonts;  // of the system, that stood in for ours: "NAME SHA-256, …"; most often none
    int width_px = 0, height_px = 0;
    std::optional<double> time_s;                                 // of a still
    std::optional<double> dpi, type_pt;                           // of one for print
    int bit_depth = 8;                                            // of a still
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // of a film, inclusive
    // Of a film that was recovered: the frames of the run that was interrupted, whose histories its
    // pictures show and whose packets it has.
    std::optional<std::pair<std::int64_t, std::int64_t>> run;
    std::optional<std::int64_t> frame;  // of a picture of a sequence, whose frames those are
    std::string pixels;                 // of a picture, hash; see image/pixel_check.h
    std::string packets;                // of a film, hash; see output/film_packets.h
    std::string page;                   // of vectors, hash; see production/vectors/vector_still.h
    std::string shading;                // likewise: how surfaces are filled
    std::string lettering;              // likewise: what type is; empty: fonts
    std::string journal;                // of a still for print, whose sizes it keeps
    std::string
        sheet;  // of many pictures in one: "2x1: fps = 30; fps = 60"; all else is the first's
    bool sealed = false;     // it was read with a hash of all of it, which fits
    std::string scene_toml;  // every key, defaults included
    std::string text;        // of one that was read, all of it

    bool operator==(const Record&) const = default;
};

// SHA-256 of the surfaces and the inertia that a scene has from a mesh file, and of its faces'
// pictures; empty without any.
std::string mesh_hash_of(const Scene& scene);
// The record's scene_hash: of the scene, written out in full, and of what it has from files.
std::string scene_hash_of(const Scene& scene);

// The record of what a stage shows, without time or frames and without what drew it.
Record record_of(const Session& session, const Stage& stage, const std::string& bounds);

// Puts in what drew the pixels.
void record_context(const ContextInfo& context, bool portable, Record& record);
// The same of vectors without pixels, which no renderer but this program has a part in.
void record_without_context(Record& record);

// The record of pictures of a session, without time or frames.
Record record_of(const Session& session, const PictureMaker& pictures, bool portable);

// "poinsot VERSION", a line "key: value" each, an empty line, the scene.
std::string to_text(const Record& record);

// The same with a last line before the empty one: the hash (SHA-256) of all the others. It tells
// what was changed by mistake, not what was forged: whoever changes a record can hash it again.
std::string sealed_text(const Record& record);

// The text of a file whose contents are known, sealed, from that which its plan carries.
std::string told(const std::string& metadata, const Contents& contents);

// Reads such texts; unknown keys are passed over. `name` stands in messages. Throws InputError for
// what is not a record, and for one that is not as its hash, or that of its scene, says.
Record parse_record(std::string_view text, const std::string& name);

// The record that a picture, a page or a film carries. Throws InputError if the file cannot be read
// or carries none.
Record read_record(const std::filesystem::path& file);

// Its scene, read as a file of its name in this folder would be. Throws InputError where the text
// is no scene of this program, SceneFileError where a file that it names cannot be used.
Scene scene_of(const Record& record, OutsideFiles outside);

// Why that text is no scene of this program, in a line; empty where it is one, whether the files
// that it names are here or not.
std::string fault_of_scene(const Record& record);

// Whether a file's pixels, or packets, are those that its record was written with, and nothing was
// appended to it.
enum class Verified { yes, no, cannot_be };
struct Verification {
    Verified verified = Verified::cannot_be;
    std::string sentence;  // about the file, one line
};

// Reads all of the file. Throws InputError if it cannot be read.
Verification verify(const std::filesystem::path& file, const Record& record);

// Whether that takes no longer than a glance.
bool is_quickly_verified(const std::filesystem::path& file, const Record& record);

// The number that ends a sequence's file name: 7 of "turn_0007.png".
std::optional<std::int64_t> frame_of_name(const std::filesystem::path& file);

}  // namespace poinsot
