#include "production/stills/prepared_still.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "encoding/film_metadata.h"
#include "error/error.h"
#include "image/pixels_xxh64.h"
#include "image/png.h"
#include "production/records/record.h"
#include "production/stills/banded_still.h"
#include "production/stills/output_place.h"
#include "production/vectors/figure_report.h"
#include "production/vectors/latex_figure.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/interrupt.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr int most_side_px = 16384;  // limit of a framebuffer

// Checks a request and returns it.
StillRequest accepted(StillRequest request, const Scene& scene) {
    const std::filesystem::path output(request.output);
    const bool is_vectors = is_vector_name(request.output);
    const bool is_named = !output.empty() && output != "-";
    if (is_named && !is_vectors && suffix_of(output) != ".png")
        throw InputError(
            fmt::format("{}: a still is a PNG, a PDF or an SVG; end its name in .png, .pdf or .svg",
                        printable(request.output)));
    check_vector_choices(request.vectors);
    if (!is_vectors && request.vectors != VectorChoices{}) {
        const VectorChoices& vectors = request.vectors;
        const bool is_shading = vectors.shading != VectorChoices{}.shading;
        throw InputError(fmt::format("--{} {}: is for vectors; name the output .pdf or .svg",
                                     is_shading ? "shading" : "text",
                                     is_shading ? vectors.shading : vectors.text));
    }
    if (request.vectors.text == "latex") check_latex_place(output);
    if (is_vectors)
        request.print = on_paper(request.print, scene.film.width_px, scene.film.height_px);
    if (is_vectors && request.bit_depth != 8)
        throw InputError(
            fmt::format("--depth {}: vectors have no pixels; leave it out, or name the output .png",
                        request.bit_depth));
    if (request.bit_depth != 8 && request.bit_depth != 16)
        throw InputError(fmt::format("--depth {}: a component has 8 or 16 bits; give one of them",
                                     request.bit_depth));
    return request;
}

FilmTime moment_for(const Session& session, const StillRequest& request) {
    if (request.frame) {
        const FilmPlan film = film_plan(session);
        if (*request.frame < 0 || *request.frame >= film.n_frames)
            throw InputError(fmt::format("frame {}: the film has frames 0-{}; choose one of these",
                                         *request.frame, film.n_frames - 1));
        return film.moment_of(*request.frame);
    }
    return still_moment(session, request.time_s, request.when);
}

// The histories end at the instant, or with the film of which the picture is a frame.
PictureSpan span_of(const Session& session, const StillRequest& request, double time_s) {
    const FilmPlan film = film_plan(session);
    PictureSpan span = request.frame ? whole_film(film) : span_of_instant(session, film, time_s);
    span.is_still = !request.names_fade;
    return span;
}

// The pixels of a drawing of surfaces alone.
vector::Raster pixels_of(const Drawing& drawing, LazyRenderer& renderer) {
    constexpr double most_pixels = 1e8;
    if (1.0 * drawing.width_px * drawing.height_px > most_pixels ||
        std::max(drawing.width_px, drawing.height_px) > most_side_px)
        throw InputError(
            fmt::format("--shading picture: {}x{} pixels at 600 dpi; at most {} per side and "
                        "{:.0f} million in all: make the figure smaller",
                        drawing.width_px, drawing.height_px, most_side_px, most_pixels / 1e6));
    Image image;
    renderer.renderer().render_into(drawing, image);
    const auto bytes = image.bytes();
    return {image.width(), image.height(), {bytes.begin(), bytes.end()}};
}

PictureSetting setting_for(const Scene& scene, const StillRequest& request) {
    PictureSetting setting = is_vector_name(request.output) ? vector_setting(scene, request.print)
                                                            : setting_of(scene, request.print);
    setting.views = request.views;
    return setting;
}

// Reports text that LaTeX may set differently than the figure shows.
void note_gaps(const LatexGaps& gaps, const std::filesystem::path& file, const Task& task) {
    const std::string name = printable(file.filename().string());
    if (!gaps.hidden.empty())
        task.say(fmt::format("note: {} leaves out {}, which LaTeX cannot set", name,
                             listed(gaps.hidden)));
    if (!gaps.need_t1.empty())
        task.say(fmt::format(
            "note: {}: pdfLaTeX leaves out {}; \\usepackage[T1]{{fontenc}} lets it set them", name,
            listed(gaps.need_t1)));
    if (!gaps.need_unicode.empty())
        task.say(fmt::format(
            "note: {}: pdfLaTeX leaves out {}; XeLaTeX and LuaLaTeX set those that their font has",
            name, listed(gaps.need_unicode)));
}

