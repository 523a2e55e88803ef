// A round dot with a rim.
#include "constants.glsl"
#include "coverage.glsl"
#include "view.glsl"
#include "quadric.glsl"
#define SOLIDS 9
#include "occlusion.glsl"
//   0…4: the view   5: middle px, depth, radius px   6: colour, linear; opacity
//   7: colour of the rim, linear; width px   8: hidden opacity, layer drawn (0 hidden, 1 visible)
out vec4 fragment;

void main() {
    vec2 from_middle = gl_FragCoord.xy - constant(5).xy;
    float r = length(from_middle);
    vec2 n = r > 1e-4 ? from_middle / r : vec2(1.0, 0.0);
    float radius = constant(5).w;
    float covered = edge_coverage(clamp(radius - r, -2.0, 2.0), n);
    float inner = edge_coverage(clamp(radius - constant(7).w - r, -2.0, 2.0), n);
    float weight = constant(8).y;
#if N_QUADRICS + N_FLATS + N_MESHES > 0
    vec4 view[5] = vec4[5](constant(0), constant(1), constant(2), constant(3), constant(4));
    vec4 seen = visibility(view, gl_FragCoord.xy, constant(5).z, -1.0, -1.0);
    weight = layer_weight(constant(8).y, seen, constant(8).x, covered * constant(6).a);
#endif
    vec3 premultiplied = constant(6).rgb * inner + constant(7).rgb * max(covered - inner, 0.0);
    fragment = vec4(premultiplied, covered) * (constant(6).a * weight);
}
