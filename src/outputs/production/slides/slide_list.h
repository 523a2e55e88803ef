// The names of the files of slides, and slides.json. No file: a page has them, too.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "production/session/session.h"
#include "production/slides/slide_origin.h"
#include "production/slides/slide_plan.h"

namespace poinsot {

inline constexpr const char* slide_plan_name = "slides.json";

// "01.mp4" for slide 0.
std::string slide_file(std::size_t slide, std::string_view suffix);

// The names of a slide's files; an empty name stands for a file that it does not have.
struct SlideFiles {
    std::string film, loop, captions, loop_captions, png, pdf;

    std::vector<std::string> all() const;
};
SlideFiles slide_files_of(const Session& session, const FilmPlan& film, const Slide& slide,
                          std::size_t index, bool has_pdf = true);

// The beginning of every slides.json.
inline constexpr const char* any_slide_plan_head = "{\n  \"slides_of\": ";

// Whether slides.json is of the same talk.
bool lists_slides_of(const SlideOrigin& origin, std::string_view plan);

struct SlideSetting {
    bool is_portable = false;
    bool has_pdf = true;       // a page makes none
    std::string scene_file{};  // of a SlideOrigin
};

// The text of slides.json without the files' hashes, which with_files() adds. It changes with
// everything that the films depend on, except for the machine and the renderer.
std::string slide_plan_text(const Session& session, const FilmPlan& film,
                            const std::vector<Slide>& slides, const SlideSetting& setting);

}  // namespace poinsot
