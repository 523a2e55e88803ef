// The panels of a stage in the cells of their grid, and what keyframes and fades need of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/fade.h"
#include "drawing/panel.h"
#include "drawing/stage_data.h"
#include "drawing/type/overlay.h"
#include "scene/scene_error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

// The panels of a scene that names none: the one that suits its motion.
std::vector<PanelSpec> panels_of(const StageData& stage) {
    if (!stage.scene.panels.empty()) return stage.scene.panels;
    PanelSpec alone;
    alone.kind = default_panel(stage);
    return {alone};
}

// Boundaries of the columns or rows in pixels, by their relative sizes; whole, also in the picture
// that is looked at (`step_px`), and the last one is the end of the room that they share.
std::vector<int> boundaries(const std::vector<double>& sizes, int from_px, int total_px,
                            int step_px) {
    double sum = 0.0;
    for (const double size : sizes) sum += size;
    std::vector<int> edges{from_px};
    double at = 0.0;
    for (const double size : sizes) {
        at += size;
        edges.push_back(from_px +
                        step_px * static_cast<int>(std::lround(at / sum * total_px / step_px)));
    }
    return edges;
}

PanelBox box_of(const PanelSpec& spec, const std::vector<int>& columns,
                const std::vector<int>& rows) {
    const auto at = [](const std::vector<int>& edges, int i) {
        return edges[static_cast<std::size_t>(i)];
    };
    PanelBox box;
    box.x_px = at(columns, spec.column);
    box.y_px = at(rows, spec.row);
    box.width_px = at(columns, spec.column + spec.columns) - box.x_px;
    box.height_px = at(rows, spec.row + spec.rows) - box.y_px;
    return box;
}

// Lines of a panel shrink with it, but less than it does; its type shrinks less still, and not
// below what can be read.
double line_scale(const PanelBox& box, const StageOptions& options) {
    const double share =
        std::min(1.0 * box.height_px / options.height_px, 1.5 * box.width_px / options.width_px);
    return std::sqrt(std::min(1.0, share));
}
constexpr double least_type_share = 0.72;
constexpr double least_type_px = 0.36;  // a label of 12 px
constexpr double header_share = 0.85;

// A picture in which six such labels would not stand one above another is for its shapes alone:
// type shrinks with it until it is left out.
bool has_type(const StageOptions& options) {
    constexpr int least_side_px = 72;
    return std::min(options.width_px, options.height_px) >= least_side_px * options.samples;
}

// The name of a panel in its upper left corner.
Drawer header_of(Panel& panel, std::string_view text) {
    // One size for all, whatever their panels have.
    const StageData& stage = *panel.stage;
    const double size =
        24.0 * std::max(header_share * stage.px, least_type_px * stage.options.samples);
    const SetType type =
        panel.stage->type_case.set(text, {.size_px = size, .mode = TypeMode::text});
    panel.header_px = 1.7 * size;
    // In the first column it stands below the title.
    const double left =
        panel.box.x_px == 0 ? overlay_margin * panel.stage->px : panel.box.x_px + 0.7 * size;
    return [&panel, &stage, type, size, left](const Instant&, Sheet& sheet) {
        Label label;
        label.mask = type.mask;
        label.top_left_px = {
            stage.at_whole_pixel(left) + type.left_px,
            stage.at_whole_pixel(panel.box.y_px + 0.4 * size + size) - type.baseline_px};
        label.colour = panel.stage->theme->text;
        label.halo_colour = panel.stage->theme->halo;
        label.halo_px = 2.0 * panel.px;
        label.opacity = 0.75;
        if (type.mask->width > 0) sheet.view.labels.push_back(label);
    };
}

// Refuses cells in which nothing can be seen.
void check_room(const Scene& scene, const PanelBox& box, std::size_t panel) {
    constexpr int least_px = 8;
    if (scene.panels.size() < 2 || std::min(box.width_px, box.height_px) >= least_px) return;
    throw SceneError(scene.location_of(fmt::format("panels[{}]", panel)),
                     fmt::format("panels[{}] gets {}x{} pixels of the picture, title and caption "
                                 "taken off; a panel needs {} a side: make the picture larger, or "
                                 "the grid coarser",
                                 panel, box.width_px, box.height_px, least_px));
}

