// Typeset text from a texture with coverage (red), the coverage of its halo (green) and the number
// of its ink (blue).
#include "constants.glsl"
//   0: offset from a pixel to its texel
//   1: colour, linear; opacity   2: colour of the halo, linear
//   3: pixels per side of a sample
//   4…: the inks 1, 2, …, linear
uniform sampler2D texture_0;
out vec4 fragment;

vec2 texel_at(ivec2 texel) { return texelFetch(texture_0, texel, 0).rg; }

// The label's own colour, or the ink of the pixel's middle.
vec3 ink_at(vec2 place) {
    int ink = int(255.0 * texelFetch(texture_0, ivec2(floor(place + 0.5)), 0).b + 0.5);
    vec3 colour = constant(1).rgb;
    for (int k = 1; k <= N_CONSTANTS - 4; ++k)
        if (ink == k) colour = constant(3 + k).rgb;
    return colour;
}

void main() {
    // All samples of a pixel get the ink of the pixel's centre: ink is not linear in the samples.
    vec2 pixel = floor(gl_FragCoord.xy * constant(3).x) + 0.5;
    // Filtered here, because Mesa 22 and Mesa 26 round ties differently in their texture filter.
    vec2 place = pixel + constant(0).xy - 0.5;
    ivec2 texel = ivec2(floor(place));
    vec2 share = place - vec2(texel);
    vec2 upper = mix(texel_at(texel), texel_at(texel + ivec2(1, 0)), share.x);
    vec2 lower = mix(texel_at(texel + ivec2(0, 1)), texel_at(texel + ivec2(1, 1)), share.x);
    vec2 covered = mix(upper, lower, share.y);
    // Blended in linear light, dark ink looks thinner than its coverage: a coverage of 0.5 counts
    // as 0.7.
    float ink = covered.r * (1.8 - 0.8 * covered.r);
    float halo = max(covered.g - ink, 0.0);
    fragment = vec4(ink_at(place) * ink + constant(2).rgb * halo, ink + halo) * constant(1).a;
}
