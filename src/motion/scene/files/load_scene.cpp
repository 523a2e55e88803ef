#include "scene/files/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

#include "bodies/files/mesh_file.h"
#include "image/files/png_files.h"
#include "scene/scene_error.h"
#include "scene/toml/toml_document.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_file(const fs::path& file, std::string_view what_and_remedy) {
    throw SceneError({file.string(), 0, 0}, what_and_remedy);
}

// "; did you mean "scenes/generic.toml"?", from the folder where the file was expected.
std::string near_file(const fs::path& file) {
    std::vector<std::string> names;
    std::error_code failed;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    constexpr std::size_t most_names = 1000;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().extension() != ".toml" || names.size() >= most_names) continue;
        names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view near = nearest_name(file.filename().string(), views);
    if (near.empty()) return "; name a scene file, see `poinsot list scenes`";
    return fmt::format("; did you mean \"{}\"?", printable((file.parent_path() / near).string()));
}

// The path of a file relative to the scene's folder. Throws InputError for a file outside that
// folder, also through a link, unless those are allowed.
fs::path path_of(const NamedFile& named, OutsideFiles outside) {
    const fs::path scene_folder = named.scene_file.parent_path();
    const fs::path folder = scene_folder.empty() ? fs::path(".") : scene_folder;
    fs::path file = folder / named.name;  // an absolute name is used as it is
    if (outside == OutsideFiles::allowed) return file;

    // Links are resolved before the location is checked.
    std::error_code failed;
    const fs::path true_folder = fs::weakly_canonical(folder, failed);
    const fs::path true_file = failed ? fs::path() : fs::weakly_canonical(file, failed);
    const auto [end_of_folder, rest] =
        std::mismatch(true_folder.begin(), true_folder.end(), true_file.begin(), true_file.end());
    if (failed || named.name.empty() || end_of_folder != true_folder.end() ||
        fs::path(named.name).is_absolute()) {
        throw InputError(
            fmt::format("{} = \"{}\" does not lie in the scene's folder; move it there, or give "
                        "--allow-outside if you trust the scene",
                        named.key, printable(named.name)));
    }
    return file;
}

// The bytes of a picture for a face of the body.
std::string bytes_of_picture(const fs::path& file, const std::string& name) {
    std::error_code failed;
    if (kind_of_file(file) == FileKind::regular &&
        fs::file_size(file, failed) > most_face_picture_bytes)
        throw InputError(fmt::format("{} is larger than {} MiB; make it smaller", printable(name),
                                     most_face_picture_bytes >> 20));
    try {
        const std::vector<std::uint8_t> bytes = bytes_of_png(file);
        return {bytes.begin(), bytes.end()};
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}; name a whole PNG picture", error.what()));
    }
}

// The bytes of a table; one more than is accepted, to detect a table that is too large.
std::string bytes_of_table(const fs::path& file) {
    const FileKind kind = kind_of_file(file);
    if (kind == FileKind::missing)
        throw InputError(
            fmt::format("{}: no such file; name a table of text (CSV)", printable(file.string())));
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", printable(file.string()), in_words(kind)));
    return read_beginning(file, most_table_bytes + 1);
}

FileBytes read(const NamedFile& named, OutsideFiles outside) {
    // A theme named on the command line is looked for in the current folder first.
    std::error_code failed;
    const bool is_here = named.kind == NamedFile::Kind::theme && named.is_of_command_line &&
                         fs::exists(named.name, failed);
    const fs::path file = is_here ? fs::path(named.name) : path_of(named, outside);
    switch (named.kind) {
        case NamedFile::Kind::mesh:
            return {file.string(), bytes_of_mesh_file(file)};
        case NamedFile::Kind::picture:
            return {file.string(), bytes_of_picture(file, named.name)};
        case NamedFile::Kind::table:
            return {file.string(), bytes_of_table(file)};
        case NamedFile::Kind::theme:
            break;
    }
    return {file.string(), text_of_file(file)};
}

}  // namespace

SceneFiles files_of_folder(OutsideFiles outside) {
    return [outside](const NamedFile& file) { return read(file, outside); };
}

std::string text_of_file(const fs::path& file) {
    const FileKind kind = kind_of_file(file);
    if (kind == FileKind::missing) refuse_file(file, "no such file" + near_file(file));
    if (kind == FileKind::folder) {
        refuse_file(file, "this is a folder; name a scene file in it, ending in .toml");
    }
    if (kind != FileKind::regular) refuse_file(file, in_words(kind));

    // Reads one byte more than is accepted, to detect a file that is too large.
    std::string text = read_beginning(file, most_scene_file_bytes + 1);
    if (text.size() > most_scene_file_bytes) {
        refuse_file(file, "larger than 1 MiB; a scene is a short text file, name that one");
    }
    return text;
}

Scene load_scene(const fs::path& file, std::span<const Override> overrides, OutsideFiles outside) {
    return parse_scene(text_of_file(file), file.string(), overrides, files_of_folder(outside));
}

}  // namespace poinsot
