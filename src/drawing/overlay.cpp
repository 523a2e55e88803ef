#include "drawing/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/fade.h"
#include "drawing/time_unit.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// Running text at a corner of the picture; its pen starts at whole pixels.
void add_text(const StageData& stage, const SetType& type, double pen_x, double baseline_y,
              Sheet& sheet) {
    if (type.mask->width == 0) return;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {std::round(pen_x) + type.left_px,
                         std::round(baseline_y) - type.baseline_px};
    label.colour = stage.theme->text;
    label.halo_colour = stage.theme->halo;
    label.halo_px = 2.0 * stage.px;
    sheet.view.labels.push_back(label);
}

double margin(const StageData& stage) { return 40.0 * stage.px; }

TypeStyle text_style(const StageData& stage, double size) {
    return {.size_px = size * stage.px,
            .mode = TypeMode::text,
            .max_width_px = std::max(64.0, stage.options.width_px - 2.0 * margin(stage))};
}

Drawer make_title(StageData& stage) {
    const SetType type = at_scene_key(stage.scene, "title", [&] {
        return stage.type_case.set(stage.scene.title, text_style(stage, 40.0));
    });
    return [&stage, type](const Instant&, Sheet& sheet) {
        add_text(stage, type, margin(stage), margin(stage) + type.baseline_px, sheet);
    };
}

Drawer make_caption(StageData& stage) {
    const TypeStyle style = text_style(stage, 26.0);
    const auto place = [&stage](const SetType& type, Sheet& sheet) {
        const double top = stage.options.height_px - margin(stage) - type.mask->height;
        add_text(stage, type, margin(stage), top + type.baseline_px, sheet);
    };
    // Set once here in any case, so that a caption that does not parse is refused before the first
    // frame.
    const SetType type = at_scene_key(stage.scene, "caption", [&] {
        return stage.type_case.set(expand_live_text(stage.scene.caption, stage.live_values({})),
                                   style);
    });
    if (!is_live(stage.scene.caption)) {
        return [place, type](const Instant&, Sheet& sheet) { place(type, sheet); };
    }
    return [&stage, style, place](const Instant& instant, Sheet& sheet) {
        const auto values = stage.live_values(instant);
        place(stage.type_case.set_live(expand_live_text(stage.scene.caption, values), style,
                                       sheet.view),
              sheet);
    };
}

Drawer make_clock(StageData& stage) {
    const TimeUnit unit = time_unit_of(stage.film_last_s - stage.film_first_s);
    return [&stage, unit](const Instant& instant, Sheet& sheet) {
        const LiveValue time{"time", instant.time_s / unit.seconds};
        const SetType type = stage.type_case.set_live(
            expand_live_text(fmt::format("$t$ = {{time:.2f}} {}", unit.name), {&time, 1}),
            text_style(stage, 26.0), sheet.view);
        // Right-aligned on the widest text of its kind, so that changing digits do not move it.
        const double pen = stage.options.width_px - margin(stage) - 160.0 * stage.px;
        add_text(stage, type, pen, margin(stage) + 26.0 * stage.px, sheet);
    };
}

bool wants(const StageData& stage, const char* name) {
    const auto& show = stage.scene.show;
    return show.empty() || std::find(show.begin(), show.end(), name) != show.end();
}

// A loop has no first instant for a clock to count from, unless the scene wants one all the same.
bool wants_clock(const StageData& stage) {
    if (stage.options.loop_s > 0.0 && stage.scene.show.empty()) return false;
    return wants(stage, "clock");
}

}  // namespace

std::vector<Drawer> make_overlays(StageData& stage) {
    std::vector<Drawer> overlays;
    if (!stage.scene.title.empty() && wants(stage, "title")) {
        overlays.push_back(fading(stage, "title", make_title(stage)));
    }
    if (!stage.scene.caption.empty() && wants(stage, "caption")) {
        overlays.push_back(fading(stage, "caption", make_caption(stage)));
    }
    if (wants_clock(stage)) overlays.push_back(fading(stage, "clock", make_clock(stage)));
    return overlays;
}

OverlayBands overlay_bands(StageData& stage) {
    OverlayBands bands;
    const bool title = !stage.scene.title.empty() && wants(stage, "title");
    if (title || wants_clock(stage)) {
        bands.top_px =
            static_cast<int>(std::ceil(margin(stage) + (title ? 56.0 : 40.0) * stage.px));
    }
    if (!stage.scene.caption.empty() && wants(stage, "caption")) {
        // Live numbers change the text's width, and its lines hardly ever.
        const auto values = stage.live_values({});
        const SetType type = stage.type_case.set(expand_live_text(stage.scene.caption, values),
                                                 text_style(stage, 26.0));
        bands.bottom_px =
            static_cast<int>(std::ceil(margin(stage) + type.mask->height + 18.0 * stage.px));
    }
    return bands;
}

bool is_overlay(std::string_view name) {
    return name == "title" || name == "caption" || name == "clock";
}

}  // namespace poinsot
