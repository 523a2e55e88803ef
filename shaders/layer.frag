// Draws a previously rendered layer over the picture.
#include "constants.glsl"
//   0: corner of the layer in the picture px; opacity
uniform sampler2D texture_0;
out vec4 fragment;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy - constant(0).xy);
#ifdef GL_ES  // of four samples, as in occlusion.glsl
    ivec2 side = textureSize(texture_0, 0) / 2;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) sum += texelFetch(texture_0, texel + ivec2(k & 1, k >> 1) * side, 0);
    fragment = 0.25 * sum * constant(0).z;
#else
    fragment = texelFetch(texture_0, texel, 0) * constant(0).z;
#endif
}
