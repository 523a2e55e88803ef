// The functions of records that need files, FFmpeg or the processor, which a page in a browser does
// not have.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "drawing/stage/stage_store.h"
#include "encoding/film_metadata.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "production/records/page_text.h"
#include "production/records/record.h"
#include "scene/files/load_scene.h"
#include "scene/scene_error.h"
#include "scene/toml/toml_document.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/files/processor.h"
#include "system/run_program.h"
#include "system/sha256.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Mesa's version from "4.5 (Core Profile) Mesa 22.3.6".
std::string mesa_version(const std::string& gl_version) {
    const std::size_t at = gl_version.find("Mesa ");
    if (at == std::string::npos) return gl_version;
    const std::string rest = gl_version.substr(at + 5);
    return rest.substr(0, rest.find(' '));
}

}  // namespace

std::string fonts_in_words(const Stage& stage) {
    std::string text;
    for (const auto& file : stage.store().text().typesetter().fallbacks_used()) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", file.filename().string(),
                            sha256_of(read_text(file)));
    }
    return text;
}

void record_context(const ContextInfo& context, bool portable, Record& record) {
    record.portable = portable;
    if (!portable) record.processor = processor_capabilities();
    record.renderer = context.renderer;
    record.mesa = mesa_version(context.version);
}

namespace {

// Presentations and pages, which are made of films or of a scene, have no record of their own.
void refuse_what_holds_others(const std::filesystem::path& file) {
    if (kind_of_file(file) != FileKind::regular) return;
    if (is_slides_name(file))
        throw InputError(fmt::format(
            "{}: is a presentation; each of its films has a record: unpack it, as a ZIP archive, "
            "and give a film of its folder ppt/media",
            printable(file.string())));
    if (suffix_of(file) == ".toml")
        throw InputError(fmt::format(
            "{}: is a scene or another text, not a picture or film; see `poinsot check {}` "
            "for a scene",
            printable(file.string()), printable(shell_word(file.string()))));
    if (is_page_name(file))
        throw InputError(fmt::format(
            "{}: is a page for browsers, which has no record; give a picture, a film or a figure",
            printable(file.string())));
}

}  // namespace

std::string record_text(const std::filesystem::path& file) {
    if (is_vector_name(file)) return read_vector_text(file).text;
    if (suffix_of(file) == ".png") return read_png_info(file).texts[metadata_name];
    return film_metadata(file);
}

Record read_record(const std::filesystem::path& file) {
    refuse_what_holds_others(file);
    const std::string text = record_text(file);
    if (text.empty())
        throw InputError(
            fmt::format("{}: has no record of how it was made: poinsot did not draw it, or another "
                        "program removed the record; draw it with poinsot",
                        printable(file.string())));
    return parse_record(text, file.string());
}

Scene scene_of(const Record& record, OutsideFiles outside) {
    try {
        Scene scene = parse_scene(record.scene_toml, record.scene_name + ".toml", {},
                                  files_of_folder(outside));
        // They were reported when the file was made.
        scene.notes.clear();
        return scene;
    } catch (const SceneFileError&) {
        throw;
    } catch (const SceneError& error) {
        throw InputError(fmt::format("its scene cannot be read again: {}", error.what()));
    }
}

std::string fault_of_scene(const Record& record) {
    try {
        scene_of(record, OutsideFiles::refused);
    } catch (const SceneFileError&) {
        // A missing file is not an error of the scene's text.
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::optional<std::int64_t> frame_of_name(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    const auto last_other = std::find_if(stem.rbegin(), stem.rend(),
                                         [](unsigned char c) { return std::isdigit(c) == 0; });
    return number_of<std::int64_t>(std::string(last_other.base(), stem.end()));
}

}  // namespace poinsot