// Reports a journal's figure; `dpi`: of the drawing.
void tell_figure(const PreparedStill& still, const Drawing& drawing, double dpi, const Task& task) {
    FigureReport report = report_on(drawing, pt_per_inch / dpi);
    const Scene& scene = still.session->scene;
    if (!scene.overlays) {
        const bool by_journal = scene.where("overlays").starts_with("--journal");
        report.left_out.insert(report.left_out.begin(),
                               fmt::format("title, captions and clock{}",
                                           by_journal ? " (--keep-text draws them)" : ""));
    }
    task.say(in_words(report));
}

double dpi_of(const PreparedStill& still) { return still.request.print.dpi.value_or(default_dpi); }

void add_moment(const PreparedStill& still, Record& record) {
    record.time_s = still.moment.time_s;
    if (still.request.names_fade) record.names = fading_names;
    if (!still.request.frame) return;
    record.frame = still.request.frame;
    record.film_frames = film_plan(*still.session).n_frames;
}

// Also sets the density of a file that has a size on paper.
Record pixel_record_of(const PreparedStill& still, const PictureMaker& pictures, bool is_portable,
                       PngOptions& png) {
    const StillRequest& request = still.request;
    Record record = record_of(*still.session, pictures, is_portable);
    add_moment(still, record);
    record.bit_depth = request.bit_depth;
    const FilmSpec& film = still.session->scene.film;
    const auto paper = print_size_of(request.print, film.width_px, film.height_px);
    if (!paper) return record;
    png.pixels_per_metre = paper->pixels_per_metre;
    record.dpi = request.print.dpi.value_or(default_dpi);
    record.type_pt = request.print.type_pt.value_or(default_type_pt);
    record.journal = request.print.journal;
    return record;
}

PixelStill drawn(const PreparedStill& still, PictureMaker& pictures, bool is_portable) {
    PixelStill pixels;
    Record record = pixel_record_of(still, pictures, is_portable, pixels.png);
    pictures.draw(still.moment, pixels.image);
    record.pixels = pixels_xxh64(pixels.image);
    pixels.png.texts[metadata_name] = sealed_text(record);
    pixels.bound = in_words(pictures.bound(), still.session->accuracy.asked_px);
    return pixels;
}

VectorStill vectors_of(const PreparedStill& still, const Drawing& drawing, LazyRenderer& renderer) {
    Record record = vector_record_of(still);
    vector::DrawPixels draw_pixels;
    if (has_pixels(still.request.vectors)) {
        record_context(renderer.context().info(), renderer.is_portable(), record);
        draw_pixels = [&renderer](const Drawing& surfaces) {
            return pixels_of(surfaces, renderer);
        };
    } else {
        record_without_context(record);
    }
    return vector_still(still.request.output, title_of(still.session->scene), drawing,
                        still.request.vectors, std::move(record), draw_pixels);
}

void draw_vectors(const PreparedStill& still, const OutputPlace& place, LazyRenderer& renderer,
                  const Task& task) {
    const Drawing drawing = drawing_of(still);
    const VectorStill figure = vectors_of(still, drawing, renderer);
    write_whole(place.path(), figure.bytes);
    std::string files = printable(place.path().string());
    if (!figure.latex.empty()) {
        const std::filesystem::path beside = latex_path_of(place.path());
        write_whole(beside, figure.latex);
        note_gaps(figure.latex_gaps, beside, task);
        files += "\n" + printable(beside.string());
    }
    task.say(fmt::format("{}\npaths within {:.2g} um of what they show", files, figure.off_um));
    if (!still.request.print.journal.empty()) tell_figure(still, drawing, dpi_of(still), task);
}

