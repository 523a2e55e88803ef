#include "web/module/page_film.h"

#include <algorithm>
#include <vector>

#include "encoding/yuv.h"
#include "error/error.h"
#include "image/alpha.h"
#include "production/films/chapters.h"
#include "production/films/subtitles.h"
#include "production/slides/slide_list.h"
#include "text/json_text.h"
#include "text/languages.h"
#include "typeset/plain_text.h"
#include "web/module/scene_of_page.h"

namespace poinsot {

PageFilm::PageFilm(const PageScene& files, FontSource fonts)
    : session_(session_of_page(scene_of_page(files), std::move(fonts))),
      film_(film_plan(session_)),
      picture_(session_, whole_film(film_), setting_of(session_.scene)) {}

std::string PageFilm::description() const {
    const auto frames_of = [this](const auto& marks) {
        std::vector<std::string> frames;
        // At the film's end, its last frame.
        for (const auto& mark : marks)
            frames.push_back(
                std::to_string(std::min(film_.frame_at(mark.at_s), film_.n_frames - 1)));
        return json_list(frames);
    };
    return JsonObject()
        .add("title", plain_text(session_.scene.title))
        .add("width", width_px())
        .add("height", height_px())
        .add("numerator", film_.rate.numerator)
        .add("denominator", film_.rate.denominator)
        .add("n_frames", film_.n_frames)
        .add("transparent", session_.theme.background.alpha < 1.0)
        .json("chapters", frames_of(session_.scene.chapters))
        .json("stops", frames_of(session_.scene.stops))
        .line();
}

Drawing PageFilm::drawing_of(std::int64_t frame) const {
    if (frame < 0 || frame >= film_.n_frames) throw InputError("the film has no such frame");
    return picture_.stage.at(film_.moment_of(frame));
}

std::string PageFilm::texts(std::int64_t first, std::int64_t last, const std::string& file) const {
    std::vector<std::string> chapters;
    for (const FilmChapter& chapter : chapters_of(session_.scene, film_, first, last))
        chapters.push_back(JsonObject()
                               .add("title", chapter.title)
                               .add("first_frame", chapter.first_frame)
                               .add("end_frame", chapter.end_frame)
                               .line());
    const auto subtitles = subtitles_of(session_, film_, first, last);
    return JsonObject()
        .add("language", three_letters_of(session_.scene.language))
        .json("chapters", json_list(chapters))
        .add("captions", subtitles.empty() ? "" : subtitles_text(file, subtitles))
        .line();
}

std::string PageFilm::slides(std::span<const FileHash> files) const {
    return with_files(slide_plan_text(session_, film_, slides_of(session_.scene, film_, "slides"),
                                      {.has_pdf = false}),
                      files);
}

std::string PageFilm::record(const PageOutput& output) {
    if (!record_)
        record_ = record_of(session_, picture_.stage,
                            in_words(picture_.bound, session_.accuracy.asked_px));
    Record record = *record_;
    record.renderer = output.renderer;
    record.mesa = "none";
    record.maker = output.maker;
    record.packets = output.packets;
    record.file = output.file;
    const bool is_slide =
        output.kind == PageOutput::slide_film || output.kind == PageOutput::slide_still;
    if (is_slide) record.film_frames = film_.n_frames;
    if (output.kind == PageOutput::slide_still) {
        record.time_s = film_.time_of(output.frame);
        record.names = fading_names;
    } else {
        record.frames = {output.first, output.last};
    }
    if (output.kind == PageOutput::slide_still || output.kind == PageOutput::picture) {
        record.frame = output.frame;
        record.pixels = output.pixels;
    }
    return sealed_text(record);
}

// A page has its own fonts alone.
std::string fonts_in_words(const Stage& /*stage*/) { return ""; }

std::string planes_of(const Image& frame, bool with_alpha) {
    Image flat;
    const bool keeps = with_alpha || is_opaque(frame);
    if (!keeps) flatten_on_white(frame, flat);
    const auto width = static_cast<std::size_t>(frame.width());
    const auto height = static_cast<std::size_t>(frame.height());
    std::string planes(width * height * (with_alpha ? 5 : 3) / 2, '\0');
    auto* const y = reinterpret_cast<std::uint8_t*>(planes.data());
    auto* const cb = y + width * height;
    auto* const cr = cb + width * height / 4;
    const auto stride = static_cast<std::ptrdiff_t>(width);
    YuvConverter(frame.width())
        .convert(keeps ? frame : flat, {y, cb, cr, stride, stride / 2, stride / 2});
    if (with_alpha) copy_alpha(frame, cr + width * height / 4, stride);
    return planes;
}

}  // namespace poinsot
