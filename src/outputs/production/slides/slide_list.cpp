#include "production/slides/slide_list.h"

#include <fmt/format.h>

#include "production/films/subtitles.h"
#include "production/records/record.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

std::string row_of(const Session& session, const FilmPlan& film, const Slide& slide,
                   std::size_t index, bool has_pdf) {
    const auto or_null = [](const std::string& name) {
        return name.empty() ? "null" : json_string(name);
    };
    const double loop_s = static_cast<double>(slide.n_loop_frames) / film.rate.per_second();
    const SlideFiles files = slide_files_of(session, film, slide, index, has_pdf);
    return JsonObject()
        .add("number", index + 1)
        .add("is_stop", slide.is_stop)
        .add("title", slide.title)
        .add("note", slide.note)
        .add("film", files.film)
        .json("loop", or_null(files.loop))
        .json("captions", or_null(files.captions))
        .json("loop_captions", or_null(files.loop_captions))
        .add("png", files.png)
        .json("pdf", or_null(files.pdf))
        .add("begin_s", film.moment_of(slide.first_frame).film_s)
        .add("end_s", film.moment_of(slide.last_frame).film_s)
        .add("loop_s", loop_s)
        .add("motion_time_s", film.time_of(slide.last_frame))
        .add("first_frame", slide.first_frame)
        .add("last_frame", slide.last_frame)
        .line();
}

}  // namespace

std::string slide_file(std::size_t slide, std::string_view suffix) {
    return fmt::format("{:02}{}", slide + 1, suffix);
}

std::vector<std::string> SlideFiles::all() const {
    std::vector<std::string> names;
    for (const std::string& name : {film, loop, captions, loop_captions, png, pdf})
        if (!name.empty()) names.push_back(name);
    return names;
}

SlideFiles slide_files_of(const Session& session, const FilmPlan& film, const Slide& slide,
                          std::size_t index, bool has_pdf) {
    const auto name_if = [index](bool is_there, std::string_view suffix) {
        return is_there ? slide_file(index, suffix) : std::string();
    };
    const auto has_captions = [&](std::int64_t first) {
        return !subtitles_of(session, film, first, slide.last_frame).empty();
    };
    const bool loops = slide.n_loop_frames > 0;
    return {.film = slide_file(index, ".mp4"),
            .loop = name_if(loops, "-loop.mp4"),
            .captions = name_if(has_captions(slide.first_frame), ".vtt"),
            .loop_captions = name_if(loops && has_captions(slide.first_loop_frame()), "-loop.vtt"),
            .png = slide_file(index, ".png"),
            .pdf = name_if(has_pdf, ".pdf")};
}

bool lists_slides_of(const SlideOrigin& origin, std::string_view plan) {
    // No text holds a line break, so that each line is a member of the plan.
    const auto has = [&plan](std::string_view key, const std::string& value) {
        return plan.find(fmt::format("\n  \"{}\": {},\n", key, value)) != std::string_view::npos;
    };
    const bool is_one_file =
        origin.scene_file.empty()
            ? has("scene_file", "null") && has("title", json_string(origin.title))
            : has("scene_file", json_string(origin.scene_file));
    return has("slides_of", json_string(origin.scene_name)) &&
           (is_one_file || has("scene_sha256", json_string(origin.scene_sha256)));
}

std::string slide_plan_text(const Session& session, const FilmPlan& film,
                            const std::vector<Slide>& slides, const SlideSetting& setting) {
    const Scene& scene = session.scene;
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < slides.size(); ++i)
        rows.push_back(row_of(session, film, slides[i], i, setting.has_pdf));
    return JsonObject()
        .add("slides_of", scene.name)
        .json("scene_file", setting.scene_file.empty() ? "null" : json_string(setting.scene_file))
        .add("title", scene.title)
        .add("language", scene.language)
        .json("size", json_numbers(scene.film.width_px, scene.film.height_px))
        .add("frames_per_second", fmt::format("{}/{}", film.rate.numerator, film.rate.denominator))
        .add("n_frames", film.n_frames)
        .add("poinsot", POINSOT_VERSION)
        .add("profile", setting.is_portable ? "portable" : "native")
        .add("scene_sha256", scene_hash_of(scene))
        .json("slides", json_lines(rows, 2))
        .lines();
}

}  // namespace poinsot
