// The record in the metadata of every picture and film: how it was made, and the resolved scene. A
// text that is readable without poinsot and sufficient to make a byte-identical file again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "drawing/stage/stage.h"
#include "encoding/frame_sink.h"
#include "production/session/session.h"
#include "render/context/offscreen_context.h"
#include "scene/files/load_scene.h"

namespace poinsot {

// In Record::names: names fade as in the film.
inline constexpr std::string_view fading_names = "fading";

struct Record {
    std::string version;     // of poinsot
    std::string scene_name;  // the scene file's stem
    std::string scene_hash;  // SHA-256 of scene_toml, followed by mesh_hash
    std::string mesh_hash;   // SHA-256 of data from files that the scene names; empty without any
    std::string method;      // of the motion
    std::string bounds;      // promised bounds of the errors of motion and picture
    bool portable = false;   // profile
    std::string processor;   // its features, for a native profile; see system/files/processor.h
    std::string renderer;    // GL_RENDERER
    std::string maker;       // of a film made in a browser: which one, and its encoder
    std::string mesa;        // version of Mesa, or all of GL_VERSION if it names none
    std::string fonts;       // system fonts used as fallback: "NAME SHA-256, …"; usually empty
    int width_px = 0, height_px = 0;
    std::optional<double> time_s;                                 // of a still
    std::optional<double> dpi, type_pt;                           // of one for print
    int bit_depth = 8;                                            // of a still
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // of a film, inclusive
    // Of a recovered film: the frames of the interrupted run, whose packets it contains.
    std::optional<std::pair<std::int64_t, std::int64_t>> run;
    std::optional<std::int64_t> frame;  // of a picture of a sequence; `frames` are the sequence's
    // Of slides: the number of frames of the whole film. `frame` is the number of a still's frame.
    // The first and last frames of a slide's film are encoded independently of the others.
    std::optional<std::int64_t> film_frames;
    std::string
        names;  // of a still that is a frame of the film: fading_names; empty: whole or absent
    std::string pixels;     // of a picture, hash; see image/pixels_xxh64.h
    std::string packets;    // of a film, hash; see output/film_packets.h
    std::string file;       // of a film, hash; see output/film_file_hash.h; a GIF needs none
    std::string page;       // of vectors, hash; see production/vectors/vector_still.h
    std::string shading;    // likewise: style of surfaces
    std::string lettering;  // likewise: representation of text; empty: fonts
    std::string journal;    // of a still for print: whose limits it follows
    std::string
        sheet;  // of a contact sheet: "2x1: fps = 30; fps = 60"; other fields are the first cell's
    bool sealed = false;     // it was read and its hash is correct
    std::string as_read;     // values of the scene file that others replaced; see ResolvedScene
    std::string scene_toml;  // as it is drawn: every key, defaults included
    std::string text;        // of a record that was read: all of it

    bool operator==(const Record&) const = default;
};

// SHA-256 of the surfaces and the inertia from a scene's mesh file, of its faces' pictures, and of
// the rows of its measured motion; empty without any.
std::string mesh_hash_of(const Scene& scene);
// The record's scene_hash: of the complete text of the scene, and of the contents of its files.
std::string scene_hash_of(const Scene& scene);

// The record of a stage, without time or frames and without the renderer.
Record record_of(const Session& session, const Stage& stage, const std::string& bounds);

// The fonts used as fallback for the program's own fonts, each with its name and hash. Of a page in
// a browser: none.
std::string fonts_in_words(const Stage& stage);

// Sets the fields of the renderer.
void record_context(const ContextInfo& context, bool portable, Record& record);
// The same for vectors without pixels, which do not depend on a renderer.
inline constexpr std::string_view vectors_renderer = "vectors";
void record_without_context(Record& record);

// "poinsot VERSION", one line "key: value" per field, an empty line, the scene.
std::string to_text(const Record& record);

// The same with a last line before the empty one: the hash (SHA-256) of all other lines. It detects
// accidental changes, not forgery: anyone can recompute the hash of a changed record.
std::string sealed_text(const Record& record);

// The sealed text of a file with known contents, completed from the metadata of its plan.
std::string sealed_metadata(const std::string& metadata, const EncodedMetadata& contents);

// Reads such texts; unknown keys are ignored. `name` is used in messages. Throws InputError for a
// text that is not a record, and if the record's or the scene's hash does not match.
Record parse_record(std::string_view text, const std::string& name);

// The text of the record in a picture, a page or a film; empty if it has none. Throws InputError if
// the file cannot be read.
std::string record_text(const std::filesystem::path& file);

// The record itself. Throws InputError also for a file without one.
Record read_record(const std::filesystem::path& file);

// The record's scene, parsed as a file of its name in this folder. Throws InputError if the text is
// not a scene of this program, SceneFileError if a file that it names cannot be used.
Scene scene_of(const Record& record, OutsideFiles outside);

// Why the scene's text is not a scene of this program, in one line; empty if it is, whether or not
// the files that it names exist.
std::string fault_of_scene(const Record& record);

// The number at the end of a sequence's file name: 7 for "turn_0007.png".
std::optional<std::int64_t> frame_of_name(const std::filesystem::path& file);

}  // namespace poinsot
