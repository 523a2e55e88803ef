#include "drawing/stage/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/fade.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/possible_motions.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/thing_names.h"
#include "drawing/stage/type/labels.h"
#include "scene/camera_views.h"
#include "scene/scene_error.h"
#include "text/languages.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Boundaries of the columns or rows in pixels, in proportion to their relative sizes; multiples of
// `step_px`, so that they are whole final pixels. The last one is the end of the available length.
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

// Scale of a panel's lines: they shrink less than the panel. Text shrinks even less, and not below
// a legible size.
double line_scale(const PanelBox& box, const StageOptions& options) {
    const double share =
        std::min(1.0 * box.height_px / options.height_px, 1.5 * box.width_px / options.width_px);
    return std::sqrt(std::min(1.0, share));
}
constexpr double least_type_share = 0.8;
constexpr double least_label_share = 0.3;  // a label of 12 px
constexpr double header_share = 0.85;

// Whether a picture is high enough for six labels one above another. Smaller pictures are for
// shapes alone: text shrinks with them until it is omitted.
bool has_type(const StageOptions& options) {
    constexpr int least_side_px = 72;
    return std::min(options.width_px, options.height_px) >= least_side_px * options.samples;
}

void scale_lines_and_type(Panel& panel) {
    const StageContext& stage = *panel.stage;
    const StageOptions& options = stage.options;
    const double share = line_scale(panel.box, options);
    panel.px = stage.px * share;
    panel.type_px = has_type(options) ? std::max(stage.px * std::max(share, least_type_share),
                                                 least_label_share * options.samples)
                                      : stage.px * share;
    if (is_on_paper(stage)) panel.type_px = paper_type_px(stage);
    panel.type_px *= stage.scene.type_scale;
}

// The name of a panel in its upper left corner.
Drawer header_of(Panel& panel, StageStore& store, std::string_view text) {
    // The same size in all panels, whatever their size.
    const StageContext& stage = *panel.stage;
    const double unscaled =
        type_sizes(stage).heading *
        (is_on_paper(stage)
             ? paper_type_px(stage)
             : std::max(header_share * stage.px, least_label_share * stage.options.samples));
    const double size =
        std::max(unscaled * stage.scene.type_scale * stage.scene.style.heading_scale.value_or(1.0),
                 least_type_px(stage));
    const TextBlock type = store.set(text, {.size_px = size, .mode = TypeMode::text});
    panel.header_px = 1.7 * size;
    // In the first column it is left-aligned with the title.
    const double left =
        panel.box.x_px == 0 ? overlay_margin_px(stage) : panel.box.x_px + 0.7 * size;
    return [&panel, &stage, type, size, left](const FrameInput&, ViewBuilder& builder) {
        Label label;
        label.mask = type.mask;
        label.top_left_px = {
            stage.at_whole_pixel(left) + type.left_px,
            stage.at_whole_pixel(panel.box.y_px + 0.4 * size + size) - type.baseline_px};
        label.colour = panel.stage->theme.text;
        label.halo_colour = panel.stage->theme.halo;
        label.halo_px = 2.0 * panel.px;
        label.held_at = 0.0;
        label.rank = rank_of_headings;
        if (type.mask->width > 0) builder.view.labels.push_back(label);
    };
}

// "(a) ", "(b) ", … of a panel, in reading order, if the scene asks for letters.
std::string letter_of(const Scene& scene, const std::vector<PanelSpec>& specs, std::size_t index) {
    constexpr std::size_t n_letters = 26;
    if (!scene.panel_letters || specs.size() > n_letters) return "";
    const auto place = [](const PanelSpec& spec) { return std::pair(spec.row, spec.column); };
    const auto before = std::count_if(specs.begin(), specs.end(), [&](const PanelSpec& other) {
        return place(other) < place(specs[index]);
    });
    return fmt::format("({}) ", static_cast<char>('a' + before));
}

// Rejects a symbol that cannot be set where it is given; formulas contain it later.
void check_symbols(const Scene& scene, StageStore& store) {
    const SymbolsSpec& own = scene.symbols;
    const std::pair<const char*, const std::string&> symbols[] = {
        {"omega", own.omega}, {"momentum", own.momentum},
        {"rho", own.rho},     {"e1", own.e1},
        {"e2", own.e2},       {"e3", own.e3}};
    for (const auto& [name, symbol] : symbols)
        if (!symbol.empty())
            at_scene_key(scene, fmt::format("symbols.{}", name),
                         [&, &text = symbol] { store.text().typesetter().measure(text, {}); });
}

