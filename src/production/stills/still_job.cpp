#include "production/stills/still_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "error/error.h"
#include "image/pixels_xxh64.h"
#include "image/png.h"
#include "output/film_metadata.h"
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
        throw InputError(
            fmt::format("--depth {}: a component has 8 or 16 bits", request.bit_depth));
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

// The histories start with the film. They end at the instant, or with the film of which the picture
// is a frame.
PictureSpan span_of(const Session& session, const StillRequest& request, double time_s) {
    PictureSpan span{.first_time_s = std::min(film_plan(session).start_s, time_s),
                     .last_time_s = time_s,
                     .first_shown_s = time_s};
    if (request.frame) span = whole_film(film_plan(session));
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
void note_gaps(const LatexGaps& gaps, const std::filesystem::path& file,
               const ProgressSink& progress) {
    const std::string name = printable(file.filename().string());
    if (!gaps.hidden.empty())
        progress.say(fmt::format("note: {} leaves out {}, which LaTeX cannot set", name,
                                 listed(gaps.hidden)));
    if (!gaps.need_t1.empty())
        progress.say(fmt::format(
            "note: {}: pdfLaTeX leaves out {}; \\usepackage[T1]{{fontenc}} lets it set them", name,
            listed(gaps.need_t1)));
    if (!gaps.need_unicode.empty())
        progress.say(fmt::format(
            "note: {}: pdfLaTeX leaves out {}; XeLaTeX and LuaLaTeX set those that their font has",
            name, listed(gaps.need_unicode)));
}

// Reports a journal's figure; `dpi`: of the drawing.
void tell_figure(const Session& session, const Drawing& drawing, double dpi,
                 const ProgressSink& progress) {
    FigureReport report = report_on(drawing, pt_per_inch / dpi);
    if (!session.scene.overlays) {
        const bool by_journal = session.scene.where("overlays").starts_with("--journal");
        report.left_out.insert(report.left_out.begin(),
                               fmt::format("title, captions and clock{}",
                                           by_journal ? " (--keep-text draws them)" : ""));
    }
    progress.say(in_words(report));
}

}  // namespace

StillJob::StillJob(Session&& session, StillRequest request)
    : session_(std::move(session)),
      request_(accepted(std::move(request), session_.scene)),
      moment_(moment_for(session_, request_)),
      staging_(session_, span_of(session_, request_, moment_.time_s),
               setting_for(session_.scene, request_)) {}

std::int64_t StillJob::n_pixels() const {
    return std::int64_t{session_.scene.film.width_px} * session_.scene.film.height_px;
}

Record StillJob::record() const {
    return record_of(session_, staging_.stage,
                     in_words(staging_.bound, session_.accuracy.asked_px));
}

void StillJob::add_moment(Record& record) const {
    record.time_s = moment_.time_s;
    if (request_.names_fade) record.names = fading_names;
    if (!request_.frame) return;
    record.frame = request_.frame;
    record.film_frames = film_plan(session_).n_frames;
}

Record StillJob::vector_record() const {
    Record record = this->record();
    add_moment(record);
    record.dpi = request_.print.dpi;
    record.type_pt = request_.print.type_pt.value_or(default_type_pt);
    record.shading = request_.vectors.shading;
    record.journal = request_.print.journal;
    if (request_.vectors.text != VectorChoices{}.text) record.lettering = request_.vectors.text;
    return record;
}

VectorStill StillJob::vectors(LazyRenderer& renderer) const {
    return vectors_of(drawing(), renderer);
}

VectorStill StillJob::vectors_of(const Drawing& drawing, LazyRenderer& renderer) const {
    Record record = vector_record();
    vector::DrawPixels draw_pixels;
    if (has_pixels(request_.vectors)) {
        record_context(renderer.context().info(), renderer.is_portable(), record);
        draw_pixels = [&renderer](const Drawing& surfaces) {
            return pixels_of(surfaces, renderer);
        };
    } else {
        record_without_context(record);
    }
    return vector_still(request_.output, title(), drawing, request_.vectors, std::move(record),
                        draw_pixels);
}

