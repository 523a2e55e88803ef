#include "drawing/stage/overlay_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/stage/live_values.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// The scale that [style] gives text of this size.
double scale_of(const Scene& scene, TypeSize size) {
    const auto& own = size == title_size ? scene.style.title_scale : scene.style.caption_scale;
    return scene.type_scale * own.value_or(1.0);
}

// Pixels per em.
double em_px(const Scene& scene, const OverlayRoom& room, TypeSize size) {
    return (room.on_paper ? paper_sizes : screen_sizes).*size * room.type_px *
           scale_of(scene, size);
}

bool wants(const Scene& scene, const char* name) {
    const auto& show = scene.show;
    if (!scene.overlays) return false;
    return show.empty() || std::find(show.begin(), show.end(), name) != show.end();
}

}  // namespace

OverlayRoom::OverlayRoom(const Scene& scene, int width, double line_px, const LeastSizes& least,
                         int n_samples)
    : width_px(width),
      px(line_px),
      type_px(line_px),
      samples(n_samples),
      on_paper(least.type_px > 0.0) {
    // A page has a margin already.
    constexpr double margin = 40.0, paper_margin = 16.0;
    margin_px = (on_paper ? paper_margin : margin) * px;
    if (on_paper) type_px = paper_type_px(scene, px, least);
}

OverlayRoom::OverlayRoom(const StageContext& stage)
    : OverlayRoom(stage.scene, stage.options.width_px, stage.px, stage.options.least,
                  stage.options.samples) {}

TypeStyle text_style(const Scene& scene, const OverlayRoom& room, TypeSize size) {
    return {.size_px = em_px(scene, room, size),
            .mode = TypeMode::text,
            .max_width_px = std::max(64.0 * room.samples, room.width_px - 2.0 * room.margin_px)};
}
TypeStyle text_style(const StageContext& stage, TypeSize size) {
    return text_style(stage.scene, OverlayRoom(stage), size);
}

bool wants_clock(const Scene& scene) {
    if (scene.clock && scene.overlays) return *scene.clock;
    if (!scene.film.loop.empty() && scene.show.empty()) return false;
    return wants(scene, "clock");
}

bool wants_title(const Scene& scene) { return !scene.title.empty() && wants(scene, "title"); }
bool wants_caption(const Scene& scene) { return !scene.caption.empty() && wants(scene, "caption"); }
bool wants_chapters(const Scene& scene) {
    return !scene.chapters.empty() && wants(scene, "chapter");
}

double below_title(const Scene& scene, const OverlayRoom& room) {
    return room.margin_px + (wants_title(scene) ? 1.55 * em_px(scene, room, title_size) : 0.0);
}
double below_chapters(const Scene& scene, const OverlayRoom& room) {
    return below_title(scene, room) +
           (wants_chapters(scene) ? 1.6 * em_px(scene, room, chapter_size) : 0.0);
}

TextBlock set_chapter(const Scene& scene, std::size_t i, TextCache& text, const TypeStyle& style) {
    return at_scene_key(scene, fmt::format("chapters[{}].title", i), [&] {
        return text.set(fmt::format("{}  {}", i + 1, scene.chapters[i].title), style);
    });
}

namespace {

// `type_case` sets text for such a picture.
OverlayBands overlay_bands(const Scene& scene, const OverlayRoom& room, TextCache& type_case) {
    const double px = room.px;
    // Whole rows of final pixels, so that panels do not depend on the number of samples.
    const auto rows = [samples = room.samples](double high_px) {
        return samples * static_cast<int>(std::ceil(high_px / samples));
    };
    OverlayBands bands;
    if (wants_title(scene) || wants_clock(scene)) {
        bands.top_px =
            rows(room.margin_px + (wants_title(scene) ? 1.4 * em_px(scene, room, title_size)
                                                      : 1.54 * em_px(scene, room, caption_size)));
    }
    if (wants_title(scene)) {
        const TextBlock type = at_scene_key(scene, "title", [&] {
            return type_case.set(scene.title, text_style(scene, room, title_size));
        });
        bands.title_right_px = room.margin_px + type.width_px();
    }
    if (wants_chapters(scene)) {
        const TypeStyle style = text_style(scene, room, chapter_size);
        for (std::size_t i = 0; i < scene.chapters.size(); ++i)
            bands.title_right_px =
                std::max(bands.title_right_px,
                         room.margin_px + set_chapter(scene, i, type_case, style).width_px());
        bands.top_px = std::max(bands.top_px, rows(below_chapters(scene, room)));
    }
    if (wants_caption(scene)) {
        // Changing numbers affect the text's width, but hardly its number of lines.
        const TextBlock type = at_scene_key(scene, "caption", [&] {
            return type_case.set(live_text(scene, scene.caption, {}),
                                 text_style(scene, room, caption_size));
        });
        bands.bottom_px = rows(room.margin_px + type.height_px() + 18.0 * px);
    }
    // Rows of timed captions are reserved throughout, so that panels do not move.
    double top_px = 0.0;
    double bottom_px = 0.0;
    for (std::size_t i = 0; scene.overlays && i < scene.captions.size(); ++i) {
        const TimedCaptionSpec& caption = scene.captions[i];
        const TextBlock type = at_scene_key(scene, fmt::format("captions[{}].text", i), [&] {
            return type_case.set(live_text(scene, caption.text, {}),
                                 text_style(scene, room, caption_size));
        });
        double& rows_px = caption.place == "top" ? top_px : bottom_px;
        rows_px = std::max(rows_px, type.height_px() + 14.0 * px);
    }
    if (top_px > 0.0) bands.top_px = std::max(bands.top_px, rows(room.margin_px)) + rows(top_px);
    if (bottom_px > 0.0)
        bands.bottom_px = std::max(bands.bottom_px, rows(room.margin_px)) + rows(bottom_px);
    return bands;
}

}  // namespace

OverlayBands overlay_bands(const StageContext& stage, TextCache& text) {
    return overlay_bands(stage.scene, OverlayRoom(stage), text);
}

int rows_of_overlays(const Scene& scene, const FontSource& fonts, int width_px, double px,
                     const LeastSizes& least) {
    TextCache type_case(fonts, 1, least);
    const OverlayBands bands =
        overlay_bands(scene, OverlayRoom(scene, width_px, px, least, 1), type_case);
    return bands.top_px + bands.bottom_px;
}

int rows_added_by_type(const Scene& scene, const FontSource& fonts, int width_px, double px,
                       const LeastSizes& least) {
    const double screen_px = width_px / 1920.0;
    return std::max(0, rows_of_overlays(scene, fonts, width_px, px, least) -
                           rows_of_overlays(scene, fonts, width_px, screen_px, {}));
}

std::span<const OverlayName> overlays() {
    static constexpr std::array<OverlayName, 4> names{{
        {"title", "the scene's title, at the top left"},
        {"chapter", "the number and title of the current chapter, below the title"},
        {"caption", "the scene's caption, at the bottom, with live numbers"},
        {"clock", "the instant of the motion, at the top right"},
    }};
    return names;
}

bool is_overlay(std::string_view name) {
    const auto names = overlays();
    return std::any_of(names.begin(), names.end(),
                       [name](const OverlayName& overlay) { return overlay.name == name; });
}

bool is_overlay_shown(const Scene& scene, std::string_view name) {
    return name == "title"     ? wants_title(scene)
           : name == "chapter" ? wants_chapters(scene)
           : name == "caption" ? wants_caption(scene)
                               : name == "clock" && wants_clock(scene);
}

}  // namespace poinsot
