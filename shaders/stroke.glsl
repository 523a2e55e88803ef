// Distances and dashes of strokes. Needs coverage.glsl.

// x: distance from a segment; y: position of the nearest point along it, 0…1.
vec2 from_segment(vec2 p, vec2 a, vec2 b) {
    vec2 run = b - a;
    float square = dot(run, run);
    float t = dot(p - a, run);
    if (t <= 0.0 || square < 1e-12) return vec2(length(p - a), 0.0);
    if (t >= square) return vec2(length(p - b), 1.0);
    return vec2(abs(run.x * (p.y - a.y) - run.y * (p.x - a.x)) * inversesqrt(square), t / square);
}

// Share of a pixel covered by a stroke. ends: of the segment; own: the result of from_segment. Both
// edges count, so that a line thinner than a pixel is pale but continuous.
float stroke_coverage(vec2 pixel, vec4 ends, vec2 own, float width_px) {
    float reach = 0.5 * width_px;
    // On the line itself, rounding hides the direction away from it: there it is across the segment.
    vec2 away = pixel - mix(ends.xy, ends.zw, own.y);
    if (length(away) < 0.01) away = vec2(ends.y - ends.w, ends.z - ends.x);
    float square = dot(away, away);
    away = square > 1e-12 ? away * inversesqrt(square) : vec2(1.0, 0.0);
    return edge_coverage(reach - own.x, away) + edge_coverage(reach + own.x, away) - 1.0;
}

// Converts the share t of a projected segment to a share of the segment. depths: at both ends.
float along_segment(float t, vec2 depths, bool perspective) {
    return perspective ? t * depths.x / max(mix(depths.y, depths.x, t), 1e-12) : t;
}

// Coverage of dashes that fill a share of their period, with ends one pixel soft.
float dashed(float length_along, float period, float share, float per_px) {
    float phase = abs(fract(length_along / period) - 0.5);
    float edge_px = (0.5 * share - phase) * period / max(per_px, 1e-12);
    return clamp(edge_px + 0.5, 0.0, 1.0);
}