Record StillJob::pixel_record(const PictureMaker& pictures, bool is_portable,
                              PngOptions& png) const {
    Record record = record_of(session_, pictures, is_portable);
    add_moment(record);
    record.bit_depth = request_.bit_depth;
    const FilmSpec& film = session_.scene.film;
    const auto paper = print_size_of(request_.print, film.width_px, film.height_px);
    if (!paper) return record;
    png.pixels_per_metre = paper->pixels_per_metre;
    record.dpi = request_.print.dpi.value_or(default_dpi);
    record.type_pt = request_.print.type_pt.value_or(default_type_pt);
    record.journal = request_.print.journal;
    return record;
}

PixelStill StillJob::pixels(LazyRenderer& renderer) {
    PictureMaker pictures(std::move(staging_), renderer);
    if (request_.bit_depth != 8 || wants_bands(pictures))
        throw InputError(
            fmt::format("a picture of {}x{} pixels with {} bits per component is written to a "
                        "file only; give its name",
                        pictures.width_px(), pictures.height_px(), request_.bit_depth));
    return drawn(pictures, renderer.is_portable());
}

PixelStill StillJob::drawn(PictureMaker& pictures, bool is_portable) const {
    PixelStill still;
    Record record = pixel_record(pictures, is_portable, still.png);
    pictures.draw(moment_, still.image);
    record.pixels = pixels_xxh64(still.image);
    still.png.texts[metadata_name] = sealed_text(record);
    still.bound = in_words(pictures.bound(), session_.accuracy.asked_px);
    return still;
}

void StillJob::draw_vectors(OutputPlace place, LazyRenderer& renderer,
                            const ProgressSink& progress) {
    const Drawing drawing = this->drawing();
    const VectorStill still = vectors_of(drawing, renderer);
    write_whole(place.path(), still.bytes);
    std::string files = printable(place.path().string());
    if (!still.latex.empty()) {
        const std::filesystem::path beside = latex_path_of(place.path());
        write_whole(beside, still.latex);
        note_gaps(still.latex_gaps, beside, progress);
        files += "\n" + printable(beside.string());
    }
    progress.say(fmt::format("{}\npaths within {:.2g} um of what they show", files, still.off_um));
    if (!request_.print.journal.empty())
        tell_figure(session_, drawing, request_.print.dpi.value_or(default_dpi), progress);
}

Record StillJob::draw_into(LazyRenderer& renderer, Image& image) {
    PictureMaker pictures(std::move(staging_), renderer);
    Record record = record_of(session_, pictures, renderer.is_portable());
    add_moment(record);
    pictures.draw(moment_, image);
    return record;
}

void StillJob::tell(const ProgressSink& progress) const {
    tell_notes(session_, progress);
    tell_stage_notes(staging_.stage, progress);
    tell_unnamed(staging_.stage, {&moment_, 1}, progress);
}

std::string StillJob::report() const {
    std::string words;
    if (!request_.print.journal.empty())
        tell_figure(session_, drawing(),
                    staging_.samples * request_.print.dpi.value_or(default_dpi),
                    {.say = [&words](const std::string& line) { words = line; }});
    return words;
}

void StillJob::draw(LazyRenderer& renderer, StillWriter& writer, const ProgressSink& progress) {
    tell(progress);
    OutputPlace place(request_.output, session_.scene, ".png");
    if (is_vector_name(request_.output)) {
        draw_vectors(std::move(place), renderer, progress);
        return;
    }
    if (!request_.print.journal.empty())
        tell_figure(session_, drawing(),
                    staging_.samples * request_.print.dpi.value_or(default_dpi), progress);
    PictureMaker pictures(std::move(staging_), renderer);
    std::string words = fmt::format("{}\n{}", printable(place.path().string()),
                                    in_words(pictures.bound(), session_.accuracy.asked_px));
    if (request_.bit_depth == 16 || wants_bands(pictures)) {
        PngOptions png;
        Record record = pixel_record(pictures, renderer.is_portable(), png);
        writer.finish();
        watch_for_interrupts();
        const auto texts = [&record](const std::string& pixels) {
            record.pixels = pixels;
            return std::map<std::string, std::string>{{metadata_name, sealed_text(record)}};
        };
        write_in_bands(pictures, moment_, place.path(), png, record.bit_depth, texts);
        progress.say(words);
    } else {
        PixelStill still = drawn(pictures, renderer.is_portable());
        writer.write(std::move(place), std::move(still.image), std::move(still.png),
                     [say = progress.say, words = std::move(words)] { say(words); });
    }
}

}  // namespace poinsot
