#include "drawing/stage/stage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/label_requests.h"
#include "drawing/stage/layout.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/stage_context.h"
#include "drawing/stage/stage_store.h"
#include "drawing/stage/thing_names.h"
#include "drawing/stage/type/label_fit.h"
#include "drawing/stage/type/labels.h"
#include "drawing/style/line_style.h"
#include "drawing/style/theme_contrast.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// A panel's view before anything is drawn.
ViewBuilder begun(const Panel& panel, const FilmTime& moment) {
    ViewBuilder builder;
    View& view = builder.view;
    view.x_px = panel.box.x_px;
    view.y_px = panel.box.y_px;
    view.width_px = panel.box.width_px;
    view.height_px = panel.box.height_px;
    view.name = panel.spec.kind;
    view.camera = panel.camera_at ? panel.camera_at(moment.film_s) : panel.camera;
    view.light = panel.light;
    return builder;
}

// A panel's view at an instant, and the labels that it wants.
ViewBuilder drawn(const Panel& panel, const FilmTime& moment, const FrameInput& instant,
                  const CameraChange& camera = {}) {
    ViewBuilder builder = begun(panel, moment);
    View& view = builder.view;
    if (camera) view.camera = camera(view.camera);
    panel.draw(instant, builder);
    const auto n_dots = static_cast<std::ptrdiff_t>(view.dots.size());
    mark_arrows_at_viewer(panel, view);
    // A label keeps its distance from the ring that replaces its arrow.
    for (auto ring = view.dots.begin() + n_dots; ring != view.dots.end(); ++ring)
        for (LabelRequest& request : builder.requests)
            if (request.at && (*request.at - ring->at).isZero(0.0))
                request.gap_px += 2.0 * ring->opacity * ring->radius_px;
    for (LabelRequest& request : builder.requests)
        request.offset_px = offset_of_label(*panel.stage, name_of_label(request.name));
    return builder;
}

// Title, caption and clock.
View drawn_over(const StageContext& context, const std::vector<Drawer>& overlays,
                const FrameInput& instant) {
    ViewBuilder over;
    over.view.width_px = context.options.width_px;
    over.view.height_px = context.options.height_px;
    over.view.background.alpha = 0.0;
    for (const Drawer& draw : overlays) draw(instant, over);
    return std::move(over.view);
}

LabelRules label_rules(const StageContext& context, const StageStore& store, const View& over) {
    LabelRules rules;
    rules.halo = context.theme.halo;
    rules.margin_px = 3.0 * px_per_pt(context);
    rules.segment = store.unit_segment();
    rules.is_still = context.options.is_still;
    for (const Label& label : over.labels)
        if (!label.mask->letters.empty()) rules.overlays.push_back(label_box(label));
    return rules;
}

// The rules for the labels of one panel: they keep off its insets, too.
LabelRules with_insets(LabelRules rules, const std::deque<Panel>& panels, std::size_t host) {
    for (const Panel& panel : panels) {
        if (panel.host != host) continue;
        const PanelBox& box = panel.box;
        const Eigen::Vector2d half_px = 0.5 * Eigen::Vector2d(box.width_px, box.height_px);
        rules.overlays.push_back({Eigen::Vector2d(box.x_px, box.y_px) + half_px, half_px});
    }
    rules.halo_px = 4.0 * panels[host].px;
    return rules;
}

}  // namespace

struct Stage::Impl {
    StageContext context;
    StageStore store{context};
    std::deque<Panel> panels = make_panels(context, store);
    std::vector<std::vector<ThingName>> names;  // of curves and surfaces, for each panel
    std::vector<Drawer> overlays;               // title, caption, clock: over the whole picture
    Quantities needs = omega_alone;             // what all panels together read of an instant
    bool shows_comparison = false;              // whether one of them shows the comparison motion

    Impl(const Scene& scene, const Theme& theme, const Motion& motion, const StageOptions& options,
         const Motion* comparison)
        : context(scene, theme, motion, options, comparison) {
        for (const Panel& panel : panels) {
            needs = united(needs, panel.needs);
            shows_comparison = shows_comparison || panel.shows_comparison;
        }
        if (comparison != nullptr && !shows_comparison) {
            throw SceneError(scene.location_of("beside"),
                             "no panel here shows the comparison method; add a panel " +
                                 panels_that_use(uses_comparison, "or"));
        }
        // The panel around an inset shows the names of the same things.
        for (const Panel& panel : panels)
            names.push_back(panel.host ? std::vector<ThingName>() : set_thing_names(panel, store));
        overlays = make_overlays(context, store, panels);
        check_targets(context, store, panels);
        const StageOptions& of = context.options;
        const bool is_one_instant =
            of.first_shown_s && (of.is_still || *of.first_shown_s == of.last_time_s);
        if (!is_one_instant) plan_all_names();
    }

