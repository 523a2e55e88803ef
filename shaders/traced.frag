// A curve that lasts: what trace.frag has kept of its whole segments, and its end, put over the picture.
#include "constants.glsl"
#include "coverage.glsl"
#include "stroke.glsl"
#include "view.glsl"
#include "quadric.glsl"
#define SOLIDS 12
#include "occlusion.glsl"
//   0…7: as for curve.frag, but for the period, which is not below 0
//   8: corner of the layer px   9: both ends of the last segment px
//   10: their depths; the lengths of the curve up to them   11: how they face the eye
uniform sampler2D texture_0;  // depth of the point, share in which it faces the eye
uniform sampler2D texture_2;  // (1 - coverage)/2
out vec4 fragment;

void main() {
    vec2 pixel = gl_FragCoord.xy;
    ivec2 texel = ivec2(pixel - constant(8).xy);
    vec2 kept = texelFetch(texture_0, texel, 0).xy;
    float stored = texelFetch(texture_2, texel, 0).x;
    float covered = max(1.0 - 2.0 * stored, 0.0);
    Trace last = trace_of(pixel, constant(9), constant(10).xy, constant(11).xy, constant(10).zw,
                          constant(0).w > 0.5, constant(6).x, constant(7).xy, constant(7).z);
    // Where nothing is kept, there is no depth either.
    if (last.covered > covered || stored >= 1.0) {
        covered = last.covered;
        kept = vec2(last.depth, last.front);
    }

    vec2 seen = vec2(1.0, 0.0);
#if N_QUADRICS + N_FLATS + N_MESHES > 0
    vec4 view[5] = vec4[5](constant(0), constant(1), constant(2), constant(3), constant(4));
    seen = visibility(view, pixel, kept.x, constant(6).z, constant(6).w);
    if (constant(6).z >= 0.0) {
        seen.y = 1.0 - (1.0 - seen.y) * (1.0 - (1.0 - kept.y) * constant(7).w);
        seen.x *= 1.0 - (1.0 - kept.y) * hold(constant(7).w);
    }
#endif
    float hidden = constant(6).y < 0.0 ? 0.0 : max(constant(6).y, 1.0 - seen.y);
    float alpha = constant(5).a * covered * mix(hidden, 1.0, seen.x);
    fragment = covered > 0.0 ? vec4(constant(5).rgb, 1.0) * alpha : vec4(0.0);
}
