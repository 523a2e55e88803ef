// The share of a pixel that a shape covers, from the distance to the shape's edge.

// Share of a unit square on the inner side of a straight edge. distance_px: of the square's centre
// from the edge, positive inside; normal: of the edge, unit. Exact.
float edge_coverage(float distance_px, vec2 normal) {
    vec2 n = abs(normal);
    float large = max(n.x, n.y);
    float small = max(min(n.x, n.y), 1e-4);
    float t = abs(distance_px);
    float inner = 0.5 * (large - small);
    float outer = 0.5 * (large + small);
    float straight = t / large;
    float corner = max(outer - t, 0.0);
    float half_area = t < inner ? straight : 0.5 - corner * corner / (2.0 * large * small);
    return 0.5 + (distance_px < 0.0 ? -half_area : half_area);
}

// Share of a pixel covered by a line of constant width around a curve at this distance.
float line_coverage(float distance_px, float width_px) {
    return clamp(0.5 * width_px + 0.5 - abs(distance_px), 0.0, min(1.0, width_px));
}
