// Opaque surfaces with soft lighting. Normals point outwards; a face seen from inside is lit as its
// other side. A surface with a picture uses the picture in place of its colour.
#include "light.glsl"
uniform vec4 look[4];  // eye, or direction towards it; 1 if perspective | key light | sky | colour, linear
in vec3 normal_out;
in vec3 point;
#ifdef PICTURE
uniform sampler2D texture_0;  // linear light
in vec2 place_out;
#endif
out vec4 fragment;

void main() {
    vec3 n = normal_out * inversesqrt(max(dot(normal_out, normal_out), 1e-20));
    vec3 to_eye = normalize(look[0].xyz - look[0].w * point);
    // Smooth normals may point away from the eye where the face itself, seen at a grazing angle,
    // does not. Rows run downwards, so OpenGL's front side is the inner side.
    float facing = dot(n, to_eye);
    if (facing < 0.0 && gl_FrontFacing) {
        n = -n;
        facing = -facing;
    }
    float up = 0.5 + 0.5 * dot(n, look[2].xyz);
    float lit = mesh_lit(look[1].w, look[2].w, dot(n, look[1].xyz), up);
    vec3 halfway = look[1].xyz + to_eye;
    float glint = max(dot(n, halfway) * inversesqrt(max(dot(halfway, halfway), 1e-12)), 0.0);
    float limb = 1.0 - max(facing, 0.0);
    limb *= limb * limb;
#ifdef PICTURE
    vec3 own = texture(texture_0, place_out).rgb;
#else
    vec3 own = look[3].rgb;
#endif
    vec3 colour = own * lit + mesh_gloss(look[1].w, glint) + mesh_rim(look[2].w, limb, up);
    fragment = vec4(colour, 1.0);
}
