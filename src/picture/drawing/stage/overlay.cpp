#include "drawing/stage/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "drawing/stage/fade.h"
#include "drawing/stage/live_values.h"
#include "drawing/stage/thing_names.h"
#include "drawing/stage/type/clock_text.h"
#include "drawing/stage/type/scene_symbols.h"
#include "drawing/stage/type/time_unit.h"
#include "drawing/style/theme_contrast.h"
#include "drawing/style/theme_roles.h"
#include "numerics/smooth_step.h"
#include "scene/film_clock.h"
#include "scene/scene_error.h"
#include "text/languages.h"

namespace poinsot {

namespace {

// If one panel fills the picture and its camera moves close, its figure may run under the title and
// the captions: then their letters get a wide halo.
class WideHalo {
 public:
    WideHalo(const StageContext& stage, const std::deque<Panel>& panels) {
        const bool runs_under = panels.size() == 1 &&
                                panels.front().box.height_px == stage.options.height_px &&
                                stage.theme.background.alpha >= 1.0;
        if (runs_under) timeline_ = &timeline_of(panels.front());
    }

    // 0 while the camera frames the figure, 1 if the camera is aimed by hand.
    double presence(double film_s) const {
        return timeline_ != nullptr ? 1.0 - timeline_->camera_at(film_s).framing : 0.0;
    }

 private:
    const Timeline* timeline_ = nullptr;
};

// The terms of captions that have the colours of what they name, and these colours.
struct CaptionColours {
    std::vector<CaptionTerm> terms;
    std::vector<Colour> inks;

    explicit CaptionColours(const StageContext& stage) {
        const Theme& theme = stage.theme;
        const auto add = [&](std::string text, bool is_formula, const Colour& line) {
            if (terms.size() == most_inks) return;
            terms.push_back({std::move(text), is_formula});
            inks.push_back(letter_colour(theme, line));
        };
        const auto add_symbol = [&](std::string_view symbol, const Colour& line) {
            add(named_by_scene(stage.scene, symbol), true, line);
        };
        add_symbol("\\boldsymbol{\\omega}", theme.omega);
        add_symbol("\\boldsymbol{\\rho}", theme.rho);
        for (std::size_t i = 0; i < 3; ++i)
            add_symbol(fmt::format("\\mathbf{{e}}_{}", i + 1), theme.axes[i]);
        add_symbol("\\nabla F", theme.gradient);
        add_symbol("\\mathbf{N}", theme.torque);
        for (ThingWords& words : words_of_things(stage.scene))
            add(std::move(words.text), false, line_of(theme, words.role));
    }
};

// Text at a corner of the picture.
struct OverlayText {
    TextBlock type;
    double pen_x = 0.0, baseline_y = 0.0;  // may be between pixels
    LabelRank rank = rank_of_caption;
    double halo_width = 0.0;  // of a wide halo, 0…1
};

void add_text(const StageContext& stage, const OverlayText& text, ViewBuilder& builder,
              const std::vector<Colour>& inks = {}) {
    const TextBlock& type = text.type;
    if (type.mask->width == 0) return;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {stage.at_whole_pixel(text.pen_x) + type.left_px,
                         stage.at_whole_pixel(text.baseline_y) - type.baseline_px};
    label.colour = stage.theme.text;
    label.halo_colour = stage.theme.halo;
    label.halo_px = (2.0 + 10.0 * text.halo_width) * stage.px;
    label.over_figure = text.halo_width > 0.0;
    label.held_at = 0.0;
    label.rank = text.rank;
    if (!type.mask->tints.empty()) label.inks = inks;
    builder.view.labels.push_back(label);
}

// The picture in which overlays are set.
struct OverlayRoom {
    int width_px = 0;
    double px = 1.0;       // width of a line of one pixel at 1080 rows
    double type_px = 1.0;  // the same for text
    double margin_px = 0.0;
    int samples = 1;  // samples × samples per pixel
    bool on_paper = false;