// A name as a heading: with a capital letter.
std::string capitalised(std::string name) {
    const auto byte = [&name](std::size_t at) { return static_cast<unsigned char>(name[at]); };
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] -= 'a' - 'A';
    // U+00E0 to U+00FE but the division sign: their capitals are 32 before them.
    const bool is_latin =
        name.size() > 1 && byte(0) == 0xc3 && byte(1) >= 0xa0 && byte(1) <= 0xbe && byte(1) != 0xb7;
    if (is_latin) name[1] = static_cast<char>(byte(1) - 0x20);
    return name;
}

// The title of a kind of panel. If it is the name of a thing, the scene may give the name.
std::string title_of(const Scene& scene, const PanelKind& kind) {
    const auto own = scene.symbols.things.find(std::string(kind.titled_after));
    if (own != scene.symbols.things.end() && !own->second.empty()) return capitalised(own->second);
    return capitalised(std::string(words_of_plane(scene, kind.titled_after, kind.title)));
}

// Rejects cells that are too small to show anything.
void check_free_space(const Scene& scene, const PanelBox& box, std::size_t panel) {
    constexpr int least_px = 8;
    if (scene.panels.size() < 2 || std::min(box.width_px, box.height_px) >= least_px) return;
    throw SceneError(scene.location_of(fmt::format("panels[{}]", panel)),
                     fmt::format("panels[{}] has {}x{} pixels without title and caption; a panel "
                                 "needs {} per side: make the picture larger, or the grid coarser",
                                 panel, box.width_px, box.height_px, least_px));
}

// The corner of a panel for its inset, outside of the overlays. Its size does not depend on theirs,
// which change with the caption.
PanelBox corner_of(const Panel& host) {
    constexpr double inset_share = 0.36;
    const StageOptions& options = host.stage->options;
    const int step_px = options.samples;
    const auto whole = [step_px](double px) { return step_px * static_cast<int>(px / step_px); };
    const std::string& corner = host.spec.inset;
    const int side_px = whole(inset_share * std::min(host.box.width_px, host.box.height_px));
    const int gap_px = whole(0.5 * overlay_margin_px(*host.stage));
    PanelBox box{host.box.x_px, host.box.y_px, side_px, side_px};
    if (corner.ends_with("right"))
        box.x_px += host.box.width_px - side_px - gap_px;
    else
        box.x_px += gap_px;
    if (corner.starts_with("top"))
        box.y_px = std::max(whole(host.box.y_px + host.header_px), host.overlays.top_px);
    else
        box.y_px = std::min(host.box.y_px + host.box.height_px,
                            options.height_px - host.overlays.bottom_px) -
                   side_px - gap_px;
    return box;
}

// A plan panel in the corner of another panel. In a picture that is too small for it there is none.
void add_inset(std::deque<Panel>& panels, std::size_t host, StageStore& store) {
    const Panel& around = panels[host];
    const StageContext& stage = *around.stage;
    const PanelKind& kind = panel_kind_named("plan");
    if (!kind.possible(stage)) {
        const std::string key = fmt::format("panels[{}].inset", host);
        throw SceneError(stage.scene.location_of(key),
                         fmt::format("{} needs {}, as panel \"{}\" does; leave it out", key,
                                     kind.requirement, kind.name));
    }
    const PanelBox box = corner_of(around);
    store.add_name("inset");
    constexpr int least_px = 24;
    if (box.width_px < least_px * stage.options.samples) return;
    const std::size_t index = panels.size();
    Panel& panel = panels.emplace_back();
    panel.stage = &stage;
    panel.spec.kind = kind.name;
    panel.spec.title = "";
    panel.light = stage.theme.light;
    panel.box = box;
    panel.overlays = around.overlays;
    panel.unit_circle = store.unit_circle();
    panel.unit_segment = store.unit_segment();
    panel.index = index;
    panel.host = host;
    scale_lines_and_type(panel);
    kind.make(panel, store);
    panel.draw = fading(stage, store, "inset", std::move(panel.draw));
    panel.draw = fading(stage, store, around.spec.kind, std::move(panel.draw));
    // In a still, its words are whole or absent.
    if (stage.options.is_still)
        panel.draw = [draw = std::move(panel.draw)](const FrameInput& instant,
                                                    ViewBuilder& builder) {
            draw(instant, builder);
            std::erase_if(builder.view.labels,
                          [](const Label& label) { return whole_or_absent(label.opacity) == 0.0; });
            for (Label& label : builder.view.labels) label.opacity = 1.0;
        };
}

bool says_camera(const KeyframeSpec& key) {
    return key.azimuth_deg || key.elevation_deg || key.distance || key.field_deg || key.target ||
           !key.look_at.empty();
}

