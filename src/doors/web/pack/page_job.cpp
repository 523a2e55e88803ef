#include "web/pack/page_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "encoding/palette.h"
#include "error/error.h"
#include "image/alpha.h"
#include "image/png.h"
#include "production/session/still_moment.h"
#include "production/stills/output_place.h"
#include "production/vectors/vector_still.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "text/printable.h"
#include "web/pack/html_page.h"
#include "web/pack/page_parts.h"

namespace poinsot {

namespace {

// A page is sent by mail and uploaded to course pages.
constexpr std::size_t most_page_bytes = 1'200'000;

// Widths of the poster, of which the first is taken that is not larger than this, nor than what the
// rest of the page leaves.
constexpr int poster_widths_px[] = {960, 640, 480, 320, 240, 160};
constexpr std::size_t most_poster_bytes = 32'000;

// The scene as the page will read it, with the files that it names.
Scene read_again(const SceneRequest& request, PageContents& contents) {
    contents.scene_text = text_of(request);
    const SceneFiles on_disk = files_of_folder(request.outside);
    const SceneFiles kept = [&](const NamedFile& file) {
        FileBytes found = on_disk(file);
        contents.files[file.name] = found.bytes;
        return found;
    };
    return parse_scene(contents.scene_text, request.file, request.overrides, kept);
}

// A picture of the scene at the instant of its still.
std::vector<std::uint8_t> still_png(const SceneRequest& request, PageContents& contents,
                                    LazyRenderer& renderer, int width_px,
                                    const std::vector<Override>& changes = {}) {
    SceneRequest small = request;
    small.overrides.insert(small.overrides.end(), changes.begin(), changes.end());
    const int height_px =
        std::max(1, static_cast<int>(std::lround(static_cast<double>(width_px) *
                                                 contents.height_px / contents.width_px)));
    small.overrides.push_back({"film.size", fmt::format("{}x{}", width_px, height_px)});
    const Session session = open_session(small);
    const FilmTime moment = still_moment(session, {}, StillTime::of_scene);
    // The herpolhode and other histories begin with the film, as in a still.
    const double start_s = std::min(film_plan(session).start_s, moment.time_s);
    PictureMaker pictures(session, renderer, {start_s, moment.time_s, moment.time_s});
    Image image;
    pictures.draw(moment, image);
    contents.poster_at_s = moment.film_s;
    contents.ground = hex_text(session.theme.background.bottom);
    PngOptions png;
    png.deflate_level = 12;
    if (!is_opaque(image)) return encode_png(image, png);
    // A third of the size: the poster is seen until the page draws.
    ColourCount colours;
    colours.add(image);
    return encode_palette_png(image, palette_for(colours, 256));
}

// All but the poster.
PageContents contents_of(const SceneRequest& request) {
    PageContents contents;
    const Scene scene = read_again(request, contents);
    contents.scene_name = scene.name;
    contents.title = title_of(scene);
    contents.language = scene.language;
    for (const Override& given : request.overrides)
        contents.overrides.push_back(given.assignment());
    contents.controls = controls_of(scene);
    contents.width_px = scene.film.width_px;
    contents.height_px = scene.film.height_px;
    contents.n_stops = scene.stops.size();
    contents.planned_s = scene.page.planned_s.value_or(0.0);
    contents.next = scene.page.next;
    return contents;
}

// The scenes whose pages follow, from page to page, where they lie beside this scene: in one page,
// full screen, notes and keys go on.
std::vector<PageContents> following(const SceneRequest& request, std::string next) {
    std::vector<PageContents> scenes;
    std::set<std::filesystem::path> seen{std::filesystem::path(request.file).filename()};
    std::error_code unknown;
    while (!next.empty()) {
        const std::filesystem::path name = std::filesystem::path(next).replace_extension(".toml");
        SceneRequest here;
        here.file = (std::filesystem::path(request.file).parent_path() / name).string();
        here.outside = request.outside;
        if (!seen.insert(name).second || !std::filesystem::is_regular_file(here.file, unknown))
            break;
        scenes.push_back(contents_of(here));
        next = scenes.back().next;
    }
    return scenes;
}

GalleryScene gallery_scene(const SceneRequest& request, PageContents& contents,
                           LazyRenderer& renderer) {
    return {contents.scene_name, contents.title, contents.scene_text, contents.files,
            still_png(request, contents, renderer, thumbnail_px, thumbnail_overrides())};
}

void need_module() {
    if (!page_module_lzma().empty()) return;
    throw EnvironmentError(
        "this program was built without its module for browsers, so it cannot write .html; run "
        "`sh .ci/setup page` in its sources, or install clang-19, lld-19, llvm-19, "
        "libc++-19-dev-wasm32, libc++abi-19-dev-wasm32, wasi-libc, libclang-rt-19-dev-wasm32, "
        "libstb-dev, binaryen and xz-utils and build it again");
}

}  // namespace

std::vector<Override> thumbnail_overrides() {
    return {{"overlays", "false"}, {"labels", "false"}, {"type_scale", "0.25"}};
}

void write_page(const SceneRequest& request, const std::string& output, LazyRenderer& renderer,
                const Task& task) {
    need_module();
    const Session session = open_session(request, task);
    tell_notes(session, task);
    const OutputPlace place(output, session.scene, ".html");
    PageContents contents = contents_of(request);
    contents.following = following(request, contents.next);
    std::string page;
    for (const int width_px : poster_widths_px) {
        contents.poster_png = still_png(request, contents, renderer, width_px);
        if (contents.poster_png.size() > most_poster_bytes) continue;
        page = html_page(contents);
        if (page.size() <= most_page_bytes) break;
    }
    if (page.empty()) page = html_page(contents);
    write_whole(place.path(), page);
    const std::string name = printable(place.path().string());
    task.say(fmt::format("{}\n{:.2f} MB", name, 1e-6 * static_cast<double>(page.size())));
    // The page that the last of its scenes leads to.
    const std::string& next =
        contents.following.empty() ? contents.next : contents.following.back().next;
    std::error_code unknown;
    if (!next.empty() && !std::filesystem::exists(place.path().parent_path() / next, unknown))
        task.say(
            fmt::format("note: at its end the page leads to {}, which is not in its "
                        "folder; make that page, too, or leave it out by --set "
                        "'page.next=\"\"'",
                        printable(next)));
    std::size_t n_file_bytes = 0;
    for (const auto& file : contents.files) n_file_bytes += file.second.size();
    if (page.size() > most_page_bytes)
        task.say(fmt::format(
            "note: {} is larger than 1.2 MB; the files that the scene names take {:.2f} MB", name,
            4e-6 / 3.0 * static_cast<double>(n_file_bytes)));
}

void write_workbench(const WorkbenchRequest& request, const std::string& output,
                     LazyRenderer& renderer) {
    need_module();
    check_aside(output);
    WorkbenchScenes scenes;
    std::optional<PageContents> first;
    for (const SceneRequest& scene : request.scenes) {
        PageContents contents = contents_of(scene);
        scenes.gallery.push_back(gallery_scene(scene, contents, renderer));
        if (!first) {
            contents.poster_png = still_png(scene, contents, renderer, poster_widths_px[1]);
            first = std::move(contents);
        }
    }
    for (const SceneRequest& scene : request.starts) {
        PageContents contents = contents_of(scene);
        scenes.starts.push_back(gallery_scene(scene, contents, renderer));
    }
    if (!first) throw InputError("a workbench needs a scene; name one");
    first->title = "poinsot";
    write_whole(output, html_workbench(*first, scenes, read_text(request.schema_file)));
}

}  // namespace poinsot
