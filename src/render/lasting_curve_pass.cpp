#include "render/lasting_curve_pass.h"

#include <algorithm>
#include <cmath>

#include "render/colour.h"

namespace poinsot {
namespace {

// What the curve may reach in the picture.
PixelBox box_of(const ViewScene& scene, const Curve& curve, const StoredCurve& stored) {
    const double scale = curve.placement.linear().colwise().norm().maxCoeff();
    const double margin = 0.5 * curve.width_px + 2.0;
    PixelBox box;
    for (const CurveStretch& stretch : stored.stretches) {
        const PixelBox ball =
            scene.projection.ball_box(curve.placement * stretch.centre, scale * stretch.radius);
        box.add({ball.left, ball.top}, margin);
        box.add({ball.right, ball.bottom}, margin);
    }
    const PixelBox picture{0.0, 0.0, 1.0 * scene.drawing->width_px, 1.0 * scene.drawing->height_px};
    return box.within(scene.projection.box).within(picture);
}

// Cosine of the angle between the ellipsoid's normal at a point and the line of sight, in the axes
// in which it is a sphere; as shaders/curve.vert has it.
double facing_of(const Quadric* surface, const Eigen::Vector3d& point, bool perspective) {
    if (surface == nullptr) return 1.0;
    const Eigen::Vector3d u = (surface->to_u * (point - surface->centre)).normalized();
    const double w = perspective ? 1.0 : 0.0;
    return (u.dot(surface->eye_u) - w) / std::max((surface->eye_u - w * u).norm(), 1e-20);
}

}  // namespace

LastingCurvePass::Over::Over(const Solids& solids)
    : ConstantProgram("rectangles.vert", "traced.frag", 12 + solids.n_constants(), 0,
                      solids.defines()) {}

LastingCurvePass::LastingCurvePass() : trace_("trace.frag", 7, {}) {}

bool LastingCurvePass::keeps(const Curve& curve) {
    return curve.lasting && shows(curve) && !curve.geometry->closed && !(curve.fade_points > 0.0) &&
           curve.hidden != HiddenStyle::dashed;
}

void LastingCurvePass::begin_picture() {
    // What the picture before did not show is dropped: a layer is large.
    std::erase_if(layers_, [this](const auto& layer) { return layer->last_picture < picture_; });
    ++picture_;
    shown_.clear();
    n_segments_drawn_ = 0;
}

CurveLayer& LastingCurvePass::layer_of(const TraceKey& key) {
    const auto find = [this](const auto& is_wanted) -> CurveLayer* {
        for (const auto& layer : layers_)
            if (layer->last_picture < picture_ && is_wanted(*layer)) return layer.get();
        return nullptr;
    };
    CurveLayer* layer = find([&](const CurveLayer& l) { return l.holds(key); });
    // One that held it seen from elsewhere is large enough, or nearly.
    if (layer == nullptr)
        layer = find([&](const CurveLayer& l) { return l.geometry() == key.geometry; });
    if (layer == nullptr) layer = layers_.emplace_back(std::make_unique<CurveLayer>()).get();
    layer->last_picture = picture_;
    return *layer;
}

void LastingCurvePass::prepare(const ViewScene& scene, CurveStore& store) {
    for (const Curve& curve : scene.view->curves) {
        if (!keeps(curve)) continue;
        const ShownRange range = range_of(curve);
        const StoredCurve& stored = store.of(*curve.geometry);
        Shown shown{&scene, &curve, nullptr, {}, dashes_of(scene, curve, stored.length)};

        // The last segment, which may be cut, is drawn for each picture; those before it are kept.
        const int last = range.end_segment - 1;
        shown.last = seen_segment(scene.projection, curve, last, std::max(range.first - last, 0.0),
                                  range.last - last);
        const double from = stored.lengths[static_cast<std::size_t>(last)];
        const double to = stored.lengths[static_cast<std::size_t>(last) + 1];
        shown.length_from = from + shown.last.from * (to - from);
        shown.length_to = from + shown.last.to * (to - from);

        const TraceKey key(scene, curve, shown.dashes);
        shown.layer = &layer_of(key);
        if (!shown.layer->holds(key) || shown.layer->end_segment() > last)
            shown.layer->restart(key, box_of(scene, curve, stored), range.first_segment,
                                 ++n_restarts_);
        if (shown.layer->rect().width() == 0) continue;
        if (shown.layer->end_segment() < last) grow(shown, last, store);
        shown_.push_back(shown);
    }
}

void LastingCurvePass::grow(const Shown& shown, int end_segment, CurveStore& store) {
    // Pixels beside the stroke keep a depth, too: its change is asked for at the stroke's edge.
    constexpr double beside_px = 1.0;
    const Curve& curve = *shown.curve;
    CurveLayer& layer = *shown.layer;
    const Quadric* surface = surface_of(*shown.scene, curve);
    Constants constants;
    shown.scene->add_view(constants);
    constants.add(layer.rect().left, layer.rect().top, curve.width_px,
                  surface == nullptr ? 0.0 : surface->limb_cosine());
    constants.add(shown.dashes.period, shown.dashes.share, 0.5 * curve.width_px + 0.75 + beside_px,
                  0.0);
    const ShownRange range{range_of(curve).first,
                           static_cast<double>(curve.geometry->points.size()), layer.end_segment(),
                           end_segment};
    n_segments_drawn_ += range.end_segment - range.first_segment;
    layer.begin_growth(*shown.scene, curve, end_segment, picture_);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    trace_.draw(*shown.scene, curve, range, curve.width_px + 2.0 * beside_px, constants, store);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
}

void LastingCurvePass::end_preparation() {
    std::vector<Look> looks;
    for (const Shown& shown : shown_) {
        const Curve& c = *shown.curve;
        looks.push_back({shown.layer->serial(), c.colour, c.opacity, c.hidden_opacity, c.hidden,
                         c.occlusion, c.on_surface, c.on_plane});
    }
    if (looks == looks_) return;
    looks_ = std::move(looks);
    looks_since_ = picture_;
}

Constants LastingCurvePass::constants_of(const Shown& shown) const {
    const ViewScene& scene = *shown.scene;
    const Curve& curve = *shown.curve;
    const Quadric* surface = surface_of(scene, curve);
    Constants constants;
    scene.add_view(constants);
    constants.add4(linear_from_srgb(curve.colour, curve.opacity));
    constants.add(curve.width_px, curve.hidden == HiddenStyle::absent ? -1.0 : curve.hidden_opacity,
                  surface == nullptr ? -1.0 : curve.on_surface, curve.on_plane);
    constants.add(shown.dashes.period, shown.dashes.share,
                  surface == nullptr ? 0.0 : surface->limb_cosine(),
                  surface == nullptr ? 0.0 : surface->hiding);
    constants.add(shown.layer->rect().left, shown.layer->rect().top, 0.0, 0.0);
    const SeenSegment& last = shown.last;
    if (!last.seen) {
        constexpr double far_px = -1e5;
        constants.add(far_px, far_px, far_px, far_px);
        constants.add(1.0, 1.0, 0.0, 0.0);
        constants.add(1.0, 1.0, 0.0, 0.0);
        return constants;
    }
    const Projection& p = scene.projection;
    constants.add(last.start_px.x(), last.start_px.y(), last.end_px.x(), last.end_px.y());
    constants.add(p.depth(last.start), p.depth(last.end), shown.length_from, shown.length_to);
    constants.add(facing_of(surface, last.start, p.perspective),
                  facing_of(surface, last.end, p.perspective), 0.0, 0.0);
    return constants;
}

void LastingCurvePass::draw(const ViewScene& scene, const Curve& curve, const TileMask* within) {
    const auto shown = std::find_if(shown_.begin(), shown_.end(),
                                    [&](const Shown& s) { return s.curve == &curve; });
    if (shown == shown_.end()) return;
    cells_ = shown->layer->cells();
    mark_stroke(shown->last, curve.width_px, scene.projection.box, cells_);
    rects_.clear();
    cells_.add_rects(within, rects_);
    if (rects_.empty()) return;

    const bool occluded = curve.occlusion == Occlusion::by_solids;
    const Over& over = over_.of(occluded ? scene.solids() : Solids{});
    Constants constants = constants_of(*shown);
    if (occluded) scene.add_solids(constants);
    over.use(constants, *scene.drawing);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, shown->layer->coverage().id());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, shown->layer->points().id());
    rectangles_.draw(rects_);
}

void LastingCurvePass::mark(const ViewScene& scene, TileMask& marks) const {
    for (const Shown& shown : shown_)
        if (shown.scene == &scene)
            mark_stroke(shown.last, shown.curve->width_px, scene.projection.box, marks);
}

void LastingCurvePass::add_stamps(std::vector<std::uint64_t>& stamps) const {
    for (const Shown& shown : shown_) {
        const std::vector<std::uint64_t>& changed = shown.layer->changed();
        for (std::size_t k = 0; k < changed.size(); ++k)
            if (changed[k] != 0) stamps[k] = std::max({stamps[k], changed[k], looks_since_});
    }
}

}  // namespace poinsot
