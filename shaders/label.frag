// Set type from a texture of coverage (red) and of its halo (green).
#include "constants.glsl"
//   0: what to add to a pixel to find its texel; 1/width and 1/height of the texture
//   1: colour, linear; opacity   2: colour of the halo, linear
uniform sampler2D texture_0;
out vec4 fragment;

void main() {
    vec2 covered = texture(texture_0, (gl_FragCoord.xy + constant(0).xy) * constant(0).zw).rg;
    float halo = max(covered.g - covered.r, 0.0);
    fragment = vec4(constant(1).rgb * covered.r + constant(2).rgb * halo, covered.r + halo) * constant(1).a;
}