    OverlayRoom(const Scene& scene, int width, double line_px, const LeastSizes& least,
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
    explicit OverlayRoom(const StageContext& stage)
        : OverlayRoom(stage.scene, stage.options.width_px, stage.px, stage.options.least,
                      stage.options.samples) {}
};

double margin(const StageContext& stage) { return OverlayRoom(stage).margin_px; }

using TypeSize = double TypeSizes::*;
constexpr TypeSize title_size = &TypeSizes::title;
constexpr TypeSize chapter_size = &TypeSizes::chapter;
constexpr TypeSize caption_size = &TypeSizes::caption;

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

// The style of text wrapped to a picture.
TypeStyle text_style(const Scene& scene, const OverlayRoom& room, TypeSize size) {
    return {.size_px = em_px(scene, room, size),
            .mode = TypeMode::text,
            .max_width_px = std::max(64.0 * room.samples, room.width_px - 2.0 * room.margin_px)};
}
TypeStyle text_style(const StageContext& stage, TypeSize size) {
    return text_style(stage.scene, OverlayRoom(stage), size);
}

using ClockFace = std::function<std::string(double time_s)>;
ClockFace clock_face(const StageContext& stage) {
    return [text = ClockText(stage.film_first_s, stage.film_last_s),
            mark = decimal_mark_of(stage.scene.language)](double time_s) {
        return with_decimal_mark(text.at(time_s), mark);
    };
}

// The left end of the clock. There is space for its widest text, so that it does not move as digits
// change: all digits have the same width.
double left_of_clock(const StageContext& stage, StageStore& store) {
    double widest_px = 160.0 * stage.px;
    for (const double time_s : {stage.film_first_s, stage.film_last_s}) {
        const TextBlock type =
            store.set(clock_face(stage)(time_s), text_style(stage, caption_size));
        widest_px = std::max(widest_px, static_cast<double>(type.left_px + type.mask->width));
    }
    return stage.options.width_px - margin(stage) - widest_px;
}

bool wants(const Scene& scene, const char* name) {
    const auto& show = scene.show;
    if (!scene.overlays) return false;
    return show.empty() || std::find(show.begin(), show.end(), name) != show.end();
}

// By default a loop has no clock, since it has no first instant.
bool wants_clock(const Scene& scene) {
    if (scene.clock && scene.overlays) return *scene.clock;
    if (!scene.film.loop.empty() && scene.show.empty()) return false;
    return wants(scene, "clock");
}

// The style of the title. Where the clock stands beside it, its type is smaller if it is too long,
// as in an upright picture.
TypeStyle title_style(const StageContext& stage, StageStore& store) {
    TypeStyle style = text_style(stage, title_size);
    if (!wants_clock(stage.scene) || is_on_paper(stage)) return style;
    constexpr double least_share = 0.55;  // still larger than the headings of panels
    const double gap_px = 0.8 * style.size_px;
    const double room_px = left_of_clock(stage, store) - margin(stage) - gap_px;
    TypeStyle one_line = style;
    one_line.max_width_px = 0.0;
    const double width_px = store.set(stage.scene.title, one_line).width_px();
    if (width_px <= room_px) return style;
    style.size_px *= std::max(least_share, room_px / width_px);
    style.max_width_px = std::max(64.0 * stage.options.samples, room_px + 0.5 * gap_px);
    return style;
}

Drawer make_title(const StageContext& stage, StageStore& store, const WideHalo& halo) {
    const TextBlock type = at_scene_key(stage.scene, "title", [&] {
        return store.set(stage.scene.title, title_style(stage, store));
    });
    return [&stage, type, halo](const FrameInput& instant, ViewBuilder& builder) {
        add_text(stage,
                 {.type = type,
                  .pen_x = margin(stage),
                  .baseline_y = margin(stage) + type.baseline_px,
                  .rank = rank_of_title,
                  .halo_width = halo.presence(instant.film_s)},
                 builder);
    };
}

Drawer make_clock(const StageContext& stage, StageStore& store, const WideHalo& halo) {
    const ClockFace clock = clock_face(stage);
    const TypeStyle style = text_style(stage, caption_size);
    const double pen = left_of_clock(stage, store);
    const double baseline = margin(stage) + std::max(style.size_px, stage.options.least.type_px);
    return [&stage, halo, clock, style, pen, baseline, &text = std::as_const(store).text()](
               const FrameInput& instant, ViewBuilder& builder) {
        const TextBlock type = text.set_live(clock(instant.time_s), style, builder.view);
        add_text(stage,
                 {.type = type,
                  .pen_x = pen,
                  .baseline_y = baseline,
                  .rank = rank_of_clock,
                  .halo_width = halo.presence(instant.film_s)},
                 builder);
    };
}

// A caption in lines of nearly equal length, as few as fit.
struct BalancedText {
    TextBlock type;  // with the numbers of no instant
    TypeStyle style, widest;

    BalancedText(const StageContext& stage, StageStore& store, const std::string& key,
                 std::string_view caption, const TypeStyle& style_)
        : style(style_), widest(style_) {
        const std::string text = live_text(stage.scene, caption, {});
        type = at_scene_key(stage.scene, key, [&] {
            style.max_width_px = store.text().balanced_width_px(text, widest);
            return store.set(text, style);
        });
    }

