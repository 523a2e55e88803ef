// Bands of a vertical gradient; the colours are exact at the edges of the bands.
#include "clip.glsl"
uniform vec4 box;  // left, top, right, bottom, px
uniform vec4 bands[33];
out vec4 colour;

void main() {
    int band = gl_VertexID >> 1;
    float side = float(gl_VertexID & 1);
    colour = bands[band];
    gl_Position = clip_from_pixel(mix(box.xy, box.zw, vec2(side, float(band) / 32.0)));
}
