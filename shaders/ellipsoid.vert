// Like polygon.vert, or a ring between two polygons; also outputs the direction of the line of
// sight, with unit component along the view axis.
#include "clip.glsl"
uniform vec2 corners[34];
#include "pass_constants.glsl"
uniform vec3 sights[3];  // at pixel 0, and the derivatives in x and y
noperspective out vec3 sight;
#if !RIM
noperspective out vec3 direction;  // direction and moment of the line of sight, as in quadric.glsl
noperspective out vec3 moment;
#endif

void main() {
    pass_constants();
    vec2 pixel = corners[gl_VertexID];
    sight = sights[0] + pixel.x * sights[1] + pixel.y * sights[2];
#if !RIM
    vec2 p = pixel - vec2(constants[3].w, constants[4].w);
    direction = constants[3].xyz + p.x * constants[4].xyz + p.y * constants[5].xyz;
    moment = constants[6].xyz + p.x * constants[7].xyz + p.y * constants[8].xyz;
#endif
    gl_Position = clip_from_pixel(pixel);
}