// Rejects keys of a panel's own camera that the panel does not use; keys of a named view are
// exempt, since a view sets all of them.
void check_panel_camera(const Scene& scene, const PanelKind& kind, std::size_t panel) {
    const auto refuse = [&](const std::string& key, std::string_view why) {
        if (scene.locations.contains(key))
            throw SceneError(scene.location_of(key),
                             fmt::format("{} changes nothing: panel \"{}\" {}; leave it out", key,
                                         kind.name, why));
    };
    std::vector<std::string> tables{fmt::format("panels[{}].camera", panel)};
    for (std::size_t k = 0; k < scene.keyframes.size(); ++k)
        if (scene.keyframes[k].panel == static_cast<int>(panel) && says_camera(scene.keyframes[k]))
            tables.push_back(fmt::format("keyframes[{}]", k));
    for (const std::string& table : tables) {
        if (kind.camera == CameraUse::none)
            refuse(table.starts_with("panels") ? table : table + ".panel",
                   "is flat and has no camera");
        if (kind.camera == CameraUse::all) continue;
        for (const char* leaf : {"distance", "target", "look_at"})
            refuse(fmt::format("{}.{}", table, leaf), "fits all of its content into its frame");
    }
}

// The camera of one panel: [camera], in body axes with the panel's default direction; then the keys
// of the panel's view and its own keys.
CameraSpec panel_camera(const Panel& panel, const PanelKind& kind) {
    const PanelCameraSpec& own = panel.spec.camera;
    CameraSpec camera = panel.stage->scene.camera;
    if (kind.default_view_direction != nullptr) {
        const Eigen::Vector3d from = kind.default_view_direction(panel);
        constexpr double deg = 180.0 / std::numbers::pi;
        camera.azimuth_deg = deg * std::atan2(from.y(), from.x());
        camera.elevation_deg = deg * std::atan2(from.z(), from.head<2>().norm());
        camera.roll_deg = 0.0;
    }
    if (!own.view.empty()) {
        const CameraView& view = camera_view_named(own.view);
        camera.azimuth_deg = view.azimuth_deg;
        camera.elevation_deg = view.elevation_deg;
        camera.distance = view.distance;
        camera.field_deg = view.field_deg;
        camera.look_at = view.look_at;
        camera.target.reset();
    }
    camera.azimuth_deg = own.azimuth_deg.value_or(camera.azimuth_deg);
    camera.elevation_deg = own.elevation_deg.value_or(camera.elevation_deg);
    camera.distance = own.distance.value_or(camera.distance);
    camera.field_deg = own.field_deg.value_or(camera.field_deg);
    if (own.target) camera.target = own.target;
    if (!own.look_at.empty()) {
        camera.look_at = own.look_at;
        camera.target.reset();
    }
    return camera;
}

bool says_camera(const PanelCameraSpec& own) {
    return own.azimuth_deg || own.elevation_deg || own.distance || own.field_deg || own.target ||
           !own.look_at.empty() || !own.view.empty();
}

// Gives a panel its own camera if the panel or a keyframe for it defines one.
void give_camera(Panel& panel, const PanelKind& kind, std::size_t index) {
    const Scene& scene = panel.stage->scene;
    const int number = static_cast<int>(index);
    const bool moved = std::any_of(
        scene.keyframes.begin(), scene.keyframes.end(),
        [number](const KeyframeSpec& k) { return k.panel == number && says_camera(k); });
    check_panel_camera(scene, kind, index);
    const std::string& projection = panel.spec.camera.projection;
    panel.orthographic =
        (projection.empty() ? scene.camera.projection : projection) == "orthographic";
    if (!moved && !says_camera(panel.spec.camera)) return;
    panel.user_timeline.emplace(
        scene, panel_camera(panel, kind), number,
        panel.stage->rolling ? panel.stage->rolling->foot() : Eigen::Vector3d::Zero().eval());
}

// Requires that the picture shows everything that a key names.
void check_names_of(const Scene& scene, const std::set<std::string, std::less<>>& shown,
                    const std::string& key, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (shown.contains(name)) continue;
        const std::vector<std::string_view> known(shown.begin(), shown.end());
        throw SceneError(scene.location_of(key),
                         fmt::format("no element shown is called \"{}\"{}", printable(name),
                                     choose_instead(name, known)));
    }
}

void check_keyframes(const StageContext& stage, const std::deque<Panel>& panels) {
    const auto follows_camera = [](const PanelKind& kind) {
        return kind.camera != CameraUse::none && kind.default_view_direction == nullptr;
    };
    const auto moves = [](const Panel& panel) {
        return !panel.user_timeline && panel.camera_at != nullptr;
    };
    const Scene& scene = stage.scene;
    if (!stage.timeline.camera_moves() || std::any_of(panels.begin(), panels.end(), moves)) return;
    for (std::size_t i = 0; i < scene.keyframes.size(); ++i) {
        if (!says_camera(scene.keyframes[i]) || scene.keyframes[i].panel) continue;
        throw SceneError(
            scene.location_of(fmt::format("keyframes[{}]", i)),
            fmt::format("keyframes[{0}] moves [camera], but no panel here uses [camera]; name a "
                        "panel by its index, as in keyframes[{0}].panel = 0, add a panel "
                        "{1}, or leave the camera out",
                        i, panels_where(follows_camera, "or")));
    }
}

}  // namespace

