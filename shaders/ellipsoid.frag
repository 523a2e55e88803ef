// Translucent ellipsoids, ray-cast. MEMBERS ellipsoids may intersect: every surface on the line of
// sight is weighted by the surfaces in front of it. RIM is 0 for the part of a single ellipsoid
// well inside its outline, where coverage is full. llvmpipe computes divisions and roots exactly,
// at the cost of ten products each, so there are few of them.
#include "constants.glsl"
#include "coverage.glsl"
#include "quadric.glsl"
#include "lines.glsl"
#include "light.glsl"
//   0: towards the key light; its strength   1: w: the sky's strength
//   2: least depth that is drawn, 1 if perspective, 1/focal length in px
// then for each member, after the seven of quadric.glsl:
//   7, 8: derivatives of u with respect to the pixel x, y at unit depth (orthographic: at any depth); w: ruling width px,
//         opacity of the rulings
//   9, 10: towards the key light and the sky, mapped into the sphere's axes; w: meridians, parallels
//   11: 1/squares of the half axes; presence. These three in the scale of d.
//   12: colour, linear; opacity   13: colour of the lines, linear; width px of the principal sections
//   14: colour of the contour, linear; its width px
const int first_member = 3;
const int member_size = 15;
noperspective in vec3 sight;
#if !RIM
noperspective in vec3 direction;
noperspective in vec3 moment;
#endif
out vec4 fragment;

const float pi = 3.14159265358979;

// One surface on the line of sight.
struct Layer {
    vec3 colour;
    float alpha;
    float depth;
    vec2 depth_change;  // derivatives with respect to the pixel
};

// Abramowitz & Stegun 4.4.45, accurate to 1e-4 rad: a fiftieth of a pixel.
float arcsine(float x) {
    float y = abs(x);
    float p = ((-0.0187293 * y + 0.0742610) * y - 0.2121144) * y + 1.5707288;
    float angle = 0.5 * pi - sqrt(max(1.0 - y, 0.0)) * p;
    return x < 0.0 ? -angle : angle;
}

#if RIM
// Coverage by the contour, whose outer edge is the outline. A body that is narrower than some
// pixels has none.
float contour_coverage(int at, Sight s) {
    vec2 normal;
    float width_px = constant(at + 14).w;
    float covered = line_coverage(outline_distance(at, s, normal) - 0.5 * width_px, width_px);
    return constant(at + 5).w < 0.0 ? 0.0 : covered;
}

// Distances of the pixel from the three principal sections, px: from their outer halves (x) and
// inner halves (y). In the picture, the section u_k = 0 is the conic |m|² - m_k² - d_k² = 0. It is
// smooth at the limb, where the derivatives of u diverge. Along its gradient it is a parabola,
// whose two roots are the distances: exact for straight lines, however close both halves are, and
// of second order for curves. At a root, the line of sight enters the ellipsoid if (d × m)_k and
// d_k have the same sign; otherwise it leaves the ellipsoid.
vec2 to_sections(int at, Sight s) {
    vec3 dx = constant(at + 1).xyz, dy = constant(at + 2).xyz, mx = constant(at + 4).xyz, my = constant(at + 5).xyz;
    vec3 conic = dot(s.m, s.m) - s.m * s.m - s.d * s.d;
    vec3 half_x = dot(s.m, mx) - s.m * mx - s.d * dx;
    vec3 half_y = dot(s.m, my) - s.m * my - s.d * dy;
    vec3 square = max(half_x * half_x + half_y * half_y, 1e-30);
    vec3 per_slope = inversesqrt(square);
    vec3 nx = half_x * per_slope, ny = half_y * per_slope;
    vec3 d_change = dx * nx + dy * ny, m_change = mx * nx + my * ny;
    vec3 bend = nx * nx * dot(mx, mx) + ny * ny * dot(my, my) + 2.0 * nx * ny * dot(mx, my) -
                m_change * m_change - d_change * d_change;
    vec3 sum = square * per_slope + sqrt(max(square - bend * conic, 0.0));
    vec3 near = conic / sum;
    vec3 far = sum / mix(bend, vec3(1e-20), lessThan(abs(bend), vec3(1e-20)));
    vec3 across = cross(s.d, s.m);
    vec3 change = nx * (cross(dx, s.m) + cross(s.d, mx)) + ny * (cross(dy, s.m) + cross(s.d, my));
    vec3 near_half = (across - near * change) * sign(s.d - near * d_change);
    vec3 far_half = (across - far * change) * sign(s.d - far * d_change);
    vec3 none = vec3(1e9), both = vec3(2e-6 * s.square);  // above the rounding error
    near = abs(near);
    far = abs(far);
    vec3 outer = min(mix(near, none, lessThan(near_half, -both)), mix(far, none, lessThan(far_half, -both)));
    vec3 inner = min(mix(near, none, greaterThan(near_half, both)), mix(far, none, greaterThan(far_half, both)));
    return vec2(min(min(outer.x, outer.y), outer.z), min(min(inner.x, inner.y), inner.z));
}
#else
// Distance of the pixel from the three principal sections, px, well inside the limb: from the point
// u, whose derivatives are the roots of `square` times that of stretch_square.
float to_sections(vec3 u_square, vec3 square, float stretch_square) {
    // The nearest section: the smallest u²/square, compared by products.
    vec3 d = max(square, 1e-12);
    vec2 least = u_square.x * d.y < u_square.y * d.x ? vec2(u_square.x, d.x) : vec2(u_square.y, d.y);
    least = u_square.z * least.y < least.x * d.z ? vec2(u_square.z, d.z) : least;
    return sqrt(least.x / (stretch_square * least.y));
}
#endif

