#include "drawing/stage.h"

#include <cstddef>
#include <utility>

#include "drawing/line_style.h"
#include "drawing/marks.h"
#include "drawing/panel.h"
#include "drawing/stage_data.h"
#include "drawing/type/label_fit.h"
#include "drawing/type/labels.h"
#include "scene/film_clock.h"

namespace poinsot {

Stage::Stage(const Scene& scene, const Motion& motion, const StageOptions& options,
             const Motion* comparison)
    : data_(std::make_unique<StageData>(scene, motion, options, comparison)) {}
Stage::~Stage() = default;
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;

const EvaluationCounts& Stage::counts() const { return data_->motion.counts(); }

double Stage::curve_error_px() const { return data_->curve_error_px; }

std::span<const std::string> Stage::notes() const { return data_->notes; }

Drawing Stage::at(double time_s) const {
    return at(moment_of_time(FilmClock(data_->scene), time_s));
}

Drawing Stage::at(const FilmTime& moment) const {
    const FrameInput instant = data_->instant_at(moment);
    Drawing drawing;
    drawing.width_px = data_->options.width_px;
    drawing.height_px = data_->options.height_px;
    drawing.background = data_->theme->background;
    // Views own the text and curves made for this drawing alone; their shapes point to them, so
    // that views must not move once made.
    drawing.views.reserve(data_->panels.size() + 1);
    for (const Panel& panel : data_->panels) {
        ViewBuilder builder;
        View& view = builder.view;
        view.x_px = panel.box.x_px;
        view.y_px = panel.box.y_px;
        view.width_px = panel.box.width_px;
        view.height_px = panel.box.height_px;
        view.name = panel.spec.kind;
        view.camera = panel.camera_at ? panel.camera_at(moment.film_s) : panel.camera;
        view.light = panel.light;
        // Several panels share the picture's background.
        view.background = data_->theme->background;
        if (panel.box.height_px < drawing.height_px || panel.box.width_px < drawing.width_px) {
            view.background.alpha = 0.0;
        }
        panel.draw(instant, builder);
        const auto n_dots = static_cast<std::ptrdiff_t>(view.dots.size());
        mark_arrows_at_viewer(panel, view);
        // A label keeps its distance from the ring that replaces its arrow.
        for (auto ring = view.dots.begin() + n_dots; ring != view.dots.end(); ++ring)
            for (LabelRequest& request : builder.requests)
                if (request.at && (*request.at - ring->at).isZero(0.0))
                    request.gap_px += 2.0 * ring->opacity * ring->radius_px;
        place_labels(builder.requests, data_->theme->halo, 4.0 * panel.px, view,
                     data_->unit_segment);
        follow_line_rules(*data_, view);
        drawing.views.push_back(std::move(view));
    }

    // Title, caption and clock are in a view of their own over all panels.
    ViewBuilder over;
    over.view.width_px = drawing.width_px;
    over.view.height_px = drawing.height_px;
    over.view.background.alpha = 0.0;
    for (const Drawer& draw : data_->overlays) draw(instant, over);
    if (!over.view.labels.empty()) drawing.views.push_back(std::move(over.view));
    if (data_->options.least.type_px > 0.0) leave_out_type(drawing);
    return drawing;
}

}  // namespace poinsot
