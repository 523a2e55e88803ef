// As polygon.vert, or a ring between two polygons, with the direction of the line of sight, of unit component along the view axis.
#include "clip.glsl"
uniform vec2 corners[34];
uniform vec4 constants[N_FLAT];
uniform vec3 sights[3];  // at pixel 0, and its change with x and y
flat out vec4 flat_constants[N_FLAT];
out vec3 sight;

void main() {
    for (int i = 0; i < N_FLAT; ++i) flat_constants[i] = constants[i];
    vec2 pixel = corners[gl_VertexID];
    sight = sights[0] + pixel.x * sights[1] + pixel.y * sights[2];
    gl_Position = clip_from_pixel(pixel);
}