// Meridians and parallels about the third axis; longitudes are counted from the first. ux, uy:
// derivatives of u with respect to the pixel, divided by the root of stretch_square.
float rulings(vec3 u, vec3 u_square, vec3 ux, vec3 uy, float stretch_square, float width_px, float n_meridians,
              float n_parallels) {
    float rim_square = max(u_square.x + u_square.y, 1e-9);
    vec2 turn = u.x * vec2(ux.y, uy.y) - u.y * vec2(ux.x, uy.x);
    float per_longitude = n_meridians / (2.0 * pi);
    float per_latitude = (n_parallels + 1.0) / pi;
    float longitude_square = dot(turn, turn) * (stretch_square * (per_longitude * per_longitude));
    float latitude_square = (ux.z * ux.z + uy.z * uy.z) * (stretch_square * (per_latitude * per_latitude));
    float meridians = ruled_apart(angle_of(u.xy) * per_longitude,
                                  rim_square * inversesqrt(max(longitude_square, 1e-20)), width_px);
    float parallels = ruled_apart((arcsine(u.z) + 0.5 * pi) * per_latitude,
                                  sqrt(rim_square / max(latitude_square, 1e-20)), width_px);
    return max(n_meridians > 0.5 ? meridians : 0.0, n_parallels > 0.5 ? parallels : 0.0);
}

// Values shared by all surfaces on one line of sight.
struct Gaze {
    float per_length;   // 1/length of the line's direction in view axes
    float per_halfway;  // 1/square of the vector halfway between eye and key light
};

Gaze gaze_of() {
    Gaze g;
    g.per_length = inversesqrt(dot(sight, sight));
    g.per_halfway = 1.0 / max(2.0 - 2.0 * g.per_length * dot(sight, constant(0).xyz), 1e-6);
    return g;
}

