// A convex polygon given by its corners in pixels.
#include "view.glsl"
uniform vec2 corners[16];

void main() { gl_Position = clip_from_pixel(corners[gl_VertexID]); }
