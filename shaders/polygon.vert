// A convex polygon given by its corners in pixels, with the constants of its fragments.
#include "clip.glsl"
uniform vec2 corners[16];
uniform vec4 constants[N_FLAT];
flat out vec4 flat_constants[N_FLAT];

void main() {
    for (int i = 0; i < N_FLAT; ++i) flat_constants[i] = constants[i];
    gl_Position = clip_from_pixel(corners[gl_VertexID]);
}
