// The space that overlays take at the edges of a picture, and the sizes of their text.
#pragma once

#include <cstddef>

#include "drawing/stage/overlay.h"

namespace poinsot {

// The picture in which overlays are set.
struct OverlayRoom {
    int width_px = 0;
    double px = 1.0;       // width of a line of one pixel at 1080 rows
    double type_px = 1.0;  // the same for text
    double margin_px = 0.0;
    int samples = 1;  // samples × samples per pixel
    bool on_paper = false;

    OverlayRoom(const Scene& scene, int width, double line_px, const LeastSizes& least,
                int n_samples);
    explicit OverlayRoom(const StageContext& stage);
};

using TypeSize = double TypeSizes::*;
inline constexpr TypeSize title_size = &TypeSizes::title;
inline constexpr TypeSize chapter_size = &TypeSizes::chapter;
inline constexpr TypeSize caption_size = &TypeSizes::caption;

// The style of text wrapped to a picture.
TypeStyle text_style(const Scene& scene, const OverlayRoom& room, TypeSize size);
TypeStyle text_style(const StageContext& stage, TypeSize size);

// Whether the scene shows an overlay.
bool wants_title(const Scene& scene);
bool wants_chapters(const Scene& scene);
bool wants_caption(const Scene& scene);
// By default a loop has no clock, since it has no first instant.
bool wants_clock(const Scene& scene);

// The top of the first line below the title.
double below_title(const Scene& scene, const OverlayRoom& room);
// Below the titles of the chapters, if they are shown.
double below_chapters(const Scene& scene, const OverlayRoom& room);

// Sets the title of a chapter with the number under which players list it.
TextBlock set_chapter(const Scene& scene, std::size_t i, TextCache& text, const TypeStyle& style);

}  // namespace poinsot
