// A stroke of constant width with round joins. Where neighbouring segments overlap, the pixel
// belongs to the nearest one, so that a translucent curve has uniform opacity.
#include "constants.glsl"
#include "coverage.glsl"
#include "stroke.glsl"
#include "view.glsl"
#include "quadric.glsl"
#define SOLIDS 8
#include "occlusion.glsl"
//   0…4: the view   5: colour, linear; opacity
//   6: width px, opacity where hidden (below 0: absent), number of the ellipsoid and of the plane it
//      lies on (-1: none)
//   7: period of the dashes in lengths of the curve (0: solid; below 0: dashed only where hidden),
//      share of it that is drawn; for the ellipsoid it lies on, the step of facing at the limb and
//      the opacity
//   then the solids, and after them
//   FADE: where it fades: transparent and opaque point; the depth that marks this curve
//   FADE + 1: corner of the layer with the cached part of the curve px; 1 if there is one; width
//      where hidden px
flat in vec4 ends;
flat in vec4 neighbours;
flat in vec4 along;
flat in vec4 depths;
uniform sampler2D texture_2;  // of that layer, written by trace.frag: (1 - coverage)/2
uniform sampler2D texture_3;  // depth of the point, share to which it faces the eye
out vec4 fragment;

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec2 own = from_segment(pixel, ends.xy, ends.zw);
    float reach = 0.5 * constant(6).x;
    // Pixels of other segments fail the depth test, which is cheaper here than discarding them.
    bool none = own.x > reach + 0.75 ||
                (from_segment(pixel, neighbours.xy, ends.xy).x <= own.x && neighbours.xy != ends.xy) ||
                (from_segment(pixel, ends.zw, neighbours.zw).x < own.x && neighbours.zw != ends.zw);

    float covered = stroke_coverage(pixel, ends, own, constant(6).x);
    bool thins = constant(FADE + 1).w < constant(6).x;
    float covered_hidden = thins ? stroke_coverage(pixel, ends, own, constant(FADE + 1).w) : covered;
    float t = along_segment(own.y, depths.xy, constant(0).w > 0.5);
    float depth = mix(depths.x, depths.y, t);
    float run_px = max(length(ends.zw - ends.xy), 1e-3);
    float change = max(abs(depths.w - depths.z) / run_px, max(constant(7).z, 1e-6));
    float front = clamp(0.5 + mix(depths.z, depths.w, t) / change, 0.0, 1.0);
    float period = constant(7).x;
    float drawn = 1.0;
    if (period != 0.0) {
        float per_px = abs(along.w - along.z) / run_px;
        drawn = dashed(mix(along.z, along.w, t), abs(period), constant(7).y, per_px);
    }

    // Uses the cached pixels of the previous segments where their coverage is larger.
    if (constant(FADE + 1).z > 0.5) {
        ivec2 texel = ivec2(pixel - constant(FADE + 1).xy);
        float stored = texelFetch(texture_2, texel, 0).x;
        float kept_covered = max(1.0 - 2.0 * stored, 0.0);
        if (stored < 1.0 && !(covered * drawn > kept_covered)) {
            vec2 kept = texelFetch(texture_3, texel, 0).xy;
            none = false;
            covered = kept_covered;
            covered_hidden = kept_covered;
            drawn = 1.0;
            depth = kept.x;
            front = kept.y;
        }
    }

    vec4 seen = vec4(1.0, 0.0, 1.0, 1.0);
#if N_QUADRICS + N_FLATS + N_MESHES > 0
    vec4 view[5] = vec4[5](constant(0), constant(1), constant(2), constant(3), constant(4));
    seen = visibility(view, pixel, depth, constant(6).z, constant(6).w);
    if (constant(6).z >= 0.0) {
        seen.y = 1.0 - (1.0 - seen.y) * (1.0 - (1.0 - front) * constant(7).w);
        seen.xz *= 1.0 - (1.0 - front) * hold(constant(7).w);
    }
#endif
    float visible = period < 0.0 ? 1.0 : drawn;
    bool is_absent = constant(6).y < 0.0;
    bool has_glass = is_absent || period < 0.0;
    float transmitted = has_glass ? (1.0 - seen.y) / max(seen.w, 1e-3) : 1.0 - seen.y;
    float hidden = is_absent ? 0.0 : drawn * max(constant(6).y, transmitted);
    float clear = has_glass ? seen.z : seen.x;
    float alpha = constant(5).a * covered * mix(hidden, visible, clear);
    if (thins) alpha = constant(5).a * mix(covered_hidden * hidden, covered * visible, clear);
    if (has_glass) alpha *= through_glass(seen.w);
    vec2 fade = constant(FADE).xy;
    if (fade.y > fade.x) alpha *= clamp((mix(along.x, along.y, t) - fade.x) / (fade.y - fade.x), 0.0, 1.0);
    fragment = vec4(constant(5).rgb, 1.0) * alpha;
    // Where the curve meets itself only the larger coverage counts: the fragments of one curve are
    // ordered by coverage, and every curve is nearer than those drawn before.
    gl_FragDepth = none ? 1.0 : constant(FADE).z + constant(FADE).w * (1.0 - covered);
}
