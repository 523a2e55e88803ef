#include "render/curve_pass.h"

#include "render/colour.h"

namespace poinsot {
namespace {

std::vector<std::string> with(std::vector<std::string> defines, const std::string& another) {
    defines.push_back(another);
    return defines;
}

}  // namespace

CurvePass::Stroke::Stroke(const Solids& solids)
    : StrokeProgram("curve.frag", 9 + solids.n_constants(),
                    with(solids.defines(), "FADE " + std::to_string(8 + solids.n_constants()))) {}

void CurvePass::draw(const ViewScene& scene, const Curve& curve, CurveStore& store) {
    if (!shows(curve)) return;
    const ShownRange range = range_of(curve);
    // A curve drawn in full needs no solids.
    const bool occluded = curve.occlusion == Occlusion::by_solids;
    const Stroke& made = occluded ? strokes_.of(scene.solids()) : strokes_.of(Solids{});
    const Quadric* surface = surface_of(scene, curve);
    const Dashes dashes = dashes_of(scene, curve, store.of(*curve.geometry).length);

    Constants constants;
    scene.add_view(constants);
    constants.add4(linear_from_srgb(curve.colour, curve.opacity));
    constants.add(curve.width_px, curve.hidden == HiddenStyle::absent ? -1.0 : curve.hidden_opacity,
                  surface == nullptr ? -1.0 : curve.on_surface, curve.on_plane);
    constants.add(dashes.period, dashes.share, surface == nullptr ? 0.0 : surface->limb_cosine(),
                  surface == nullptr ? 0.0 : surface->hiding);
    if (occluded) scene.add_solids(constants);
    // Each curve lies a step before all that were drawn earlier, so that the depth buffer need not
    // be emptied for every picture. Steps are powers of two and depths lie between 1/2 and 1: what
    // is compared is rounded alike in whatever step it is drawn.
    constexpr double depth_step = 1.0 / 1024.0;
    if (++n_drawn_ >= 512) {
        glDisable(GL_SCISSOR_TEST);  // of all views
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        n_drawn_ = 1;
    }
    constants.add(range.last - curve.fade_points, range.last, 1.0 - n_drawn_ * depth_step,
                  0.9 * depth_step);

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    made.draw(scene, curve, range, curve.width_px, constants, store);
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
            scene.projection.ball_box(curve.placement * stretch.centre, scale * stretch.radius);
        box.left -= margin, box.top -= margin, box.right += margin, box.bottom += margin;
        marks.mark(box.within(scene.projection.box));
    }
}

}  // namespace poinsot
