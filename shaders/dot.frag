// A round dot with a rim.
#include "view.glsl"
#include "coverage.glsl"
#include "quadric.glsl"
#include "occlusion.glsl"
uniform vec4 at;      // middle px, depth, radius px
uniform vec4 colour;  // linear; w: opacity
uniform vec4 rim;     // linear; w: width px
uniform vec3 style;   // as in arrow.frag
out vec4 fragment;

void main() {
    vec2 from_middle = gl_FragCoord.xy - at.xy;
    float r = length(from_middle);
    vec2 n = r > 1e-4 ? from_middle / r : vec2(1.0, 0.0);
    float covered = edge_coverage(clamp(at.w - r, -2.0, 2.0), n);
    float inner = rim.w > 0.0 ? edge_coverage(clamp(at.w - rim.w - r, -2.0, 2.0), n) : covered;
    float weight = style.y;
    if (style.z > 0.5) {
        vec2 seen = visibility(gl_FragCoord.xy, point_at(gl_FragCoord.xy, at.z), at.z, -1, -1);
        weight = style.y > 0.5 ? seen.x : (1.0 - seen.x) * max(style.x, 1.0 - seen.y);
    }
    vec3 premultiplied = colour.rgb * inner + rim.rgb * max(covered - inner, 0.0);
    fragment = vec4(premultiplied, covered) * (colour.a * weight);
}
