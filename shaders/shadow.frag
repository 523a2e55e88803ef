// What ellipsoids take from the light of a plane: of the sky, most where they touch it; of the key
// light, softly, as from a wide lamp.
#include "view.glsl"
uniform mat3 plane_from_pixel;
uniform vec2 anchor;
uniform vec4 disc;           // as in plane.frag
uniform vec3 tint;           // linear colour of the deepest shadow
uniform int n_casters;
uniform mat3 sphere_from_pixel[max_quadrics];  // homogeneous with the w of plane_from_pixel
uniform vec3 normal_u[max_quadrics];           // the plane's normal as the sphere's axes see it, unit
uniform vec3 light_u[max_quadrics];            // likewise towards the key light
out vec4 fragment;

const float lamp_angle = 0.34;  // half the angle that the key light fills, rad
const float far_occlusion = 0.012;

void main() {
    vec3 pixel = vec3(gl_FragCoord.xy - anchor, 1.0);
    vec3 h = plane_from_pixel * pixel;
    if (h.z <= 0.0) discard;
    float sky_left = 1.0;
    float key_left = 1.0;
    for (int i = 0; i < n_casters; ++i) {
        vec3 u = sphere_from_pixel[i] * pixel / h.z;
        float inverse_distance = min(inversesqrt(dot(u, u)), 1.0);
        vec3 towards = -u * inverse_distance;
        // Cosine-weighted share of the sky behind a sphere, brought to zero a few radii away.
        float above = max(dot(normal_u[i], towards), 0.0);
        float hidden = above * inverse_distance * inverse_distance;
        sky_left *= 1.0 - clamp((hidden - far_occlusion) / (1.0 - far_occlusion), 0.0, 1.0);
        // Overlap of the lamp's disc with the sphere's, by the angle between their middles.
        float apart = acos(clamp(dot(light_u[i], towards), -1.0, 1.0));
        float radius = asin(inverse_distance);
        float covered = 1.0 - smoothstep(radius - lamp_angle, radius + lamp_angle, apart);
        float largest = min(radius / lamp_angle, 1.0);
        key_left *= 1.0 - covered * largest * largest;
    }
    float full = light.w + sky.w;
    float lit = (light.w * mix(1.0, key_left, 0.75) + sky.w * sky_left) / full;
    float r = length(h.xy / h.z) / disc.x;
    float visible = disc.z * (1.0 - smoothstep(disc.y, 1.0, r));
    float depth = (1.0 - lit) * visible;
    fragment = vec4(tint, 1.0) * depth;
}
