#include "orders/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "drawing/style/theme.h"
#include "encoding/quality.h"

namespace poinsot {

namespace {

// Joins the names of a table's rows: "light, dark or print".
template <typename Rows>
std::string listed(const Rows& rows) {
    std::string names;
    for (std::size_t i = 0; i < rows.size(); ++i)
        names += fmt::format("{}{}",
                             i == 0                ? ""
                             : i + 1 < rows.size() ? ", "
                                                   : " or ",
                             rows[i].name);
    return names;
}

std::vector<OptionRow> make_rows() {
    return {
        {.name = "size",
         .verbs = Verb::every_drawing | Verb::check | Verb::submit | Verb::tradeoff,
         .takes = "WxH",
         .help = "picture size in pixels",
         .key = "film.size"},
        {.name = "fps",
         .verbs = Verb::film | Verb::slides | Verb::check | Verb::submit,
         .takes = "N[/D]",
         .help = "video frames per second",
         .key = "film.fps"},
        {.name = "theme",
         .verbs = Verb::every_drawing | Verb::submit,
         .takes = "NAME",
         .help = listed(themes()) + ", or the path of a theme file (.toml)",
         .completes = "themes",
         .key = "theme"},
        {.name = "quality",
         .verbs = Verb::still | Verb::figure | Verb::film | Verb::slides | Verb::sheets |
                  Verb::check | Verb::submit,
         .takes = "NAME",
         .help = listed(qualities()),
         .completes = "qualities",
         .key = "film.quality"},
        {.name = "time_s",
         .verbs = Verb::still | Verb::figure | Verb::sheets,
         .takes = "T|auto",
         .help = "instant of the motion in seconds, or auto, the instant of the film at which the "
                 "arrows are farthest apart; default: film.still_s of the scene, else auto (on a "
                 "sheet: the film's last instant)",
         .wanted = "an instant in seconds, or auto",
         .slot = [](GivenOptions& given) -> OptionSlot {
             return InstantSlot{&given.time_s, &given.clearest};
         },
         .own_flag = "--time"},
        {.name = "width_mm",
         .verbs = Verb::still | Verb::figure | Verb::figure_sheet,
         .help = "width on paper in millimetres",
         .wanted = "millimetres",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.width_mm; }},
        {.name = "height_mm",
         .verbs = Verb::still | Verb::figure,
         .help = "height on paper in millimetres; default: the scene's shape",
         .wanted = "millimetres",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.height_mm; }},
        {.name = "dpi",
         .verbs = Verb::still | Verb::figure_sheet,
         .help = "dots per inch on paper; default 300",
         .wanted = "dots per inch",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.dpi; }},
        {.name = "type_pt",
         .verbs = Verb::still | Verb::figure | Verb::figure_sheet,
         .help = "size of labels on paper in points; default 8.5; line widths scale with it",
         .wanted = "points",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.type_pt; }},
        {.name = "journal",
         .verbs = Verb::still | Verb::figure,
         .takes = "NAME",
         .help = "width, type and line sizes of the journal's author pages, theme print, letters "
                 "(a), (b), … on panels, and no title, captions and clock; reports the figure's "
                 "sizes and contrasts",
         .completes = "journals",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.journal; }},
        {.name = "keep_text",
         .verbs = Verb::still | Verb::figure,
         .help = "with --journal: draw title, captions and clock, too",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.paper.keep_text; }},
        {.name = "shading",
         .verbs = Verb::figure | Verb::figure_sheet,
         .takes = "tone|none|picture",
         .help = "how vector figures fill surfaces: tone (shaded by the light, the default), none "
                 "(lines only) or picture (pixels at 600 dpi within the exact outlines)",
         .completes = "tone|none|picture",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.vectors.shading; }},
        {.name = "text",
         .verbs = Verb::figure | Verb::figure_sheet,
         .takes = "font|paths|latex",
         .help = "text in vector figures: font (real text, the default), paths, or latex (your "
                 "own LaTeX sets it, from a .tex file beside the figure)",
         .completes = "font|paths|latex",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.vectors.text; }},
        {.name = "frames",
         .verbs = Verb::film | Verb::submit,
         .takes = "A-B",
         .help = "draw only frames A to B, counted from 0",
         .slot = [](GivenOptions& given) -> OptionSlot { return FramesSlot{&given.frames}; }},
        {.name = "backend",
         .verbs = Verb::every_drawing | Verb::submit | Verb::tradeoff | Verb::rerender,
         .takes = "NAME",
         .help = "auto, osmesa or egl (software), or gpu",
         .completes = "auto|osmesa|egl|gpu",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.context.backend; }},
        {.name = "portable",
         .verbs = Verb::every_drawing,
         .help = "write the same bytes on every x86-64 processor",
         .slot = [](GivenOptions& given) -> OptionSlot { return &given.context.portable; }},
    };
}

}  // namespace

std::string OptionRow::flag() const {
    if (!own_flag.empty()) return std::string(own_flag);
    std::string flag = fmt::format("--{}", name);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

std::span<const OptionRow> option_rows() {
    static const std::vector<OptionRow> rows = make_rows();
    return rows;
}

bool is_given(const OptionRow& row, const GivenOptions& given) {
    if (row.slot == nullptr) return is_given(given.overrides, row.key);
    GivenOptions chosen = given, defaults;
    const OptionSlot of_default = row.slot(defaults);
    const auto differs = [&]<typename Slot>(const Slot& slot) {
        if constexpr (std::is_same_v<Slot, InstantSlot>)
            return slot.time_s->has_value() || *slot.clearest;
        else if constexpr (std::is_same_v<Slot, FramesSlot>)
            return slot.frames->has_value();
        else
            return *slot != *std::get<Slot>(of_default);
    };
    return std::visit(differs, row.slot(chosen));
}

SceneRequest scene_request_of(std::string file, const GivenOptions& given,
                              const std::vector<Override>& more_overrides) {
    SceneRequest request{.file = std::move(file),
                         .overrides = given.overrides,
                         .outside = outside_files(given.allow_outside)};
    request.overrides.insert(request.overrides.end(), more_overrides.begin(), more_overrides.end());
    return request;
}

OutsideFiles outside_files(bool allow_outside) {
    return allow_outside ? OutsideFiles::allowed : OutsideFiles::refused;
}

PrintChoices print_choices(const library::PaperOptions& paper) {
    return {.width_mm = paper.width_mm,
            .height_mm = paper.height_mm,
            .dpi = paper.dpi,
            .type_pt = paper.type_pt,
            .journal = paper.journal};
}

ContextChoice context_choice_of(const GivenOptions& given) {
    return context_choice(given.context.backend, given.context.portable);
}

}  // namespace poinsot