void draw_png(const PreparedStill& still, OutputPlace&& place, LazyRenderer& renderer,
              StillWriter& writer, const Task& task) {
    PictureMaker pictures(still.picture, renderer);
    std::string words = fmt::format("{}\n{}", printable(place.path().string()),
                                    in_words(pictures.bound(), still.session->accuracy.asked_px));
    if (still.request.bit_depth == 16 || wants_bands(pictures)) {
        PngOptions png;
        Record record = pixel_record_of(still, pictures, renderer.is_portable(), png);
        writer.finish();
        watch_for_interrupts();
        const auto texts = [&record](const std::string& pixels) {
            record.pixels = pixels;
            return std::map<std::string, std::string>{{metadata_name, sealed_text(record)}};
        };
        write_in_bands(pictures, still.moment, place.path(), png, record.bit_depth, texts);
        task.say(words);
    } else {
        PixelStill pixels = drawn(still, pictures, renderer.is_portable());
        writer.write(std::move(place), std::move(pixels.image), std::move(pixels.png),
                     [say = task.say, words = std::move(words)] { say(words); });
    }
}

}  // namespace

PreparedStill prepare_still(Session&& session, StillRequest request) {
    auto kept = std::make_unique<const Session>(std::move(session));
    request = accepted(std::move(request), kept->scene);
    const FilmTime moment = moment_for(*kept, request);
    PreparedPicture picture(*kept, span_of(*kept, request, moment.time_s),
                            setting_for(kept->scene, request));
    return {.session = std::move(kept),
            .request = std::move(request),
            .moment = moment,
            .picture = std::move(picture)};
}

std::int64_t n_pixels(const PreparedStill& still) {
    const FilmSpec& film = still.session->scene.film;
    return std::int64_t{film.width_px} * film.height_px;
}

bool opens_context(const PreparedStill& still) {
    return !is_vector_name(still.request.output) || has_pixels(still.request.vectors);
}

Record record_of(const PreparedStill& still) {
    return record_of(*still.session, still.picture.stage,
                     in_words(still.picture.bound, still.session->accuracy.asked_px));
}

Record vector_record_of(const PreparedStill& still) {
    const StillRequest& request = still.request;
    Record record = record_of(still);
    add_moment(still, record);
    record.dpi = request.print.dpi;
    record.type_pt = request.print.type_pt.value_or(default_type_pt);
    record.shading = request.vectors.shading;
    record.journal = request.print.journal;
    if (request.vectors.text != VectorChoices{}.text) record.lettering = request.vectors.text;
    return record;
}

void draw_still(const PreparedStill& still, LazyRenderer& renderer, StillWriter& writer,
                const Task& task) {
    tell_notes(still, task);
    OutputPlace place(still.request.output, still.session->scene, ".png");
    if (is_vector_name(still.request.output)) return draw_vectors(still, place, renderer, task);
    if (const std::string words = journal_report(still); !words.empty()) task.say(words);
    draw_png(still, std::move(place), renderer, writer, task);
}

void tell_notes(const PreparedStill& still, const Task& task) {
    tell_notes(*still.session, task);
    tell_stage_notes(still.picture.stage, task);
    tell_unnamed(still.picture.stage, {&still.moment, 1}, task);
}

std::string journal_report(const PreparedStill& still) {
    std::string words;
    if (!still.request.print.journal.empty())
        tell_figure(still, drawing_of(still), still.picture.samples * dpi_of(still),
                    {.say = [&words](const std::string& line) { words = line; }});
    return words;
}

PixelStill still_in_memory(const PreparedStill& still, LazyRenderer& renderer) {
    PictureMaker pictures(still.picture, renderer);
    if (still.request.bit_depth != 8 || wants_bands(pictures))
        throw InputError(
            fmt::format("a picture of {}x{} pixels with {} bits per component is written to a "
                        "file only; give its name",
                        pictures.width_px(), pictures.height_px(), still.request.bit_depth));
    return drawn(still, pictures, renderer.is_portable());
}

VectorStill vectors_of(const PreparedStill& still, LazyRenderer& renderer) {
    return vectors_of(still, drawing_of(still), renderer);
}

Drawing drawing_of(const PreparedStill& still) { return still.picture.stage.at(still.moment); }

Record draw_into(const PreparedStill& still, LazyRenderer& renderer, Image& image) {
    PictureMaker pictures(still.picture, renderer);
    Record record = record_of(*still.session, pictures, renderer.is_portable());
    add_moment(still, record);
    pictures.draw(still.moment, image);
    return record;
}

}  // namespace poinsot
