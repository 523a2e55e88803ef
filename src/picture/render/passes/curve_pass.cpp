#include "render/passes/curve_pass.h"

#include <algorithm>

#include "render/passes/colour.h"

namespace poinsot {
namespace {

std::vector<std::string> with(std::vector<std::string> defines, const std::string& another) {
    defines.push_back(another);
    return defines;
}

}  // namespace

CurvePass::Stroke::Stroke(const Solids& solids)
    : StrokeProgram("curve.frag", 10 + solids.n_constants(),
                    with(solids.defines(), "FADE " + std::to_string(8 + solids.n_constants()))) {}

const CurvePass::Stroke& CurvePass::program_for(const ViewScene& scene, const Curve& curve) {
    // A curve that is always drawn in full needs no solids.
    return strokes_.of(curve.occlusion == Occlusion::by_solids ? scene.solids() : Solids{});
}

Constants CurvePass::constants_of(const ViewScene& scene, const Curve& curve,
                                  const StrokeDashes& dashes, const CurveLayer* layer) {
    const Quadric* surface = surface_of(scene, curve);
    Constants constants;
    scene.add_view(constants);
    constants.add(linear_from_srgb(curve.colour, curve.opacity));
    constants.add(curve.width_px, curve.hidden == HiddenStyle::absent ? -1.0 : curve.hidden_opacity,
                  surface == nullptr ? -1.0 : curve.on_surface, curve.on_plane);
    constants.add(dashes.period, dashes.share, surface == nullptr ? 0.0 : surface->limb_cosine(),
                  surface == nullptr ? 0.0 : surface->hiding_far);
    if (curve.occlusion == Occlusion::by_solids) scene.add_solids(constants);
    // The depth of each curve is one step nearer than all curves drawn before, so that the depth
    // buffer need not be cleared for every picture. Steps are powers of two and depths are between
    // 1/2 and 1, so that rounding is the same in every step.
    constexpr double depth_step = 1.0 / 1024.0;
    if (++n_drawn_ >= 512) {
        glDisable(GL_SCISSOR_TEST);  // the scissor boxes of views must not limit the clear
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        n_drawn_ = 1;
    }
    const double fade_end = std::max(range_of(curve).last, curve.fade_end);
    constants.add(fade_end - curve.fade_points, fade_end, 1.0 - n_drawn_ * depth_step,
                  0.9 * depth_step);
    const bool thins = curve.hidden == HiddenStyle::dashed && !curve.stands_for_hidden;
    const double hidden_px = (thins ? curve.hidden_share : 1.0) * curve.width_px;
    if (layer == nullptr)
        constants.add(0.0, 0.0, 0.0, hidden_px);
    else
        constants.add(layer->rect().left, layer->rect().top, 1.0, hidden_px);
    return constants;
}

void CurvePass::draw(const ViewScene& scene, const Curve& curve, CurveStore& store) {
    if (!shows(curve)) return;
    const StrokeDashes dashes = dashes_of(scene, curve, store.of(*curve.geometry).length);
    const Constants constants = constants_of(scene, curve, dashes, nullptr);
    none_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    program_for(scene, curve).draw(scene, curve, range_of(curve), curve.width_px, constants, store);
    glDisable(GL_DEPTH_TEST);
}

void CurvePass::draw_kept(const ViewScene& scene, const Curve& curve, const KeptStroke& kept,
                          const std::vector<PixelRect>& rects, CurveStore& store) {
    const Constants constants = constants_of(scene, curve, kept.dashes, &kept.layer);
    kept.layer.textures().bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    program_for(scene, curve).draw(scene, kept.ends, rects, constants, store);
    glDisable(GL_DEPTH_TEST);
}

void CurvePass::mark(const ViewScene& scene, const Curve& curve, CurveStore& store,
                     TileMask& marks) {
    if (!shows(curve)) return;
    const ShownRange range = range_of(curve);
    const double scale = curve.placement.linear().colwise().norm().maxCoeff();
    const double margin = 0.5 * curve.width_px + 2.0;
    for (const CurveStretch& stretch : store.of(*curve.geometry).stretches) {
        if (stretch.last < range.first_segment || stretch.first > range.end_segment) continue;
        PixelBox box =
            ball_box(scene.projection, curve.placement * stretch.centre, scale * stretch.radius);
        box.left -= margin, box.top -= margin, box.right += margin, box.bottom += margin;
        marks.mark(box.within(box_of(scene.projection)));
    }
}

}  // namespace poinsot
