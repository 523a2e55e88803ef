#include "drawing/type/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/fade.h"
#include "drawing/type/clock_text.h"
#include "drawing/type/time_unit.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// Running text at a corner of the picture; its pen starts between pixels.
void add_text(const StageData& stage, const SetType& type, double pen_x, double baseline_y,
              Sheet& sheet) {
    if (type.mask->width == 0) return;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {stage.at_whole_pixel(pen_x) + type.left_px,
                         stage.at_whole_pixel(baseline_y) - type.baseline_px};
    label.colour = stage.theme->text;
    label.halo_colour = stage.theme->halo;
    label.halo_px = 2.0 * stage.px;
    sheet.view.labels.push_back(label);
}

// px: of a line of one pixel at 1080 rows.
double margin(double px) { return overlay_margin * px; }
double margin(const StageData& stage) { return margin(stage.px); }

constexpr double title_size = 40.0;
constexpr double caption_size = 26.0;

// Wrapped to a picture so wide, of so many samples to a pixel's side.
TypeStyle text_style(int width_px, double px, double size, int samples) {
    return {.size_px = size * px,
            .mode = TypeMode::text,
            .max_width_px = std::max(64.0 * samples, width_px - 2.0 * margin(px))};
}
TypeStyle text_style(const StageData& stage, double size) {
    return text_style(stage.options.width_px, stage.px, size, stage.options.samples);
}

Drawer make_title(StageData& stage) {
    const SetType type = at_scene_key(stage.scene, "title", [&] {
        return stage.type_case.set(stage.scene.title, text_style(stage, title_size));
    });
    return [&stage, type](const Instant&, Sheet& sheet) {
        add_text(stage, type, margin(stage), margin(stage) + type.baseline_px, sheet);
    };
}

Drawer make_caption(StageData& stage) {
    const TypeStyle style = text_style(stage, caption_size);
    const auto place = [&stage](const SetType& type, Sheet& sheet) {
        const double below = type.height_px() - type.baseline_px;
        add_text(stage, type, margin(stage), stage.options.height_px - margin(stage) - below,
                 sheet);
    };
    // Set once here in any case, so that a caption that does not parse is refused before the first
    // frame.
    const SetType type = at_scene_key(stage.scene, "caption", [&] {
        return stage.type_case.set(
            expand_live_text(stage.scene.caption, StageData::live_values(stage.scene, {})), style);
    });
    if (!is_live(stage.scene.caption)) {
        return [place, type](const Instant&, Sheet& sheet) { place(type, sheet); };
    }
    return [&stage, style, place](const Instant& instant, Sheet& sheet) {
        const auto values = StageData::live_values(stage.scene, instant);
        place(stage.type_case.set_live(expand_live_text(stage.scene.caption, values), style,
                                       sheet.view),
              sheet);
    };
}

Drawer make_clock(StageData& stage) {
    const ClockText clock(stage.film_first_s, stage.film_last_s);
    const TypeStyle style = text_style(stage, caption_size);
    // It begins where the widest text of its kind ends at the margin, so that changing digits do
    // not move it: digits are of one width.
    double widest_px = 160.0 * stage.px;
    for (const double time_s : {stage.film_first_s, stage.film_last_s}) {
        const SetType type = stage.type_case.set(clock.at(time_s), style);
        widest_px = std::max(widest_px, static_cast<double>(type.left_px + type.mask->width));
    }
    const double pen = stage.options.width_px - margin(stage) - widest_px;
    return [&stage, clock, style, pen](const Instant& instant, Sheet& sheet) {
        const SetType type = stage.type_case.set_live(clock.at(instant.time_s), style, sheet.view);
        add_text(stage, type, pen, margin(stage) + 26.0 * stage.px, sheet);
    };
}

bool wants(const Scene& scene, const char* name) {
    const auto& show = scene.show;
    return show.empty() || std::find(show.begin(), show.end(), name) != show.end();
}

// A loop has no first instant for a clock to count from, unless the scene wants one all the same.
bool wants_clock(const Scene& scene) {
    if (!scene.film.loop.empty() && scene.show.empty()) return false;
    return wants(scene, "clock");
}

bool wants_title(const Scene& scene) { return !scene.title.empty() && wants(scene, "title"); }
bool wants_caption(const Scene& scene) { return !scene.caption.empty() && wants(scene, "caption"); }

}  // namespace

std::vector<Drawer> make_overlays(StageData& stage) {
    std::vector<Drawer> overlays;
    if (wants_title(stage.scene)) {
        overlays.push_back(fading(stage, "title", make_title(stage)));
    }
    if (wants_caption(stage.scene)) {
        overlays.push_back(fading(stage, "caption", make_caption(stage)));
    }
    if (wants_clock(stage.scene)) overlays.push_back(fading(stage, "clock", make_clock(stage)));
    return overlays;
}

// `type_case` sets for a picture of so many samples to a pixel's side.
OverlayBands overlay_bands(const Scene& scene, int width_px, double px, int samples,
                           TypeCase& type_case) {
    // Whole rows of the picture that is looked at, so that samples do not move its panels.
    const auto rows = [samples](double high_px) {
        return samples * static_cast<int>(std::ceil(high_px / samples));
    };
    OverlayBands bands;
    if (wants_title(scene) || wants_clock(scene)) {
        bands.top_px = rows(margin(px) + (wants_title(scene) ? 56.0 : 40.0) * px);
    }
    if (wants_title(scene)) {
        const SetType type = at_scene_key(scene, "title", [&] {
            return type_case.set(scene.title, text_style(width_px, px, title_size, samples));
        });
        bands.title_right_px = margin(px) + type.width_px();
    }
    if (wants_caption(scene)) {
        // Live numbers change the text's width, and its lines hardly ever.
        const SetType type = at_scene_key(scene, "caption", [&] {
            return type_case.set(expand_live_text(scene.caption, StageData::live_values(scene, {})),
                                 text_style(width_px, px, caption_size, samples));
        });
        bands.bottom_px = rows(margin(px) + type.height_px() + 18.0 * px);
    }
    return bands;
}

OverlayBands overlay_bands(StageData& stage) {
    return overlay_bands(stage.scene, stage.options.width_px, stage.px, stage.options.samples,
                         stage.type_case);
}

int rows_added_by_type(const Scene& scene, int width_px, double px) {
    TypeCase type_case;
    const OverlayBands bands = overlay_bands(scene, width_px, px, 1, type_case);
    const double screen_px = width_px / 1920.0;
    const OverlayBands on_screen = overlay_bands(scene, width_px, screen_px, 1, type_case);
    return std::max(0, bands.top_px + bands.bottom_px - on_screen.top_px - on_screen.bottom_px);
}

std::span<const OverlayName> overlays() {
    static constexpr std::array<OverlayName, 3> names{{
        {"title", "the scene's title, at the top left"},
        {"caption", "the scene's caption, at the foot, with live numbers"},
        {"clock", "the instant of the motion, at the top right"},
    }};
    return names;
}

bool is_overlay(std::string_view name) {
    const auto names = overlays();
    return std::any_of(names.begin(), names.end(),
                       [name](const OverlayName& overlay) { return overlay.name == name; });
}

}  // namespace poinsot
