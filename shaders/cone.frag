// Translucent open cones, ray-cast, with their rims and generators. MEMBERS cones may intersect;
// ellipsoids and planes dim the parts behind them.
#include "constants.glsl"
#include "coverage.glsl"
#include "view.glsl"
#include "quadric.glsl"
#include "lines.glsl"
#include "light.glsl"
#define SOLIDS (7 + MEMBERS * member_size)
const int member_size = 10;
#include "occlusion.glsl"
//   0…4: the view   5: towards the key light; its strength   6: towards the middle of the sky; its strength
// then for each member, in axes from the apex where the cone is x² + y² = z²:
//   0, 1, 2: point of the line of sight at the apex's depth, at the anchor, and its change with the
//            pixel x, y; w: anchor x, anchor y, depth of the apex
//   3, 4, 5: direction of the line of sight likewise; w: length along the axis, width of the rim px,
//            number of generators (as wide as 0.6 rims)
//   6, 7: unit vectors across the axis in view axes, over the tangent of the half angle;
//         w: angle of the first generator
//   8: the axis in view axes; presence   9: colour, linear; opacity
out vec4 fragment;

struct Layer {
    vec3 colour;
    float alpha;
    float depth;
    vec2 depth_change;
};

// Opacity of a layer, dimmed by the objects in front of it.
float shown(vec4 v[5], vec2 pixel, float depth, float alpha) {
    vec4 seen = vec4(1.0, 0.0, 1.0, 1.0);
#if N_QUADRICS + N_FLATS + N_MESHES > 0
    seen = visibility(v, pixel, depth, -1.0, -1.0);
#endif
    return depth > v[1].w ? alpha * (seen.x + (1.0 - seen.x) * (1.0 - seen.y)) : 0.0;
}

// rim_px, apex_px: distances in the picture.
Layer sheet(vec4 v[5], vec2 pixel, int at, vec3 o, vec3 d, float t, float rim_px, float apex_px) {
    vec3 x = o + t * d;
    // Derivatives of the point on the cone with respect to the pixel.
    vec3 gx = constant(at + 1).xyz + t * constant(at + 4).xyz;
    vec3 gy = constant(at + 2).xyz + t * constant(at + 5).xyz;
    vec3 up_slope = vec3(x.xy, -x.z);
    float slant = dot(up_slope, d);
    slant = abs(slant) < 1e-12 ? 1e-12 : slant;
    vec2 dt = vec2(-dot(up_slope, gx), -dot(up_slope, gy)) / slant;
    vec3 xx = gx + d * dt.x;
    vec3 xy = gy + d * dt.y;

    Layer layer;
    layer.depth = constant(at + 2).w + t;
    layer.depth_change = dt;

    // The sheet ends at the rim and at the apex, with edges one pixel soft; the other nappe is not
    // part of the cone.
    float inside = clamp(0.5 + (x.z < constant(at + 3).w ? rim_px : -rim_px), 0.0, 1.0);
    inside *= clamp(0.5 + (x.z > 0.0 ? apex_px : -apex_px), 0.0, 1.0);

    float rim_square = max(dot(x.xy, x.xy), 1e-20);
    vec2 turn = x.x * vec2(xx.y, xy.y) - x.y * vec2(xx.x, xy.x);
    float per_angle = constant(at + 5).w / 6.2831853;
    float generators = ruled((angle_of(x.xy) - constant(at + 6).w) * per_angle,
                             dot(turn, turn) * per_angle * per_angle / (rim_square * rim_square), 0.6 * constant(at + 4).w);
    float lines = constant(at + 5).w > 0.5 ? cone_generator_ink() * generators : 0.0;

    vec3 n = up_slope.x * constant(at + 6).xyz + up_slope.y * constant(at + 7).xyz + up_slope.z * constant(at + 8).xyz;
    n *= inversesqrt(max(dot(n, n), 1e-30));
    vec3 sight = ray_direction(v, pixel);
    vec3 to_eye = -sight * inversesqrt(dot(sight, sight));
    float facing = dot(n, to_eye);
    n = facing < 0.0 ? -n : n;
    float limb = 1.0 - abs(facing);
    float up = 0.5 + 0.5 * dot(n, constant(6).xyz);
    float lit = cone_lit(constant(5).w, constant(6).w, dot(n, constant(5).xyz), up);
    vec3 tone = constant(at + 9).rgb;
    layer.colour = mix(tone * lit, tone * cone_line_tone(), lines);
    float opacity = constant(at + 9).w;
    float alpha = cone_opacity(opacity, limb * limb * limb);
    alpha = max(alpha, cone_generator_opacity() * lines) * inside;
    layer.alpha = shown(v, pixel, layer.depth, alpha * constant(at + 8).w);
    return layer;
}

