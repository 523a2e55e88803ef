// Draws a previously rendered layer over the picture.
#include "constants.glsl"
//   0: corner of the layer in the picture px; opacity
uniform sampler2D texture_0;
out vec4 fragment;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy - constant(0).xy);
    fragment = texelFetch(texture_0, texel, 0) * constant(0).z;
}
