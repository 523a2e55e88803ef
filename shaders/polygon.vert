// A convex polygon given by its corners in pixels, with the constants of its fragments.
#include "clip.glsl"
uniform vec2 corners[16];
#include "pass_constants.glsl"

void main() {
    pass_constants();
    gl_Position = clip_from_pixel(corners[gl_VertexID]);
}
