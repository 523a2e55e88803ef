#include "drawing/figures/elements/user_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "construction/timed_path.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/fade.h"
#include "drawing/stage/label_requests.h"
#include "drawing/style/theme_roles.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

struct UserMark {
    const MarkSpec* spec = nullptr;
    LineStyle ink;
    TextBlock name;
    std::optional<Curve> trail;
    TimedPath path;  // of the trail, without its points
};

TextBlock name_of(const Panel& panel, StageStore& store, std::size_t i) {
    const StageContext& stage = *panel.stage;
    const double scale = 0.85 * stage.scene.style.label_scale.value_or(1.0);
    const TypeStyle style{.size_px = std::max(scale * label_em_px(panel), least_type_px(stage))};
    return at_scene_key(stage.scene, fmt::format("marks[{}].name", i),
                        [&] { return store.set(stage.scene.marks[i].name, style); });
}

RotationState state_at(const StageContext& stage, double time_s) {
    RotationState state = stage.motion.sample(time_s, attitude_too).state;
    if (stage.turns() || stage.follows_momentum())
        state.space_from_body = stage.turned_from_space(time_s) * state.space_from_body;
    return state;
}

// Adds the path of a mark over the stage's span.
void add_trail(const Panel& panel, StageStore& store, const MarkPlace& place, UserMark& mark) {
    const StageContext& stage = *panel.stage;
    const double rate_rad_s = stage.quickest_rate_rad_s();
    if (!(rate_rad_s > 0.0) || mark.spec->on == "space") return;
    mark.path =
        sample_path([&](double time_s) { return *place(*mark.spec, state_at(stage, time_s)); },
                    stage.options.first_time_s, stage.options.last_time_s,
                    std::numbers::pi / rate_rad_s, panel.curve_units());
    CurveGeometry geometry;
    geometry.points = std::move(mark.path.points);
    mark.path.points.clear();
    mark.trail = curve_of(
        panel, keep(panel, store, std::move(geometry), mark.path.off, "the trail of a mark"),
        mark.ink, 2.6);
    mark.trail->hidden_opacity = 0.35;
    mark.trail->lasting = true;
}

}  // namespace

Eigen::Vector3d on_ellipsoid(const ConstructionPicture& picture, const MarkSpec& mark) {
    // F(ρ) = ρ·Iρ = 1 along this direction.
    const Eigen::Vector3d along = mark.at.stableNormalized();
    const Eigen::Matrix3d inertia = picture.construction.inertia().matrix_body();
    return along * (picture.picture_per_rho / std::sqrt(along.dot(inertia * along)));
}

Eigen::Vector3d on_body_m(const Scene& scene, const MarkSpec& mark) {
    return mark.at - scene.body.centre_of_mass_m_body;
}

Drawer make_user_marks(Panel& panel, StageStore& store, const MarkPlace& place) {
    const StageContext& stage = *panel.stage;
    std::vector<UserMark> marks;
    for (std::size_t i = 0; i < stage.scene.marks.size(); ++i) {
        UserMark mark;
        mark.spec = &stage.scene.marks[i];
        if (!place(*mark.spec, RotationState{})) continue;
        mark.ink = line_of(stage.theme, mark.spec->role);
        if (mark.spec->srgb) {
            const auto [r, g, b] = *mark.spec->srgb;
            mark.ink = Colour{r, g, b};
        }
        if (!mark.spec->name.empty()) mark.name = name_of(panel, store, i);
        if (mark.spec->trail) add_trail(panel, store, place, mark);
        marks.push_back(std::move(mark));
    }
    if (marks.empty()) return [](const FrameInput&, ViewBuilder&) {};
    panel.needs = united(panel.needs, attitude_too);
    const bool whole = !stage.scene.film.loop.empty();  // a loop has no first instant
    Drawer draw = [&panel, place, marks, whole](const FrameInput& instant, ViewBuilder& builder) {
        for (const UserMark& mark : marks) {
            const Eigen::Vector3d at = *place(*mark.spec, instant.state);
            if (mark.trail) {
                builder.view.curves.push_back(*mark.trail);
                if (!whole) builder.view.curves.back().last = mark.path.index_at(instant.time_s);
            }
            Dot dot = dot_at(panel, at, mark.ink, 7.5);
            dot.hidden_opacity = 0.35;
            builder.view.dots.push_back(dot);
            if (mark.name.mask != nullptr)
                request_label_beside(panel, at, Eigen::Vector3d::Zero(), mark.name, mark.ink,
                                     builder);
        }
    };
    return fading(stage, store, "marks", std::move(draw));
}

}  // namespace poinsot
