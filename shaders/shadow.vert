// What an ellipsoid takes from the light of a plane: of the sky, most where they touch; of the key
// light, softly, as from a wide lamp. Both are smooth but at the touch, so they are computed at the
// corners of a web of rings about it, and interpolated.
#include "clip.glsl"
#include "view.glsl"
uniform vec4 constants[15];
//   0…4: the view   5: towards the light; strength of the key light   6: strength of the sky in w
//   7: point of the plane nearest to the ellipsoid; radius of the web
//   8, 9: two unit vectors in the plane   10: middle of the plane's disc; radius
//   11: opacity of the plane; where it begins to fade
//   12: the plane's normal, towards the ellipsoid, in the sphere's axes, unit
//   13: direction towards the lamp likewise   14: middle of the web from the nearest point
uniform vec4 to_u[3];  // rows of u = to_u·(X, 1), where the ellipsoid is the unit sphere
uniform vec4 deepest;  // linear colour of the deepest shadow
flat out vec4 tint;
noperspective out float darkness;

const int n_rings = 16;
const int n_spokes = 48;
const float lamp = 0.33;  // sine of half the angle that the key light fills
const float far_sky = 0.07;

float light_taken(vec3 point) {
    vec4 x = vec4(point, 1.0);
    vec3 u = vec3(dot(to_u[0], x), dot(to_u[1], x), dot(to_u[2], x));
    float inverse_distance = min(inversesqrt(dot(u, u)), 1.0);
    vec3 towards = -u * inverse_distance;
    // Cosine-weighted share of the sky behind a sphere, brought to zero a few radii away.
    float hidden = max(dot(constants[12].xyz, towards), 0.0) * inverse_distance * inverse_distance;
    float sky_taken = max(hidden - far_sky, 0.0) / (1.0 - far_sky);
    // Overlap of the lamp's disc with the sphere's: by the sine of the sphere's angular radius
    // less the angle to the lamp, continued past a right angle.
    float towards_lamp = dot(constants[13].xyz, towards);
    float beside_lamp = sqrt(max(1.0 - towards_lamp * towards_lamp, 0.0));
    if (towards_lamp < 0.0) beside_lamp = 2.0 - beside_lamp;
    float cosine = sqrt(1.0 - inverse_distance * inverse_distance);
    float overlap = inverse_distance * towards_lamp - cosine * beside_lamp;
    float largest = min(inverse_distance / lamp, 1.0);
    float key_taken = 0.75 * smoothstep(-lamp, lamp, overlap) * largest * largest;
    return (constants[5].w * key_taken + constants[6].w * sky_taken) / max(constants[5].w + constants[6].w, 1e-6);
}

void main() {
    tint = deepest;
    int ring = gl_VertexID / n_spokes;
    float angle = 6.28318530718 * float(gl_VertexID % n_spokes) / float(n_spokes);
    float share = float(ring) / float(n_rings);
    // Spokes run from the touch to the web's rim.
    vec2 spoke = vec2(cos(angle), sin(angle));
    float inward = dot(spoke, constants[14].xy);
    float beside = spoke.x * constants[14].y - spoke.y * constants[14].x;
    float reach = inward + sqrt(max(constants[7].w * constants[7].w - beside * beside, 0.0));
    vec2 place = (reach * share * share) * spoke;
    vec3 point = constants[7].xyz + place.x * constants[8].xyz + place.y * constants[9].xyz;
    float r = length(point - constants[10].xyz) / constants[10].w;
    float visible = constants[11].x * (1.0 - smoothstep(constants[11].y, 1.0, r));
    // The web's rim is dark by less than a level; it ends at nothing all the same.
    darkness = light_taken(point) * visible * (1.0 - smoothstep(0.8, 1.0, share));
    vec4 view[5] = vec4[5](constants[0], constants[1], constants[2], constants[3], constants[4]);
    vec3 at = projected(view, point);
    gl_Position = clip_from_pixel(at.xy) * (view[0].w > 0.5 ? at.z : 1.0);
}