float before(vec4 v[5], Layer a, Layer b) {
    float change = max(length(a.depth_change - b.depth_change), 0.05 * pixel_length(v, a.depth));
    return clamp(0.5 + (b.depth - a.depth) / change, 0.0, 1.0);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec4 view[5] = vec4[5](constant(0), constant(1), constant(2), constant(3), constant(4));
    Layer layers[3 * MEMBERS];  // both sheets and the rim of each
    for (int k = 0; k < MEMBERS; ++k) {
        int at = 7 + k * member_size;
        vec2 p = pixel - vec2(constant(at).w, constant(at + 1).w);
        vec3 o = constant(at).xyz + p.x * constant(at + 1).xyz + p.y * constant(at + 2).xyz;
        vec3 d = constant(at + 3).xyz + p.x * constant(at + 4).xyz + p.y * constant(at + 5).xyz;
        // The line meets the cone where its moment m is larger across the axis than along it.
        vec3 m = cross(o, d);
        vec3 mx = cross(constant(at + 1).xyz, d) + cross(o, constant(at + 4).xyz);
        vec3 my = cross(constant(at + 2).xyz, d) + cross(o, constant(at + 5).xyz);
        vec3 signed_m = vec3(m.xy, -m.z);
        float discriminant = dot(signed_m, m);
        vec2 gradient = 2.0 * vec2(dot(signed_m, mx), dot(signed_m, my));
        float steepness = inversesqrt(max(dot(gradient, gradient), 1e-36));
        float outline = edge_coverage(clamp(discriminant * steepness, -2.0, 2.0), gradient * steepness);
        float root = sqrt(max(discriminant, 0.0));

        float a = dot(d.xy, d.xy) - d.z * d.z;
        float b = dot(o.xy, d.xy) - o.z * d.z;
        float c = dot(o.xy, o.xy) - o.z * o.z;
        float q = -(b + (b < 0.0 ? -root : root));
        float t1 = abs(a) < 1e-12 ? 1e12 : q / a;
        float t2 = abs(q) < 1e-20 ? t1 : c / q;

        // The rim is a circle in the plane at the end of the cone.
        float descent = abs(d.z) < 1e-9 ? 1e-9 : d.z;
        float t_rim = (constant(at + 3).w - o.z) / descent;
        vec3 x = o + t_rim * d;
        vec3 gx = constant(at + 1).xyz + t_rim * constant(at + 4).xyz;
        vec3 gy = constant(at + 2).xyz + t_rim * constant(at + 5).xyz;
        vec2 from_axis = x.xy * inversesqrt(max(dot(x.xy, x.xy), 1e-20));
        vec2 change = vec2(dot(from_axis, gx.xy - d.xy * (gx.z / descent)),
                           dot(from_axis, gy.xy - d.xy * (gy.z / descent)));
        float rim_px = abs(length(x.xy) - constant(at + 3).w) * inversesqrt(max(dot(change, change), 1e-20));

        layers[3 * k] = sheet(view, pixel, at, o, d, min(t1, t2), rim_px, length(p));
        layers[3 * k + 1] = sheet(view, pixel, at, o, d, max(t1, t2), rim_px, length(p));
        // A pixel partly covered by the cone shows both sheets in the same part.
        float behind = outline * layers[3 * k + 1].alpha * (1.0 - layers[3 * k].alpha);
        layers[3 * k].alpha *= outline;
        layers[3 * k + 1].alpha = behind / max(1.0 - layers[3 * k].alpha, 1e-6);
        layers[3 * k + 2].colour = cone_line_tone() * constant(at + 9).rgb;
        layers[3 * k + 2].depth = constant(at + 2).w + t_rim;
        layers[3 * k + 2].depth_change = -vec2(gx.z, gy.z) / descent;
        layers[3 * k + 2].alpha = shown(view, pixel, layers[3 * k + 2].depth,
                                        cone_rim_opacity() * constant(at + 8).w * line_coverage(rim_px, constant(at + 4).w));
    }
    vec4 sum = vec4(0.0);
    float through = 1.0;
    for (int i = 0; i < 3 * MEMBERS; ++i) {
        float weight = layers[i].alpha;
        for (int j = 0; j < 3 * MEMBERS; ++j)
            if (j != i) weight *= 1.0 - layers[j].alpha * before(view, layers[j], layers[i]);
        sum += vec4(layers[i].colour, 1.0) * weight;
        through *= 1.0 - layers[i].alpha;
    }
    fragment = sum * ((1.0 - through) / max(sum.a, 1e-6));
}
