#include "production/slides/slide_deck.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "error/error.h"
#include "production/slides/slide_files.h"
#include "production/slides/slide_plan.h"
#include "production/stills/prepared_still.h"
#include "production/vectors/vector_still.h"
#include "scene/scene_error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/interrupt.h"
#include "system/seal.h"
#include "text/markup.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

constexpr const char* slide_index_name = "index.html";

// Throws InputError for a folder that holds other files than those that an earlier slides.json of
// the same talk proves to be its own. Returns that list.
FileList check_folder(const fs::path& folder, const SlideOrigin& origin) {
    FileList list(folder / slide_plan_name);
    const std::string name = printable(folder.string());
    const FileKind kind = kind_of_file(folder);
    std::error_code error;
    if (kind == FileKind::missing && fs::is_symlink(folder, error))
        throw InputError(fmt::format(
            "{}: is a link to a folder that does not exist; make this folder, or remove the link",
            name));
    if (kind == FileKind::missing) return list;
    if (kind == FileKind::name_too_long || kind == FileKind::unreachable)
        throw InputError(fmt::format("{}: {}", name, in_words(kind)));
    if (kind != FileKind::folder)
        throw InputError(fmt::format("{}: exists and is not a folder; name a new folder", name));
    if (fs::equivalent(folder, fs::current_path(error), error))
        throw InputError(fmt::format(
            "{}: is the current folder; slides need a folder of their own, so name a new one",
            name));
    if (list.text().starts_with(any_slide_plan_head) && !lists_slides_of(origin, list.text()))
        throw InputError(fmt::format(
            "{}: holds the slides of another scene; name another folder, or remove this one",
            name));
    const auto refuse_edited = [&](const std::string& file) {
        throw InputError(fmt::format(
            "{}: {} is not as poinsot wrote it; move it away, or name a new or an empty "
            "folder",
            name, printable(file)));
    };
    if (list.text().empty() && fs::exists(fs::symlink_status(folder / slide_plan_name, error)))
        refuse_edited(slide_plan_name);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        if (list.proves(entry.path()) || (file == slide_plan_name && !list.text().empty()))
            continue;
        if (list.lists(file)) refuse_edited(file);
        throw InputError(
            fmt::format("{}: holds other files, such as {}; name a new or an empty folder", name,
                        printable(file)));
    }
    return list;
}

// A page that shows the still of each slide, which leads to its film; below it are the title and
// links to all films and to the PDF. Printed, it is an overview.
std::string slide_index(const Session& session, const FilmPlan& film,
                        const std::vector<Slide>& slides) {
    const std::string title = escaped_markup(title_of(session.scene));
    std::string items;
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const SlideFiles files = slide_files_of(session, film, slides[i], i);
        std::string links;
        for (const std::string& file : {files.film, files.loop, files.pdf})
            if (!file.empty()) links += fmt::format(R"( <a href="{0}">{0}</a>)", file);
        const std::string name = fmt::format("{}. {}", i + 1, escaped_markup(slides[i].title));
        items += fmt::format(
            R"(<li><a href="{}"><img src="{}" alt="{}" loading="lazy"></a><p>{}</p><p>{}</p></li>)"
            "\n",
            files.film, files.png, name, name, links.substr(1));
    }
    return fmt::format(R"(<!DOCTYPE html>
<html lang="{}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ margin: 2rem; font: 16px/1.4 system-ui, sans-serif; }}
ol {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); gap: 1.5rem; padding: 0; list-style: none; }}
li {{ break-inside: avoid; }}
img {{ width: 100%; }}
p {{ margin: .2rem 0; }}
</style>
</head>
<body>
<h1>{}</h1>
<ol>
{}</ol>
</body>
</html>
)",
                       escaped_markup(session.scene.language), title, title, items);
}

std::vector<FileHash> hashes_of(const SlidesAside& aside, const std::set<std::string>& names) {
    std::vector<FileHash> hashes;
    hashes.reserve(names.size());
    for (const std::string& name : names)
        hashes.push_back({name, sha256_of_file(aside.file(name))});
    return hashes;
}

