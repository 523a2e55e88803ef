#include "render/cache/cached_curve_pass.h"

#include <algorithm>
namespace poinsot {
namespace {

// The pixels that the curve may reach.
PixelBox box_of(const ViewScene& scene, const Curve& curve, const StoredCurve& stored) {
    const double scale = curve.placement.linear().colwise().norm().maxCoeff();
    const double margin = 0.5 * curve.width_px + 2.0;
    PixelBox box;
    for (const CurveStretch& stretch : stored.stretches) {
        const PixelBox ball =
            ball_box(scene.projection, curve.placement * stretch.centre, scale * stretch.radius);
        box.add({ball.left, ball.top}, margin);
        box.add({ball.right, ball.bottom}, margin);
    }
    const PixelBox picture{0.0, 0.0, 1.0 * scene.drawing->width_px, 1.0 * scene.drawing->height_px};
    return box.within(box_of(scene.projection)).within(picture);
}

// Cosine of the angle between the ellipsoid's normal at a point and the line of sight, in the axes
// in which it is a sphere; as in shaders/curve.vert.
double facing_of(const Quadric* surface, const Eigen::Vector3d& point, bool perspective) {
    if (surface == nullptr) return 1.0;
    const Eigen::Vector3d u = (surface->to_u * (point - surface->centre)).normalized();
    const double w = perspective ? 1.0 : 0.0;
    return (u.dot(surface->eye_u) - w) / std::max((surface->eye_u - w * u).norm(), 1e-20);
}

// lengths: of the curve up to the first and second point of the segment.
StrokeEnds ends_of(const ViewScene& scene, const Curve& curve, const SeenSegment& segment,
                   const float* lengths) {
    constexpr double far_px = -1e5;
    if (!segment.seen) return {{far_px, far_px}, {far_px, far_px}};
    const Projection& p = scene.projection;
    const Quadric* surface = surface_of(scene, curve);
    const auto length_to = [&](double share) {
        return lengths[0] + share * (static_cast<double>(lengths[1]) - lengths[0]);
    };
    return {segment.start_px,
            segment.end_px,
            p.depth(segment.start),
            p.depth(segment.end),
            facing_of(surface, segment.start, p.perspective),
            facing_of(surface, segment.end, p.perspective),
            length_to(segment.from),
            length_to(segment.to)};
}

}  // namespace

bool CachedCurvePass::keeps(const Curve& curve) {
    return curve.lasting && shows(curve) && !curve.geometry->closed && !(curve.fade_points > 0.0) &&
           curve.hidden != HiddenStyle::dashed;
}

void CachedCurvePass::begin_picture() {
    // Layers that the previous picture did not use are released: a layer is large.
    std::erase_if(layers_, [this](const auto& layer) { return layer->last_picture < picture_; });
    ++picture_;
    shown_.clear();
    n_segments_drawn_ = 0;
}

CurveLayer& CachedCurvePass::layer_of(const TraceKey& key) {
    const auto find = [this](const auto& is_wanted) -> CurveLayer* {
        for (const auto& layer : layers_)
            if (layer->last_picture < picture_ && is_wanted(*layer)) return layer.get();
        return nullptr;
    };
    CurveLayer* layer = find([&](const CurveLayer& l) { return l.holds(key); });
    // A layer of the same curve from another camera is large enough, or nearly.
    if (layer == nullptr)
        layer = find([&](const CurveLayer& l) { return l.geometry() == key.geometry; });
    if (layer == nullptr) layer = layers_.emplace_back(std::make_unique<CurveLayer>()).get();
    layer->last_picture = picture_;
    return *layer;
}

void CachedCurvePass::prepare(const ViewScene& scene, CurveStore& store) {
    for (const Curve& curve : scene.view->curves) {
        if (!keeps(curve)) continue;
        const ShownRange range = range_of(curve);
        const StoredCurve& stored = store.of(*curve.geometry);
        Shown shown{&scene, &curve, nullptr, {}, {}, dashes_of(scene, curve, stored.length)};

        // The last segment may be partial and is drawn for each picture; the segments before it are
        // cached.
        const int last = range.end_segment - 1;
        shown.last = seen_segment(scene.projection, curve, last, std::max(range.first - last, 0.0),
                                  range.last - last);
        shown.ends =
            ends_of(scene, curve, shown.last, &stored.lengths[static_cast<std::size_t>(last)]);
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

void CachedCurvePass::grow(const Shown& shown, int end_segment, CurveStore& store) {
    // Pixels beside the stroke need a depth, too: the shader takes its derivatives at the stroke's
    // edge.
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
    if (!trace_) trace_.emplace("trace.frag", 7, std::vector<std::string>{});
    trace_->draw(*shown.scene, curve, range, curve.width_px + 2.0 * beside_px, constants, store);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
}

void CachedCurvePass::end_preparation() {
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

void CachedCurvePass::draw(const ViewScene& scene, const Curve& curve, const TileMask* within,
                           CurvePass& pass, CurveStore& store) {
    const auto shown = std::find_if(shown_.begin(), shown_.end(),
                                    [&](const Shown& s) { return s.curve == &curve; });
    if (shown == shown_.end()) return;
    cells_ = shown->layer->cells();
    mark_stroke(shown->last, curve.width_px, box_of(scene.projection), cells_);
    rects_.clear();
    cells_.add_rects(within, rects_);
    if (!rects_.empty())
        pass.draw_kept(scene, curve,
                       {.dashes = shown->dashes, .ends = shown->ends, .layer = *shown->layer},
                       rects_, store);
}

void CachedCurvePass::mark(const ViewScene& scene, TileMask& marks) const {
    for (const Shown& shown : shown_)
        if (shown.scene == &scene)
            mark_stroke(shown.last, shown.curve->width_px, box_of(scene.projection), marks);
}

void CachedCurvePass::add_stamps(std::vector<std::uint64_t>& stamps) const {
    for (const Shown& shown : shown_) {
        const std::vector<std::uint64_t>& changed = shown.layer->changed();
        for (std::size_t k = 0; k < changed.size(); ++k)
            if (changed[k] != 0) stamps[k] = std::max({stamps[k], changed[k], looks_since_});
    }
}

}  // namespace poinsot
