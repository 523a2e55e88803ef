// What every pass knows of the view: its projection, light and the solids that hide things.
// Pixels are those of the whole picture, x right, y down, centres at half integers.

const int max_quadrics = 8;
const int max_flats = 4;

// An ellipsoid as rays meet it, in axes where it is the unit sphere about the origin. For the
// pixel p the ray has direction d and moment m (its Plücker coordinates), both affine in p:
// d = d0 + x dx + y dy with (x, y) = p - anchor; they are scaled alike.
struct Quadric {
    vec4 d0;  // w: anchor x
    vec4 dx;  // w: anchor y
    vec4 dy;  // w: opacity
    vec4 m0;  // w: curvature of the discriminant along `narrow`
    vec4 mx;  // w: greatest transition of `facing` at the limb, for a tenth of a pixel
    vec4 my;
    vec4 depth;  // depth along the view axis is w + xyz·u for the point u of the sphere
    vec4 gx;     // change of a point with the pixel at unit depth (perspective), or as is
    vec4 gy;
    vec4 eye;       // homogeneous: w 1 in perspective, 0 if orthographic
    vec4 narrow;    // xy: direction in which the outline is narrowest; z: 1 if below 1.5 px
    vec4 to_u[3];   // rows of u = to_u·(X, 1)
};

// A plane as something that hides.
struct Flat {
    vec4 normal;  // w: offset, so that the signed height of X is xyz·X + w
    vec4 centre;  // w: radius
    vec4 look;    // opacity, where fading begins (fraction), side of the eye (±1), 0
};

layout(std140) uniform View {
    vec4 picture;  // width, height and their inverses
    vec4 lens;     // pixel of the view axis; 1/focal length in px (or 1/(px a unit)); 1 if perspective
    vec4 eye;      // w: least depth that is drawn
    vec4 right;
    vec4 down;
    vec4 forward;
    vec4 light;  // towards the key light; w: its strength
    vec4 sky;    // towards the middle of the sky; w: its strength
    ivec4 counts;  // quadrics, flats, whether there is mesh depth
    Quadric quadrics[max_quadrics];
    Flat flats[max_flats];
};

vec4 clip_from_pixel(vec2 pixel) {
    return vec4(2.0 * pixel * picture.zw - 1.0, 0.0, 1.0);
}

// Direction with unit component along the view axis.
vec3 ray_direction(vec2 pixel) {
    vec2 slope = (pixel - lens.xy) * (lens.z * lens.w);
    return forward.xyz + slope.x * right.xyz + slope.y * down.xyz;
}

// Length of a pixel's side at a depth.
float pixel_length(float depth) { return lens.z * mix(1.0, depth, lens.w); }

// The point seen at a pixel at a depth.
vec3 point_at(vec2 pixel, float depth) {
    vec2 across = (pixel - lens.xy) * pixel_length(depth);
    return eye.xyz + depth * forward.xyz + across.x * right.xyz + across.y * down.xyz;
}

// xy: pixel, z: depth.
vec3 projected(vec3 point) {
    vec3 from_eye = point - eye.xyz;
    float depth = dot(from_eye, forward.xyz);
    vec2 across = vec2(dot(from_eye, right.xyz), dot(from_eye, down.xyz));
    return vec3(lens.xy + across / pixel_length(depth), depth);
}
