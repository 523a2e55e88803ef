// A straight arrow with a round shaft and a conical head. Light and depth are ray-cast; the edges
// come from the outline in the picture (the hull of two ellipses).
#include "constants.glsl"
#include "coverage.glsl"
#include "view.glsl"
#include "quadric.glsl"
#define SOLIDS 17
#include "occlusion.glsl"
#include "light.glsl"
//   0…4: the view   5: towards the key light; its strength   6: towards the middle of the sky; its strength
//   7, 8: shaft and head in the picture: px of both ends
//   9, 10: their radii px at both ends; minor over major axis of the ends' ellipses
//   11: axis, unit; hidden opacity
//   12, 13: shaft and head along the axis: where they begin, length, both radii (units)
//   14: the point of the anchor's line of sight at the depth w, from the tail
//   15: anchor px; layer drawn (0 hidden, 1 visible)   16: colour, linear; opacity
out vec4 fragment;

// Coverage of the hull of two similar ellipses with centres a and b.
float hull_coverage(vec2 p, vec4 ends, vec3 size) {
    vec2 run = ends.zw - ends.xy;
    float run_px = max(length(run), 1e-4);
    vec2 e = run_px > 1e-3 ? run / run_px : vec2(1.0, 0.0);
    vec2 from_a = p - ends.xy;
    // After stretching along the axis the ellipses are circles.
    float open = size.z;
    float side = dot(from_a, vec2(-e.y, e.x));
    vec2 q = vec2(abs(side), dot(from_a, e) / open);
    float h = run_px / open;
    float r1 = size.x;
    float r2 = size.y;
    float inside;
    float beside = 1.0;  // coverage limited by the width of an end
    vec2 gradient;
    if (abs(r1 - r2) >= h) {
        vec2 middle = r1 > r2 ? q : q - vec2(0.0, h);
        float far = max(length(middle), 1e-6);
        inside = max(r1, r2) - far;
        gradient = middle / far;
    } else {
        float b = (r1 - r2) / h;
        float a = sqrt(1.0 - b * b);
        float k = dot(q, vec2(-b, a));
        if (k < 0.0 || k > a * h) {
            vec2 middle = k < 0.0 ? q : q - vec2(0.0, h);
            float far = max(length(middle), 1e-6);
            inside = (k < 0.0 ? r1 : r2) - far;
            gradient = middle / far;
            // The edge of a flat ellipse is not a straight line near its ends.
            beside = clamp((k < 0.0 ? r1 : r2) + 0.5 - q.x, 0.0, 1.0);
        } else {
            inside = r1 - dot(q, vec2(a, b));
            gradient = vec2(a, b);
        }
    }
    vec2 in_picture = vec2(gradient.x, gradient.y / open);
    float steepness = max(length(in_picture), 1e-6);
    vec2 n = (e * in_picture.y + vec2(-e.y, e.x) * in_picture.x * sign(side + 1e-9)) / steepness;
    return min(edge_coverage(clamp(inside / steepness, -2.0, 2.0), n), beside);
}

// First intersection of the line o + t d with the outer surface of a frustum; xyz: normal, w: t.
vec4 frustum(vec3 o, vec3 d, vec3 axis, vec4 part) {
    float slope = (part.w - part.z) / part.y;
    float along_o = dot(o, axis) - part.x;
    float along_d = dot(d, axis);
    vec3 across_o = o - (along_o + part.x) * axis;
    vec3 across_d = d - along_d * axis;
    float r_o = part.z + slope * along_o;
    float r_d = slope * along_d;
    float a = dot(across_d, across_d) - r_d * r_d;
    float b = dot(across_o, across_d) - r_o * r_d;
    float c = dot(across_o, across_o) - r_o * r_o;
    float t = (-b - sqrt(max(b * b - a * c, 0.0))) / (abs(a) < 1e-9 ? 1e-9 : a);
    float h = along_o + t * along_d;
    if (a > 1e-9 && h >= 0.0 && h <= part.y) {
        vec3 n = across_o + t * across_d - (r_o + t * r_d) * slope * axis;
        return vec4(normalize(n), t);
    }
    // Beyond an end: a flat base that faces the eye, or the side where it ends; the cone itself if the
    // head is seen along its axis.
    bool meets = a > 1e-9;
    bool is_far_end = meets ? h > part.y : along_d < 0.0;
    bool faces = is_far_end == along_d < 0.0;
    float t_end = ((is_far_end ? part.y : 0.0) - along_o) / (abs(along_d) < 1e-6 ? 1e-6 : along_d);
    if (abs(along_d) > 0.02) {
        if (faces && (!is_far_end || part.w > 0.0)) return vec4(is_far_end ? axis : -axis, t_end);
        if (meets && !faces) t = t_end;
    }
    vec3 n = across_o + t * across_d - (r_o + t * r_d) * slope * axis;
    float square = dot(n, n);
    return vec4(square > 1e-20 ? n * inversesqrt(square) : -normalize(d), clamp(t, -1e3, 1e3));
}

vec3 shaded(vec3 n, vec3 to_eye) {
    float up = 0.5 + 0.5 * dot(n, constant(6).xyz);
    float lit = arrow_lit(constant(5).w, constant(6).w, dot(n, constant(5).xyz), up);
    vec3 halfway = constant(5).xyz + to_eye;
    float glint = max(dot(n, halfway) * inversesqrt(max(dot(halfway, halfway), 1e-12)), 0.0);
    return constant(16).rgb * lit + arrow_white(constant(5).w, glint);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    float in_shaft = hull_coverage(pixel, constant(7), constant(9).xyz);
    float in_head = hull_coverage(pixel, constant(8), constant(10).xyz);
    float covered = max(in_shaft, in_head);

    // The line of sight, from a point beside the arrow.
    vec4 view[5] = vec4[5](constant(0), constant(1), constant(2), constant(3), constant(4));
    vec3 d = ray_direction(view, pixel);
    vec2 off = (pixel - constant(15).xy) * pixel_length(view, constant(14).w);
    vec3 o = constant(14).xyz + off.x * view[2].xyz + off.y * view[3].xyz;
    vec3 axis = constant(11).xyz;
    vec4 shaft = frustum(o, d, axis, constant(12));
    vec4 head = frustum(o, d, axis, constant(13));
    // The nearer part is on top: the shaft if the arrow points away from the eye.
    bool away = dot(axis, d) > 0.0;
    float on_top = away ? in_shaft : in_head;
    vec4 top = away ? shaft : head;
    vec4 under = away ? head : shaft;
    bool shows_top = on_top > 0.5 * covered;
    vec3 shade = shaded(shows_top ? top.xyz : under.xyz, -normalize(d));
    float depth = constant(14).w + (shows_top ? top.w : under.w);

    float weight = constant(15).z;
#if N_QUADRICS + N_FLATS + N_MESHES > 0
    weight = layer_weight(constant(15).z, visibility(view, pixel, depth, -1.0, -1.0), constant(11).w,
                          covered * constant(16).a);
#endif
    fragment = vec4(shade, 1.0) * (covered * constant(16).a * weight);
}
