#include "production/slides/pptx_deck.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error/error.h"
#include "production/slides/pptx_parts.h"
#include "production/slides/slide_files.h"
#include "production/slides/slide_plan.h"
#include "production/slides/stored_zip.h"
#include "production/stills/output_place.h"
#include "production/stills/prepared_still.h"
#include "production/vectors/vector_still.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/interrupt.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

// Throws InputError for a file that somebody else has made or edited, and for the presentation of
// another scene.
void check_output(const fs::path& output, const Scene& scene, const SlideOrigin& origin) {
    check_replaceable({.path = output, .inputs = files_read_for(scene)});
    if (kind_of_file(output) != FileKind::regular) return;
    const std::optional<std::string> about = StoredZip::unchanged_entry(output, pptx_origin_name);
    if (!about)
        throw InputError(
            fmt::format("{}: exists, and was not written by poinsot or has been edited since; name "
                        "another file, or remove this one",
                        printable(output.string())));
    if (!describes_slides_of(origin, *about))
        throw InputError(
            fmt::format("{}: holds the slides of another scene; name another file, or remove this "
                        "one",
                        printable(output.string())));
}

// A film's poster is shown until it plays. It is the picture with which the slide before ends: any
// other would be seen for a moment, and the last one would reveal how the slide ends. The still of
// a slide is the poster of the next one.
struct PosterFrames {
    std::map<std::int64_t, std::string> names;  // of the files, by frame

    const std::string& at(std::int64_t frame) {
        return names.try_emplace(frame, fmt::format("poster{}.png", names.size() + 1))
            .first->second;
    }
};

PptxText text_of(const Session& session, const FilmPlan& film, const std::vector<Slide>& slides,
                 const SlideOrigin& origin, PosterFrames& posters) {
    const Scene& scene = session.scene;
    const auto duration_ms = [&film](std::int64_t n_frames) {
        return std::llround(1e3 * static_cast<double>(n_frames) / film.rate.per_second());
    };
    PptxText text;
    text.title = title_of(scene);
    text.origin = origin;
    text.language = scene.language;
    text.width_px = scene.film.width_px;
    text.height_px = scene.film.height_px;
    for (std::size_t i = 0; i < slides.size(); ++i) {
        const Slide& slide = slides[i];
        PptxSlide one{.title = slide.title.empty() ? text.title : slide.title, .note = slide.note};
        one.film = slide_file(i, ".mp4");
        one.poster = posters.at(slide.first_frame);
        one.duration_ms = duration_ms(slide.last_frame - slide.first_frame + 1);
        if (slide.n_loop_frames > 0) one.loop = slide_file(i, "-loop.mp4");
        one.loop_ms = duration_ms(slide.n_loop_frames);
        one.still = posters.at(slide.last_frame);
        text.slides.push_back(std::move(one));
    }
    return text;
}

void draw_posters(const Session& session, const PosterFrames& posters, const SlidesAside& aside,
                  LazyRenderer& renderer) {
    StillWriter writer;
    for (const auto& [frame, name] : posters.names) {
        stop_if_interrupted();
        StillRequest still;
        still.output = aside.file(name).string();
        still.frame = frame;
        still.names_fade = true;
        draw_still(prepare_still(Session(session), std::move(still)), renderer, writer, {});
    }
    writer.finish();
}

}  // namespace

void write_pptx(const Session& session, const PptxRequest& request, LazyRenderer& renderer,
                const Task& task) {
    const FilmPlan film = film_plan(session);
    const std::vector<Slide> slides =
        slides_of(session.scene, film, fmt::format("-o {}", printable(request.output.string())));
    PosterFrames posters;
    SlideOrigin origin = origin_of(session.scene, request.output.parent_path());
    origin.title = title_of(session.scene);
    const PptxText text = text_of(session, film, slides, origin, posters);
    check_output(request.output, session.scene, origin);
    watch_for_interrupts();
    AtomicFile output(request.output);
    SlidesAside aside(
        request.output, request.output, ".slides",
        slide_plan_text(session, film, slides,
                        {.is_portable = renderer.is_portable(), .scene_file = origin.scene_file}));
    make_slide_films(session, slides, aside, request.n_jobs, renderer, task);
    draw_posters(session, posters, aside, renderer);

    StoredZip zip(output);
    for (const PptxPart& part : pptx_parts(text)) zip.add(part.name, part.xml);
    for (const auto& [frame, name] : posters.names)
        zip.add_file("ppt/media/" + name, aside.file(name));
    for (const PptxSlide& slide : text.slides)
        for (const std::string& name : {slide.film, slide.loop})
            if (!name.empty()) zip.add_file("ppt/media/" + name, aside.file(name));
    zip.finish();
    output.commit();
    aside.remove();
    task.finish(fmt::format("{}, {} slide{}", request.output.string(), text.slides.size(),
                            text.slides.size() == 1 ? "" : "s"));
}

}  // namespace poinsot
