// Set type from a texture of coverage (red) and of its halo (green).
#include "constants.glsl"
//   0: what to add to a pixel to find its texel; 1/width and 1/height of the texture
//   1: colour, linear; opacity   2: colour of the halo, linear
//   3: pixels for a sample's side
uniform sampler2D texture_0;
out vec4 fragment;

void main() {
    // All samples of a pixel show what its middle does: ink is no sum of its samples' inks.
    vec2 pixel = floor(gl_FragCoord.xy * constant(3).x) + 0.5;
    vec2 covered = texture(texture_0, (pixel + constant(0).xy) * constant(0).zw).rg;
    // Mixed in linear light, dark ink looks thinner than its coverage: half covered counts as 0.7.
    float ink = covered.r * (1.8 - 0.8 * covered.r);
    float halo = max(covered.g - ink, 0.0);
    fragment = vec4(constant(1).rgb * ink + constant(2).rgb * halo, ink + halo) * constant(1).a;
}