    // From instants all over the film, whichever part of it is made.
    void plan_all_names() {
        const auto has_none = [](const std::vector<ThingName>& each) { return each.empty(); };
        if (std::all_of(names.begin(), names.end(), has_none)) return;
        constexpr double apart_s = 0.5;
        constexpr int least_instants = 8, most_instants = 96;
        const FilmClock clock(context.scene);
        const double length_s = clock.length_s().value_or(default_film_s);
        const int n_instants =
            std::clamp(static_cast<int>(std::min(std::ceil(length_s / apart_s), 1e6)),
                       least_instants, most_instants);
        std::vector<std::vector<View>> views(panels.size());
        std::vector<std::vector<PlacedLabels>> instants(panels.size());
        for (std::vector<View>& each : views) each.reserve(static_cast<std::size_t>(n_instants));
        for (int k = 0; k < n_instants; ++k) {
            const double film_s = length_s * (k + 0.5) / n_instants;
            const FilmTime moment{clock.time_at(film_s), film_s};
            const FrameInput instant = context.instant_at(moment, needs, shows_comparison);
            const View over = drawn_over(context, overlays, instant);
            const LabelRules all = label_rules(context, store, over);
            for (std::size_t i = 0; i < panels.size(); ++i) {
                if (names[i].empty()) continue;
                ViewBuilder builder = drawn(panels[i], moment, instant);
                const LabelRules rules = with_insets(all, panels, i);
                place_labels(builder.requests, rules, builder.view);
                views[i].push_back(std::move(builder.view));
                instants[i].push_back({&views[i].back(), rules.overlays, film_s});
            }
        }
        std::vector<FilmLoop> loops;
        for (const StopSpec& stop : context.scene.stops)
            if (stop.loop_s) loops.push_back({stop.at_s - *stop.loop_s, stop.at_s});
        for (std::size_t i = 0; i < panels.size(); ++i)
            if (!names[i].empty())
                plan_names(panels[i], std::move(instants[i]), context.options.repeat_s > 0.0, loops,
                           names[i]);
    }
};

Stage::Stage(const Scene& scene, const Theme& theme, const Motion& motion,
             const StageOptions& options, const Motion* comparison)
    : impl_(std::make_unique<const Impl>(scene, theme, motion, options, comparison)) {}
Stage::~Stage() = default;
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;

const Quantities& Stage::needs() const { return impl_->needs; }

const EvaluationCounts& Stage::counts() const { return impl_->context.motion.counts(); }

double Stage::curve_error_px() const { return impl_->store.curve_error_px(); }

std::span<const std::string> Stage::notes() const { return impl_->store.notes(); }

const StageContext& Stage::context() const { return impl_->context; }
const StageStore& Stage::store() const { return impl_->store; }
const std::deque<Panel>& Stage::panels() const { return impl_->panels; }

Drawing Stage::at(double time_s) const {
    return at(moment_of_time(FilmClock(impl_->context.scene), time_s));
}

namespace {

LineStyleRules line_style_rules(const StageContext& stage, const StageStore& store) {
    const auto said = [](std::string_view by_scene, std::string_view by_theme) {
        return by_scene.empty() ? by_theme : by_scene;
    };
    // The scene's choice for hidden lines holds for its arrows, too.
    const std::string& for_arrows =
        stage.scene.hidden_arrows.empty() ? stage.scene.hidden : stage.scene.hidden_arrows;
    return {.hidden = said(stage.scene.hidden, stage.theme.hidden),
            .hidden_arrows = said(for_arrows, stage.theme.hidden_arrows),
            .crossings = said(stage.scene.crossings, stage.theme.crossings),
            .px = stage.px,
            .least_px = stage.options.least.line_px,
            .unit_circle = store.unit_circle(),
            .unit_segment = store.unit_segment()};
}

}  // namespace

Drawing Stage::at(const FilmTime& moment, std::span<const CameraChange> cameras) const {
    const StageContext& context = impl_->context;
    const FrameInput instant = context.instant_at(moment, impl_->needs, impl_->shows_comparison);
    const Background& ground = context.theme.background;
    Drawing drawing;
    drawing.width_px = context.options.width_px;
    drawing.height_px = context.options.height_px;
    drawing.background = ground;
    // Title, caption and clock are in a view of their own over all panels.
    View over = drawn_over(context, impl_->overlays, instant);
    const LabelRules all = label_rules(context, impl_->store, over);

    // Views own the text and curves made for this drawing alone; their shapes point to them, so
    // that views must not move once made.
    drawing.views.reserve(impl_->panels.size() + 1);
    for (std::size_t i = 0; i < impl_->panels.size(); ++i) {
        const Panel& panel = impl_->panels[i];
        ViewBuilder builder =
            drawn(panel, moment, instant, i < cameras.size() ? cameras[i] : CameraChange());
        View& view = builder.view;
        // Several panels share the picture's background.
        view.background = ground;
        if (panel.box.height_px < drawing.height_px || panel.box.width_px < drawing.width_px) {
            view.background.alpha = 0.0;
        }
        const LabelRules rules = with_insets(all, impl_->panels, i);
        for (const UnplacedLabel& label : place_labels(builder.requests, rules, view)) {
            if (const std::string_view of = name_of_label(label.name); !of.empty())
                drawing.unnamed.push_back({of, label.is_in_sight});
        }
        const bool is_planned = !(i < cameras.size() && cameras[i]);
        for (const UnnamedThing& thing : place_thing_names(panel, impl_->names[i], rules.overlays,
                                                           moment.film_s, is_planned, view))
            drawing.unnamed.push_back(thing);
        for (Label& label : view.labels) label.colour = letter_colour(context.theme, label.colour);
        apply_line_style(line_style_rules(context, impl_->store), view);
        drawing.views.push_back(std::move(view));
    }
    if (!over.labels.empty()) drawing.views.push_back(std::move(over));
    if (context.options.least.type_px > 0.0) leave_out_type(drawing);
    return drawing;
}

std::vector<PlacedArrow> Stage::arrows_at(const FilmTime& moment) const {
    const FrameInput instant =
        impl_->context.instant_at(moment, impl_->needs, impl_->shows_comparison);
    std::vector<PlacedArrow> arrows;
    int index = 0;
    for (const Panel& panel : impl_->panels) {
        ViewBuilder builder = begun(panel, moment);
        panel.draw(instant, builder);
        append_arrows(builder.view, index++, arrows);
    }
    return arrows;
}

}  // namespace poinsot