std::vector<PanelSpec> panels_of(const StageContext& stage) {
    if (!stage.scene.panels.empty()) return stage.scene.panels;
    PanelSpec alone;
    alone.kind = default_panel(stage.scene, is_heavy_top(stage));
    return {alone};
}

std::vector<const PanelKind*> kinds_of(const Scene& scene, const std::vector<PanelSpec>& panels) {
    std::vector<const PanelKind*> kinds;
    kinds.reserve(panels.size());
    for (const PanelSpec& spec : panels)
        // Returned as a pointer: g++ 14 warns that a reference may dangle.
        kinds.push_back(at_scene_key(scene, fmt::format("panels[{}].kind", kinds.size()),
                                     [&spec] { return &panel_kind_named(spec.kind); }));
    return kinds;
}

void check_possible(const StageContext& stage, const PanelKind& kind) {
    if (!kind.possible(stage)) {
        const bool rests = stage.motion.motion().problem().start.omega_body.isZero(0.0);
        throw SceneError(stage.scene.location_of(rests ? "start.omega_rad_s" : "panels"),
                         rests ? "omega_rad_s is zero, and a body at rest has no invariable "
                                 "plane; give an angular velocity"
                               : "panel \"" + std::string(kind.name) + "\" needs " +
                                     std::string(kind.requirement) + "; choose another panel");
    }
}

void check_named_elements(const Scene& scene, const std::set<std::string, std::less<>>& names) {
    for (std::size_t i = 0; i < scene.fades.size(); ++i)
        check_names_of(scene, names, fmt::format("fades[{}].elements", i), scene.fades[i].elements);
    check_names_of(scene, names, "unlabelled", scene.unlabelled);
}

std::deque<Panel> make_panels(const StageContext& stage, StageStore& store) {
    const Scene& scene = stage.scene;
    const StageOptions& options = stage.options;
    check_symbols(scene, store);
    const std::vector<PanelSpec> specs = panels_of(stage);
    const std::vector<const PanelKind*> kinds = kinds_of(scene, specs);

    // If there are several panels, or one that fills its box, the title and the caption get their
    // own rows; on paper always, so that no line runs under them.
    PanelBox room{0, 0, options.width_px, options.height_px};
    const OverlayBands bands = overlay_bands(stage, store.text());
    if (specs.size() > 1 || kinds.front()->fills || is_on_paper(stage)) {
        room.y_px = bands.top_px;
        room.height_px = std::max(1, options.height_px - bands.top_px - bands.bottom_px);
    }
    const std::vector<int> columns =
        boundaries(scene.grid.columns, room.x_px, room.width_px, options.samples);
    const std::vector<int> rows =
        boundaries(scene.grid.rows, room.y_px, room.height_px, options.samples);
    std::deque<Panel> panels;
    for (const PanelSpec& spec : specs) {
        const PanelKind& kind = *kinds[panels.size()];
        check_possible(stage, kind);
        Panel& panel = panels.emplace_back();
        panel.stage = &stage;
        panel.spec = spec;
        panel.light = stage.theme.light;
        panel.box = box_of(spec, columns, rows);
        panel.overlays = bands;
        panel.unit_circle = store.unit_circle();
        panel.unit_segment = store.unit_segment();
        const auto index = static_cast<std::size_t>(&spec - specs.data());
        panel.index = index;
        check_free_space(scene, panel.box, index);
        give_camera(panel, kind, index);
        scale_lines_and_type(panel);
        Drawer header;
        if (specs.size() > 1)
            header = header_of(
                panel, store,
                letter_of(scene, specs, index) + spec.title.value_or(title_of(scene, kind)));
        // Errors of a chart refer to its quantity.
        if (spec.quantity.empty())
            kind.make(panel, store);
        else
            at_scene_key(scene, fmt::format("panels[{}].quantity", index),
                         [&] { kind.make(panel, store); });
        if (header) {
            panel.draw = [header, draw = std::move(panel.draw)](const FrameInput& instant,
                                                                ViewBuilder& builder) {
                draw(instant, builder);
                header(instant, builder);
            };
        }
        panel.draw = fading(stage, store, spec.kind, std::move(panel.draw));
    }
    for (std::size_t i = 0; i < specs.size(); ++i)
        if (!specs[i].inset.empty() && (kinds[i]->uses & uses_inset) != 0)
            add_inset(panels, i, store);
    return panels;
}

void check_targets(const StageContext& stage, const StageStore& store,
                   const std::deque<Panel>& panels) {
    check_named_elements(stage.scene, store.names());
    check_keyframes(stage, panels);
}

}  // namespace poinsot
