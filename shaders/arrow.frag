// A straight arrow: a round shaft and a conical head, ray-cast for light and depth, its edges from
// the outline in the picture (the hull of two ellipses).
#include "view.glsl"
#include "coverage.glsl"
#include "quadric.glsl"
#include "occlusion.glsl"
uniform vec4 outline[2];  // shaft, head: px of both ends
uniform vec4 shape[2];    // shaft, head: radius px at both ends; how open the ends' ellipses are; 0
uniform vec3 axis;        // unit
uniform vec4 body[2];     // shaft, head: where it begins along the axis, length, both radii (units)
uniform vec4 base;        // point of the line of sight of `anchor` at `base.w`, from the tail
uniform vec2 anchor;
uniform vec4 colour;      // linear; w: opacity
uniform vec3 style;       // hidden opacity; layer drawn: 0 hidden, 1 visible; occluded?
out vec4 fragment;

// Coverage by the hull of two similar ellipses with middles a and b.
float hull_coverage(vec2 p, vec4 ends, vec4 size) {
    vec2 run = ends.zw - ends.xy;
    float run_px = max(length(run), 1e-4);
    vec2 e = run / run_px;
    vec2 from_a = p - ends.xy;
    // Stretched along the axis the ellipses are circles.
    float open = size.z;
    float side = dot(from_a, vec2(-e.y, e.x));
    vec2 q = vec2(abs(side), dot(from_a, e) / open);
    float h = run_px / open;
    float r1 = size.x;
    float r2 = size.y;
    float inside;
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
        } else {
            inside = r1 - dot(q, vec2(a, b));
            gradient = vec2(a, b);
        }
    }
    vec2 in_picture = vec2(gradient.x, gradient.y / open);
    float steepness = max(length(in_picture), 1e-6);
    vec2 n = (e * in_picture.y + vec2(-e.y, e.x) * in_picture.x * sign(side + 1e-9)) / steepness;
    return edge_coverage(clamp(inside / steepness, -2.0, 2.0), n);
}

// Outer surface of a frustum where the line o + t d meets it first; xyz: normal, w: t.
vec4 frustum(vec3 o, vec3 d, vec4 part) {
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
    // Past an end: the flat base, or for the head seen along its axis the cone all round.
    float end = along_d > 0.0 ? 0.0 : part.y;
    float t_end = (end - along_o) / (abs(along_d) < 1e-6 ? 1e-6 : along_d);
    if (abs(along_d) > 0.02 && (along_d > 0.0 || part.w > 0.0))
        return vec4(along_d > 0.0 ? -axis : axis, t_end);
    vec3 n = across_o + t * across_d - (r_o + t * r_d) * slope * axis;
    float square = dot(n, n);
    return vec4(square > 1e-20 ? n * inversesqrt(square) : -normalize(d), clamp(t, -1e3, 1e3));
}

vec3 shaded(vec3 n, vec3 to_eye) {
    float key = max((dot(n, light.xyz) + 0.3) / 1.3, 0.0);
    float up = 0.5 + 0.5 * dot(n, sky.xyz);
    float lit = light.w * key + sky.w * mix(0.5, 1.0, up) + 0.10;
    float glint = max(dot(n, normalize(light.xyz + to_eye)), 0.0);
    float g2 = glint * glint, g4 = g2 * g2, g8 = g4 * g4;
    return colour.rgb * lit + 0.10 * light.w * g8 * g8 * g8;
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    float in_shaft = hull_coverage(pixel, outline[0], shape[0]);
    float in_head = hull_coverage(pixel, outline[1], shape[1]);
    float covered = max(in_shaft, in_head);
    if (covered <= 0.0) discard;

    // The line of sight, from a point beside the arrow.
    vec3 d = ray_direction(pixel);
    vec2 off = (pixel - anchor) * pixel_length(base.w);
    vec3 o = base.xyz + off.x * right.xyz + off.y * down.xyz;
    vec4 shaft = frustum(o, d, body[0]);
    vec4 head = frustum(o, d, body[1]);
    vec3 to_eye = -normalize(d);
    // The nearer part lies on top: the shaft when the arrow points away.
    bool away = dot(axis, d) > 0.0;
    float on_top = away ? in_shaft : in_head;
    vec3 top = shaded(away ? shaft.xyz : head.xyz, to_eye);
    vec3 under = shaded(away ? head.xyz : shaft.xyz, to_eye);
    float beneath = max(covered - on_top, 0.0);
    vec3 shade = (top * on_top + under * beneath) / covered;
    float t = on_top > 0.5 * covered ? (away ? shaft.w : head.w) : (away ? head.w : shaft.w);
    float depth = base.w + t;

    float weight = style.y;
    if (style.z > 0.5) {
        vec2 seen = visibility(pixel, point_at(pixel, depth), depth, -1, -1);
        weight = style.y > 0.5 ? seen.x : (1.0 - seen.x) * max(style.x, 1.0 - seen.y);
    }
    fragment = vec4(shade, 1.0) * (covered * colour.a * weight);
}
