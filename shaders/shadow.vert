// A shadow web, computed in render/shadow_web.h.
#include "clip.glsl"
uniform vec4 deepest;  // linear colour of the deepest shadow
layout(location = 0) in vec4 corner;  // pixel x and y times the depth, the depth, the darkness
flat out vec4 tint;
out float darkness;

void main() {
    tint = deepest;
    darkness = corner.w;
    gl_Position = projection * vec4(corner.xy, 0.0, corner.z);
}
