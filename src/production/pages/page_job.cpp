#include "production/pages/page_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "error/error.h"
#include "image/png.h"
#include "production/jobs/output_place.h"
#include "production/pages/html_page.h"
#include "production/pages/page_parts.h"
#include "production/session/still_moment.h"
#include "production/vectors/vector_still.h"
#include "system/files/atomic_file.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// A page is sent by mail and uploaded to course pages.
constexpr std::size_t most_page_bytes = 1'200'000;

// Widths of the poster, of which the first that leaves room for the rest is taken.
constexpr int poster_widths_px[] = {1280, 960, 720, 480};
constexpr std::size_t most_poster_bytes = 130'000;

std::string hex(const Colour& colour) {
    const auto level = [](double share) {
        return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", level(colour.r), level(colour.g), level(colour.b));
}

// The scene as the page will read it, with the files that it names.
Scene read_again(const SceneRequest& request, PageContents& contents) {
    contents.scene_text = text_of_file(request.file);
    const SceneFiles on_disk = files_of_folder(request.outside);
    const SceneFiles kept = [&](const NamedFile& file) {
        FileBytes found = on_disk(file);
        contents.files[file.name] = found.bytes;
        return found;
    };
    return parse_scene(contents.scene_text, request.file, request.overrides, kept);
}

void add_poster(const SceneRequest& request, PageContents& contents, LazyRenderer& renderer) {
    for (const int width_px : poster_widths_px) {
        SceneRequest of_poster = request;
        const int height_px =
            std::max(1, static_cast<int>(std::lround(static_cast<double>(width_px) *
                                                     contents.height_px / contents.width_px)));
        of_poster.overrides.push_back(fmt::format("film.size={}x{}", width_px, height_px));
        const Session session = open_session(of_poster);
        const FilmTime moment = still_moment(session, {}, StillTime::of_scene);
        PictureMaker pictures(session, renderer, {moment.time_s, moment.time_s});
        Image image;
        pictures.draw(moment, image);
        PngOptions png;
        png.deflate_level = 12;
        contents.poster_png = encode_png(image, png);
        contents.poster_at_s = moment.film_s;
        contents.ground = hex(session.theme.background.bottom);
        if (contents.poster_png.size() <= most_poster_bytes) return;
    }
}

}  // namespace

void write_page(const SceneRequest& request, const std::string& output, LazyRenderer& renderer,
                const ProgressSink& progress) {
    if (page_module_gzip().empty())
        throw EnvironmentError(
            "this program was built without its module for browsers, so it cannot write .html; "
            "install clang-19, lld-19, libc++-19-dev-wasm32, libc++abi-19-dev-wasm32, wasi-libc, "
            "libclang-rt-19-dev-wasm32 and binaryen, and build it again");
    const Session session = open_session(request, progress);
    tell_notes(session, progress);
    PageContents contents;
    const Scene scene = read_again(request, contents);
    contents.scene_name = scene.name;
    contents.title = title_of(scene);
    contents.language = scene.language;
    contents.overrides = request.overrides;
    contents.controls = scene.page.controls;
    contents.width_px = scene.film.width_px;
    contents.height_px = scene.film.height_px;
    add_poster(request, contents, renderer);

    const OutputPlace place(output, scene, ".html");
    const std::string page = html_page(contents);
    write_whole(place.path(), page);
    const std::string name = printable(place.path().string());
    progress.say(fmt::format("{}\n{:.2f} MB", name, 1e-6 * static_cast<double>(page.size())));
    if (page.size() > most_page_bytes)
        progress.say(fmt::format(
            "note: {} is larger than 1.2 MB, because of the files that the scene names ({:.2f} MB)",
            name, [&] {
                double bytes = 0.0;
                for (const auto& file : contents.files)
                    bytes += static_cast<double>(file.second.size());
                return 1e-6 * bytes;
            }()));
}

}  // namespace poinsot