    // With other numbers: in the same lines, unless they need more space.
    TextBlock live(const TextCache& cache, std::string_view text, View& view) const {
        const TextBlock set = cache.set_live(text, style, view);
        if (set.height_px() < 1.3 * type.height_px()) return set;
        return cache.set_live(text, widest, view);
    }
};

Drawer make_caption(const StageContext& stage, StageStore& store, const WideHalo& halo) {
    CaptionColours colours(stage);
    TypeStyle style = text_style(stage, caption_size);
    style.terms = store.keep(std::move(colours.terms));
    const auto place = [&stage, halo, inks = std::move(colours.inks)](
                           const TextBlock& type, const FrameInput& instant, ViewBuilder& builder) {
        const double below = type.height_px() - type.baseline_px;
        add_text(stage,
                 {.type = type,
                  .pen_x = margin(stage),
                  .baseline_y = stage.options.height_px - margin(stage) - below,
                  .rank = rank_of_caption,
                  .halo_width = halo.presence(instant.film_s)},
                 builder, inks);
    };
    // Always set here, so that an invalid caption is rejected before the first frame.
    const BalancedText balanced(stage, store, "caption", stage.scene.caption, style);
    if (!changes(stage.scene, stage.scene.caption)) {
        return [place, type = balanced.type](const FrameInput& instant, ViewBuilder& builder) {
            place(type, instant, builder);
        };
    }
    return [&stage, balanced, place, &text = std::as_const(store).text()](const FrameInput& instant,
                                                                          ViewBuilder& builder) {
        place(
            balanced.live(text, live_text(stage.scene, stage.scene.caption, instant), builder.view),
            instant, builder);
    };
}

// A caption or a chapter's title, and the part of the film in which it is shown.
struct TimedText {
    double begin_s = 0.0, end_s = 0.0;