// The surface where the line of sight enters (side -1: the outer surface) or leaves (side +1: the
// inner one) the ellipsoid. slide: d/root. The normal is needed only in products with directions;
// they equal the products of u with the directions mapped to the sphere's axes, and the product
// with the line of sight is the root.
#if RIM
Layer surface(int at, Sight s, vec3 slide, float side, Gaze gaze, float section_distance) {
    vec3 u = sphere_point(s, side);
#else
Layer surface(int at, Sight s, vec3 slide, float side, Gaze gaze) {
    vec3 u = s.nearest + (side * s.root * s.per_square) * s.d;
#endif
    vec3 u_square = u * u;
    Layer layer;
    layer.depth = depth_of(at, u);

    // Derivatives of the point on the sphere with respect to the pixel, at unit depth; u·d is the
    // root.
    vec3 gx = constant(at + 7).xyz;
    vec3 gy = constant(at + 8).xyz;
    vec3 ux = gx - slide * (side * dot(u, gx));
    vec3 uy = gy - slide * (side * dot(u, gy));
    float stretch = constant(2).y > 0.5 ? layer.depth : 1.0;
#if MEMBERS > 1
    layer.depth_change = stretch * vec2(dot(constant(at + 6).xyz, ux), dot(constant(at + 6).xyz, uy));
#endif
    float stretch_square = stretch * stretch;
#if !RIM
    float section_distance = to_sections(u_square, ux * ux + uy * uy, stretch_square);
#endif
    float lines = line_coverage(section_distance, constant(at + 13).w);
    if (side < 0.0)
        lines = max(lines, constant(at + 8).w * rulings(u, u_square, ux, uy, stretch_square,
                                                        constant(at + 7).w, constant(at + 9).w, constant(at + 10).w));

    float per_normal = inversesqrt(dot(u_square, constant(at + 11).xyz));
    float facing = min(s.root * per_normal * gaze.per_length, 1.0);
    float limb = 1.0 - facing;
    limb *= limb * limb;

    float key_strength = constant(0).w;
    float sky_strength = constant(1).w;
    float outward = -side * per_normal;
    float to_key = outward * dot(u, constant(at + 9).xyz);
    float up = 0.5 + (0.5 * outward) * dot(u, constant(at + 10).xyz);
    float lit = ellipsoid_lit(key_strength, sky_strength, to_key, up);

    float opacity = constant(at + 12).w;
    float alpha;
    if (side < 0.0) {
        float glint = max(to_key + facing, 0.0);
        float gloss = ellipsoid_gloss(glint * glint * gaze.per_halfway);
        layer.colour = mix(constant(at + 12).rgb, constant(at + 13).rgb, lines) * lit +
                       ellipsoid_white(key_strength, sky_strength, gloss, lines, limb, up);
        alpha = ellipsoid_outer_opacity(opacity, limb);
        alpha = mix(alpha, max(alpha, ellipsoid_outer_lines()), lines);
#if RIM
        float contour = contour_coverage(at, s);
        layer.colour *= alpha * (1.0 - contour);
        alpha = mix(alpha, 1.0, contour);
        layer.colour = (layer.colour + contour * constant(at + 14).rgb) / max(alpha, 1e-6);
#endif
    } else {
        layer.colour = mix(constant(at + 12).rgb, constant(at + 13).rgb, lines) * ellipsoid_inner_lit(lit);
        alpha = ellipsoid_inner_opacity(opacity, limb);
        alpha = mix(alpha, max(alpha, ellipsoid_inner_lines()), lines);
    }
    alpha *= constant(at + 11).w;
#if RIM
    alpha = layer.depth > constant(2).x ? alpha : 0.0;
#endif
    layer.alpha = alpha;
    return layer;
}

// A pixel partly covered by the ellipsoid shows both its surfaces in the same part.
void cover(inout Layer front, inout Layer back, float covered) {
    float behind = covered * back.alpha * (1.0 - front.alpha);
    front.alpha *= covered;
    back.alpha = behind / max(1.0 - front.alpha, 1e-6);
}

// 1 if a is in front of b, with a step one pixel wide where they intersect.
float before(Layer a, Layer b) {
    float change = length(a.depth_change - b.depth_change);
    float pixel = constant(2).z * (constant(2).y > 0.5 ? a.depth : 1.0);
    return clamp(0.5 + (b.depth - a.depth) / max(change, 0.02 * pixel), 0.0, 1.0);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    Gaze gaze = gaze_of();
#if MEMBERS == 1
#if RIM
    Sight s = sight_of(first_member, pixel);
    vec2 apart = to_sections(first_member, s);
#else
    Sight s = sight_along(direction, moment);
#endif
    vec3 slide = s.d * (1.0 / s.root);
#if RIM
    Layer front = surface(first_member, s, slide, -1.0, gaze, apart.x);
    Layer back = surface(first_member, s, slide, 1.0, gaze, apart.y);
#else
    Layer front = surface(first_member, s, slide, -1.0, gaze);
    Layer back = surface(first_member, s, slide, 1.0, gaze);
#endif
    float behind = (1.0 - front.alpha) * back.alpha;
    fragment = vec4(front.colour * front.alpha + back.colour * behind, front.alpha + behind);
#if RIM
    fragment *= outline_coverage(first_member, s);
#endif
#else
    Layer layers[2 * MEMBERS];
    for (int k = 0; k < MEMBERS; ++k) {
        int at = first_member + k * member_size;
        Sight s = sight_of(at, pixel);
        vec3 slide = s.d * (1.0 / s.root);
        vec2 apart = to_sections(at, s);
        layers[2 * k] = surface(at, s, slide, -1.0, gaze, apart.x);
        layers[2 * k + 1] = surface(at, s, slide, 1.0, gaze, apart.y);
        cover(layers[2 * k], layers[2 * k + 1], outline_coverage(at, s));
    }
    vec4 sum = vec4(0.0);
    float through = 1.0;
    for (int a = 0; a < 2 * MEMBERS; ++a) {
        float weight = layers[a].alpha;
        for (int b = 0; b < 2 * MEMBERS; ++b)
            if (b != a) weight *= 1.0 - layers[b].alpha * before(layers[b], layers[a]);
        sum += vec4(layers[a].colour, 1.0) * weight;
        through *= 1.0 - layers[a].alpha;
    }
    fragment = sum * ((1.0 - through) / max(sum.a, 1e-6));
#endif
}
