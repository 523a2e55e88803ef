// Writes the cached segments of a lasting curve: the depth of the point and, on an ellipsoid, the
// share to which it faces the eye. Where segments meet, the larger coverage counts, which the depth
// buffer stores as (1 - coverage)/2; of equal ones, the first.
#include "constants.glsl"
#include "coverage.glsl"
#include "stroke.glsl"
//   0…4: the view   5: corner of the layer px; width of the stroke px; least step of facing
//   6: period of the dashes in lengths of the curve (0: solid), share of it that is drawn; distance
//      from a segment up to which pixels are cached, px
flat in vec4 ends;
flat in vec4 neighbours;
flat in vec4 along;
flat in vec4 depths;
out vec2 kept;

void main() {
    vec2 pixel = gl_FragCoord.xy + constant(5).xy;
    vec2 own = from_segment(pixel, ends.xy, ends.zw);
    float covered = max(stroke_coverage(pixel, ends, own, constant(5).z), 0.0);
    float t = along_segment(own.y, depths.xy, constant(0).w > 0.5);
    float run_px = max(length(ends.zw - ends.xy), 1e-3);
    if (constant(6).x > 0.0) {
        // Beyond its end, a segment has the same coverage as the next one, so that either may be
        // used where both are drawn: their exact extent there depends on rounding.
        float beyond = dot(pixel - ends.xy, ends.zw - ends.xy) / (run_px * run_px);
        float reach = 2.0 / run_px;
        float t_dash = along_segment(clamp(beyond, -reach, 1.0 + reach), depths.xy, constant(0).w > 0.5);
        float per_px = abs(along.w - along.z) / run_px;
        covered *= dashed(mix(along.z, along.w, t_dash), constant(6).x, constant(6).y, per_px);
    }
    float change = max(abs(depths.w - depths.z) / run_px, max(constant(5).w, 1e-6));
    kept = vec2(mix(depths.x, depths.y, t), clamp(0.5 + mix(depths.z, depths.w, t) / change, 0.0, 1.0));
    gl_FragDepth = own.x > constant(6).z ? 1.0 : 0.5 - 0.5 * covered;
}