// Gives these files to the folder, with slides.json. In an earlier deck each replaces the file of
// its name; files that only the earlier deck has are removed. At each moment, slides.json lists all
// files with their hashes.
void commit(const SlidesAside& aside, const fs::path& folder, const std::set<std::string>& files,
            const std::string& plan, const FileList& earlier) {
    const auto move = [](const fs::path& from, const fs::path& to) {
        std::error_code error;
        fs::rename(from, to, error);
        if (error) throw_write_error(to, error.value());
    };
    const std::vector<FileHash> hashes = hashes_of(aside, files);
    const std::string list = with_files(plan, hashes);
    aside.keep_only(files);
    if (kind_of_file(folder) == FileKind::missing) {
        write_whole(aside.file(slide_plan_name), list);
        return move(aside.path(), folder);
    }
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (earlier.proves(entry.path()) && !files.contains(entry.path().filename().string()))
            old.push_back(entry.path());
    const fs::path own_list = folder / slide_plan_name;
    write_whole(own_list, earlier.text().empty() ? list : with_more_files(earlier.text(), hashes));
    for (const std::string& name : files) move(aside.file(name), folder / name);
    for (const fs::path& file : old) {
        std::error_code ignored;
        fs::remove(file, ignored);
    }
    write_whole(own_list, list);
}

}  // namespace

void write_deck(const Session& session, const DeckRequest& request, LazyRenderer& renderer,
                const Task& task) {
    const FilmPlan film = film_plan(session);
    const std::vector<Slide> slides = slides_of(session.scene, film, "--slides");
    // Stills for paper have the width of a Beamer slide in 16:9, and the type of all figures:
    // larger letters leave no space for some of the names.
    constexpr double beamer_width_mm = 160.0;
    const int least_px = static_cast<int>(std::ceil(least_dpi * beamer_width_mm / mm_per_inch));
    if (const int width_px = session.scene.film.width_px; width_px < least_px)
        throw SceneError(session.scene.location_of("film.size"),
                         fmt::format("film.size: a film of slides is at least {} pixels wide, this "
                                     "one {}: its PDFs are {:.0f} mm wide, of {:.0f} dots per inch "
                                     "or more; make it larger",
                                     least_px, width_px, beamer_width_mm, least_dpi));
    SceneRequest on_paper = request.scene;
    on_paper.print = {};
    on_paper.print.dpi = session.scene.film.width_px * mm_per_inch / beamer_width_mm;
    const Session paper = open_session(on_paper);
    fs::path folder = request.folder.lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();
    const SlideOrigin origin = origin_of(session.scene, folder);
    const FileList earlier = check_folder(folder, origin);
    const fs::path named = folder;
    if (std::error_code error; fs::is_symlink(folder, error)) folder = fs::canonical(folder);
    watch_for_interrupts();
    const std::string plan =
        slide_plan_text(session, film, slides,
                        {.is_portable = renderer.is_portable(), .scene_file = origin.scene_file});
    SlidesAside aside(named, folder, ".part", plan);

    make_slide_films(session, slides, aside, request.n_jobs, renderer, task);

    // The stills are frames of the film.
    StillWriter writer;
    const auto draw = [&](const Session& of, const PrintChoices& print, std::size_t i,
                          std::string_view suffix, const Task& told) {
        stop_if_interrupted();
        StillRequest still;
        still.output = aside.file(slide_file(i, suffix)).string();
        still.frame = slides[i].last_frame;
        still.names_fade = !is_vector_name(still.output);
        still.print = print;
        draw_still(prepare_still(Session(of), std::move(still)), renderer, writer, told);
    };
    for (std::size_t i = 0; i < slides.size(); ++i) {
        draw(session, request.scene.print, i, ".png", {});
        // Which names have no room on paper.
        Task told;
        told.say = [&, i](const std::string& line) {
            constexpr std::string_view note = "note: ";
            if (line.starts_with("note: no room"))
                task.say(
                    fmt::format("{}{}: {}", note, slide_file(i, ".pdf"), line.substr(note.size())));
        };
        draw(paper, on_paper.print, i, ".pdf", told);
    }
    writer.finish();
    write_whole(aside.file(slide_index_name), slide_index(session, film, slides));
    std::set<std::string> files{slide_index_name};
    for (std::size_t i = 0; i < slides.size(); ++i)
        for (std::string& name : slide_files_of(session, film, slides[i], i).all())
            files.insert(std::move(name));
    commit(aside, folder, files, plan, earlier);
    task.finish(fmt::format("{}, {} slide{}", named.string(), slides.size(),
                            slides.size() == 1 ? "" : "s"));
}

}  // namespace poinsot