bool says_camera(const KeyframeSpec& key) {
    return key.azimuth_deg || key.elevation_deg || key.distance || key.field_deg || key.target ||
           !key.look_at.empty();
}

}  // namespace

void StageData::check_fades() const {
    for (std::size_t i = 0; i < scene.fades.size(); ++i) {
        for (const std::string& name : scene.fades[i].elements) {
            if (can_fade.contains(name)) continue;
            const std::vector<std::string_view> known(can_fade.begin(), can_fade.end());
            throw SceneError(
                scene.location_of(fmt::format("fades[{}].elements", i)),
                fmt::format("nothing shown is called \"{}\"{}; here fade: {}", printable(name),
                            did_you_mean(name, known), fmt::join(known, ", ")));
        }
    }
}

void StageData::check_keyframes() const {
    const auto moves = [](const Panel& panel) { return panel.camera_at != nullptr; };
    if (!timeline.camera_moves() || std::any_of(panels.begin(), panels.end(), moves)) return;
    for (std::size_t i = 0; i < scene.keyframes.size(); ++i) {
        if (!says_camera(scene.keyframes[i])) continue;
        throw SceneError(
            scene.location_of(fmt::format("keyframes[{}]", i)),
            fmt::format("keyframes[{}] moves the camera, but every panel here is seen "
                        "from where it always is; add a panel \"space\", \"object\" or "
                        "\"top\", or leave the camera out",
                        i));
    }
}

void StageData::make_panels() {
    const std::vector<PanelSpec> specs = panels_of(*this);

    // Several panels, and those that fill their box, leave the title and the caption their room.
    PanelBox room{0, 0, options.width_px, options.height_px};
    if (specs.size() > 1 || panel_kind_named(specs.front().kind).fills) {
        const OverlayBands bands = overlay_bands(*this);
        room.y_px = bands.top_px;
        room.height_px = std::max(1, options.height_px - bands.top_px - bands.bottom_px);
    }
    const std::vector<int> columns =
        boundaries(scene.grid.columns, room.x_px, room.width_px, options.samples);
    const std::vector<int> rows =
        boundaries(scene.grid.rows, room.y_px, room.height_px, options.samples);
    for (const PanelSpec& spec : specs) {
        // By its address: to g++ 14 a reference may be to what was only lent for the call.
        const PanelKind& kind =
            *at_scene_key(scene, "panels", [&spec] { return &panel_kind_named(spec.kind); });
        if (!kind.possible(*this)) {
            const bool rests = motion.motion().problem().start.omega_body.isZero(0.0);
            throw SceneError(scene.location_of(rests ? "start.omega_rad_s" : "panels"),
                             rests ? "omega_rad_s is zero, and a body at rest has no invariable "
                                     "plane; give it a spin"
                                   : "panel \"" + spec.kind + "\" needs " +
                                         std::string(kind.needs) + "; choose another panel");
        }
        Panel& panel = panels.emplace_back();
        panel.stage = this;
        panel.spec = spec;
        panel.light = theme->light;
        panel.box = box_of(spec, columns, rows);
        check_room(scene, panel.box, static_cast<std::size_t>(&spec - specs.data()));
        const double share = line_scale(panel.box, options);
        panel.px = px * share;
        panel.type_px = has_type(options) ? std::max(px * std::max(share, least_type_share),
                                                     least_type_px * options.samples)
                                          : px * share;
        Drawer header;
        if (specs.size() > 1)
            header = header_of(panel, spec.title.value_or(std::string(kind.title)));
        if (spec.quantity.empty()) {
            kind.make(panel);
        } else {
            // What a chart refuses is its quantity.
            at_scene_key(scene, fmt::format("panels[{}].quantity", &spec - specs.data()),
                         [&] { kind.make(panel); });
        }
        asks = united(asks, panel.asks);
        shows_beside = shows_beside || panel.shows_beside;
        if (header) {
            panel.draw = [header, draw = std::move(panel.draw)](const Instant& instant,
                                                                Sheet& sheet) {
                draw(instant, sheet);
                header(instant, sheet);
            };
        }
        panel.draw = fading(*this, spec.kind, std::move(panel.draw));
    }
}

}  // namespace poinsot
