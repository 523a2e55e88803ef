// A stroke of constant width with round joins. Where neighbouring segments overlap, the pixel
// belongs to the nearest, so that a translucent curve has even opacity.
#include "view.glsl"
#include "coverage.glsl"
#include "quadric.glsl"
#include "occlusion.glsl"
uniform vec4 colour;  // linear; w: opacity
uniform vec4 style;   // width px, hidden opacity, hidden style (0 dimmed, 1 dashed, 2 absent), occluded?
uniform vec4 dashes;  // half period of the visible and of the hidden dashes, in lengths of the curve (0: solid);
                      // lengths a pixel; 0
uniform vec2 fade;    // where the curve is transparent and where opaque, in points
uniform int on_quadric;
uniform int on_flat;
flat in vec4 ends;
flat in vec4 neighbours;
flat in vec4 depths;
flat in vec4 along;
flat in vec2 facing;
out vec4 fragment;

// x: distance from a segment; y: how far along it the nearest point lies, 0…1.
vec2 from_segment(vec2 p, vec2 a, vec2 b) {
    vec2 run = b - a;
    float square = dot(run, run);
    float t = dot(p - a, run);
    if (t <= 0.0 || square < 1e-12) return vec2(length(p - a), 0.0);
    if (t >= square) return vec2(length(p - b), 1.0);
    return vec2(abs(run.x * (p.y - a.y) - run.y * (p.x - a.x)) * inversesqrt(square), t / square);
}

// A dash and a gap of equal length, its ends a pixel soft.
float dashed(float length_along, float half_period, float per_px) {
    float phase = abs(fract(length_along / (2.0 * half_period)) - 0.5);
    float edge_px = (0.25 - phase) * 2.0 * half_period / max(per_px, 1e-12);
    return clamp(edge_px + 0.5, 0.0, 1.0);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec2 own = from_segment(pixel, ends.xy, ends.zw);
    float reach = 0.5 * style.x;
    if (own.x > reach + 0.75) discard;
    if (from_segment(pixel, neighbours.xy, ends.xy).x <= own.x && neighbours.xy != ends.xy) discard;
    if (from_segment(pixel, ends.zw, neighbours.zw).x < own.x && neighbours.zw != ends.zw) discard;

    // Both edges of the stroke count, so that a line thinner than a pixel is pale, not broken.
    vec2 nearest = mix(ends.xy, ends.zw, own.y);
    vec2 away = own.x > 1e-4 ? (pixel - nearest) / own.x : vec2(1.0, 0.0);
    float covered = edge_coverage(reach - own.x, away) + edge_coverage(reach + own.x, away) - 1.0;

    // Perspective-correct place along the segment.
    float t = own.y;
    if (lens.w > 0.5) t = t * depths.y / max(mix(depths.z, depths.y, t), 1e-12);
    float depth = mix(depths.y, depths.z, t);
    float number = mix(along.x, along.y, t);
    float length_along = mix(along.z, along.w, t);
    float run_px = max(length(ends.zw - ends.xy), 1e-3);

    vec2 seen = vec2(1.0, 0.0);
    if (style.w > 0.5) {
        seen = visibility(pixel, point_at(pixel, depth), depth, on_quadric, on_flat);
        if (on_quadric >= 0) {
            float change = max(abs(facing.y - facing.x) / run_px, quadrics[on_quadric].mx.w);
            float front = clamp(0.5 + mix(facing.x, facing.y, t) / change, 0.0, 1.0);
            seen.y = 1.0 - (1.0 - seen.y) * (1.0 - (1.0 - front) * quadrics[on_quadric].dy.w);
            seen.x *= front;
        }
    }
    float per_px = abs(along.w - along.z) / run_px;
    float visible = dashes.x > 0.0 ? dashed(length_along, dashes.x, per_px) : 1.0;
    float hidden = max(style.y, 1.0 - seen.y);
    if (style.z > 1.5) hidden = 0.0;
    else if (dashes.y > 0.0) hidden *= dashed(length_along, dashes.y, per_px);
    float alpha = colour.a * covered * mix(hidden * (style.z < 1.5 ? visible : 1.0), visible, seen.x);
    if (fade.y > fade.x) alpha *= clamp((number - fade.x) / (fade.y - fade.x), 0.0, 1.0);
    fragment = vec4(colour.rgb, 1.0) * alpha;
}
