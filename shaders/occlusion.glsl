// What the solids of the view hide. Needs view.glsl and quadric.glsl; the solids' constants begin
// at SOLIDS: those of N_QUADRICS ellipsoids, then of N_FLATS planes, three each:
//   0: normal; offset, so that the signed height of X is xyz·X + w
//   1: centre; radius   2: opacity, where fading begins (share of the radius), side of the eye (±1)

// A step from 1 (in front) to 0 (behind) as wide as a pixel. ahead: how far in front, in depth.
float in_front(float ahead, float pixel) {
    float slope = length(vec2(dFdx(ahead), dFdy(ahead)));
    return clamp(0.5 + ahead / clamp(slope, 0.25 * pixel, 8.0 * pixel), 0.0, 1.0);
}

// x: share of the point that nothing hides; y: opacity of what hides the rest. Solids that the
// point belongs to (by number; -1: none) are left out.
vec2 visibility(vec4 v[5], vec2 pixel, float depth, float own_quadric, float own_flat) {
    float clear = 1.0;
    float transmitted = 1.0;
    float unit = pixel_length(v, depth);
    for (int i = 0; i < N_QUADRICS; ++i) {
        int at = SOLIDS + i * quadric_size;
        Sight s = sight_of(at, pixel);
        float front = depth_of(at, sphere_point(s, -1.0));
        // Things that lie on the front surface itself are not hidden by it.
        float hidden = outline_coverage(at, s) * (1.0 - in_front(front - depth + 0.75 * unit, unit));
        if (own_quadric == float(i)) hidden = 0.0;
        clear *= 1.0 - hidden;
        transmitted *= 1.0 - hidden * constant(at + 2).w;
    }
    for (int i = 0; i < N_FLATS; ++i) {
        int at = SOLIDS + N_QUADRICS * quadric_size + 3 * i;
        vec3 point = point_at(v, pixel, depth);
        float height = dot(constant(at).xyz, point) + constant(at).w;
        // Where the line of sight crosses the plane.
        vec3 towards = ray_direction(v, pixel);
        float descent = dot(constant(at).xyz, towards);
        vec3 crossing = point - (height / (abs(descent) < 1e-6 ? 1e-6 : descent)) * towards;
        float r = length(crossing - constant(at + 1).xyz) / constant(at + 1).w;
        float opacity = constant(at + 2).x * (1.0 - smoothstep(constant(at + 2).y, 1.0, r));
        float behind = 1.0 - in_front(height * constant(at + 2).z + 0.75 * unit, unit);
        float hidden = own_flat == float(i) ? 0.0 : behind * opacity;
        clear *= 1.0 - hidden;
        transmitted *= 1.0 - hidden;
    }
    return vec2(clear, 1.0 - transmitted);
}

// Weight of a point in a layer of things (0: hidden, 1: visible), given how much of it is seen.
float layer_weight(float layer, vec2 seen, float hidden_opacity) {
    return layer > 0.5 ? seen.x : (1.0 - seen.x) * max(hidden_opacity, 1.0 - seen.y);
}
