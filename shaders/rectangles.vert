// Rectangles given by their corners in pixels, with the constants of their fragments.
#include "clip.glsl"
layout(location = 0) in vec2 corner;
uniform vec4 constants[N_FLAT];
flat out vec4 flat_constants[N_FLAT];

void main() {
    for (int i = 0; i < N_FLAT; ++i) flat_constants[i] = constants[i];
    gl_Position = clip_from_pixel(corner);
}