    // Opacity.
    double presence(double film_s) const {
        const double ramp_s = text_fade_s(begin_s, end_s);
        const double in = (film_s - begin_s) / ramp_s;
        const double out = (end_s - film_s) / ramp_s;
        return smooth_step(std::min(in, out));
    }
};

// In a still, text is whole or absent.
double presence_of(const TimedText& text, const StageContext& stage, const FrameInput& instant) {
    const double presence = text.presence(instant.film_s);
    return stage.options.is_still ? whole_or_absent(presence) : presence;
}

// One of [[captions]], set.
struct TimedCaption : TimedText {
    const TimedCaptionSpec* spec = nullptr;
    std::optional<BalancedText> text;
};

bool wants_title(const Scene& scene) { return !scene.title.empty() && wants(scene, "title"); }
bool wants_caption(const Scene& scene) { return !scene.caption.empty() && wants(scene, "caption"); }
bool wants_chapters(const Scene& scene) {
    return !scene.chapters.empty() && wants(scene, "chapter");
}

// The top of the first line below the title.
double below_title(const Scene& scene, const OverlayRoom& room) {
    return room.margin_px + (wants_title(scene) ? 1.55 * em_px(scene, room, title_size) : 0.0);
}
// Below the titles of the chapters, if they are shown.
double below_chapters(const Scene& scene, const OverlayRoom& room) {
    return below_title(scene, room) +
           (wants_chapters(scene) ? 1.6 * em_px(scene, room, chapter_size) : 0.0);
}

// Sets the title of a chapter with the number under which players list it.
TextBlock set_chapter(const Scene& scene, std::size_t i, TextCache& text, const TypeStyle& style) {
    return at_scene_key(scene, fmt::format("chapters[{}].title", i), [&] {
        return text.set(fmt::format("{}  {}", i + 1, scene.chapters[i].title), style);
    });
}

Drawer make_chapters(const StageContext& stage, StageStore& store, const WideHalo& halo) {
    const Scene& scene = stage.scene;
    struct Chapter : TimedText {
        TextBlock type;
    };
    std::vector<Chapter> chapters;
    const double film_end_s = FilmClock(scene).length_s().value_or(default_film_s);
    for (std::size_t i = 0; i < scene.chapters.size(); ++i) {
        Chapter chapter;
        chapter.begin_s = scene.chapters[i].at_s;
        // The last one stays to the end.
        chapter.end_s = i + 1 < scene.chapters.size() ? scene.chapters[i + 1].at_s
                                                      : std::max(film_end_s, chapter.begin_s) + 1.0;
        chapter.type = set_chapter(scene, i, store.text(), text_style(stage, chapter_size));
        chapters.push_back(chapter);
    }
    const double top = below_title(scene, OverlayRoom(stage));
    return [&stage, halo, chapters, top](const FrameInput& instant, ViewBuilder& builder) {
        for (const Chapter& chapter : chapters) {
            const double presence = presence_of(chapter, stage, instant);
            if (!(presence > 0.0) || chapter.type.mask->width == 0) continue;
            add_text(stage,
                     {.type = chapter.type,
                      .pen_x = margin(stage),
                      .baseline_y = top + chapter.type.baseline_px,
                      .rank = rank_of_caption,
                      .halo_width = halo.presence(instant.film_s)},
                     builder);
            builder.view.labels.back().opacity *= presence;
        }
    };
}

// The top of the scene's own caption, or the picture's lower margin.
double bottom_of_captions(const StageContext& stage, const TypeStyle& style) {
    double bottom = stage.options.height_px - margin(stage);
    const Scene& scene = stage.scene;
    if (!wants_caption(scene)) return bottom;
    TextCache type_case(stage.options.fonts, stage.options.samples, stage.options.least);
    const TextBlock type = type_case.set(live_text(scene, scene.caption, {}), style);
    return bottom - type.height_px() - 14.0 * stage.px;
}

Drawer make_timed_captions(const StageContext& stage, StageStore& store, const WideHalo& halo) {
    const Scene& scene = stage.scene;
    CaptionColours colours(stage);
    TypeStyle style = text_style(stage, caption_size);
    style.terms = store.keep(std::move(colours.terms));
    std::vector<TimedCaption> captions;
    for (std::size_t i = 0; i < scene.captions.size(); ++i) {
        TimedCaption caption;
        caption.spec = &scene.captions[i];
        const auto [begin_s, end_s] = caption_span(scene, i);
        caption.begin_s = begin_s;
        caption.end_s = end_s;
        caption.text.emplace(stage, store, fmt::format("captions[{}].text", i), caption.spec->text,
                             style);
        captions.push_back(caption);
    }
    const double foot = bottom_of_captions(stage, style);
    const double head = below_chapters(scene, OverlayRoom(stage));
    return [&stage, halo, captions, foot, head, inks = std::move(colours.inks),
            &text = std::as_const(store).text()](const FrameInput& instant, ViewBuilder& builder) {
        for (const TimedCaption& caption : captions) {
            const double presence = presence_of(caption, stage, instant);
            if (!(presence > 0.0)) continue;
            const TextBlock type =
                !changes(stage.scene, caption.spec->text)
                    ? caption.text->type
                    : caption.text->live(text, live_text(stage.scene, caption.spec->text, instant),
                                         builder.view);
            const double baseline = caption.spec->place == "top"
                                        ? head + type.baseline_px
                                        : foot - (type.height_px() - type.baseline_px);
            const std::size_t n_before = builder.view.labels.size();
            add_text(stage,
                     {.type = type,
                      .pen_x = margin(stage),
                      .baseline_y = baseline,
                      .rank = rank_of_caption,
                      .halo_width = halo.presence(instant.film_s)},
                     builder, inks);
            if (builder.view.labels.size() > n_before)
                builder.view.labels.back().opacity *= presence;
        }
    };
}

}  // namespace

// A third of a second, or of the text's duration.
double text_fade_s(double begin_s, double end_s) { return std::min(0.33, (end_s - begin_s) / 3.0); }

std::vector<Drawer> make_overlays(const StageContext& stage, StageStore& store,
                                  const std::deque<Panel>& panels) {
    std::vector<Drawer> overlays;
    const WideHalo halo(stage, panels);
    if (wants_title(stage.scene))
        overlays.push_back(fading(stage, store, "title", make_title(stage, store, halo)));
    if (wants_chapters(stage.scene))
        overlays.push_back(fading(stage, store, "chapter", make_chapters(stage, store, halo)));
    if (wants_caption(stage.scene))
        overlays.push_back(fading(stage, store, "caption", make_caption(stage, store, halo)));
    if (!stage.scene.captions.empty() && stage.scene.overlays)
        overlays.push_back(make_timed_captions(stage, store, halo));
    if (wants_clock(stage.scene))
        overlays.push_back(fading(stage, store, "clock", make_clock(stage, store, halo)));
    return overlays;
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

double overlay_margin_px(const StageContext& stage) { return margin(stage); }

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

std::vector<std::string> caption_notes(const Scene& scene) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& key, std::string_view text) {
        const auto of_text = at_scene_key(
            scene, key, [&] { return unit_notes(text, live_values(scene, {}, text)); });
        for (const std::string& note : of_text)
            notes.push_back(fmt::format("{}{}: {}", scene.where(key), key, note));
    };
    if (wants_caption(scene)) add("caption", scene.caption);
    for (std::size_t i = 0; i < scene.captions.size(); ++i)
        add(fmt::format("captions[{}].text", i), scene.captions[i].text);
    return notes;
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
