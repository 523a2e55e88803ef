// What the solids of the view hide. Needs quadric.glsl.

// A step from 1 (in front) to 0 (behind) as wide as a pixel. ahead: how far in front, in depth.
float in_front(float ahead, float depth) {
    float slope = length(vec2(dFdx(ahead), dFdy(ahead)));
    float step_length = clamp(slope, 0.25 * pixel_length(depth), 8.0 * pixel_length(depth));
    return clamp(0.5 + ahead / step_length, 0.0, 1.0);
}

// Opacity of a plane at a point of it.
float flat_opacity(int i, vec3 point) {
    float r = length(point - flats[i].centre.xyz) / flats[i].centre.w;
    return flats[i].look.x * (1.0 - smoothstep(flats[i].look.y, 1.0, r));
}

// x: share of the point that nothing hides; y: opacity of what hides the rest. Solids that the
// point belongs to are left out.
vec2 visibility(vec2 pixel, vec3 point, float depth, int own_quadric, int own_flat) {
    float clear = 1.0;
    float transmitted = 1.0;
    for (int i = 0; i < counts.x; ++i) {
        if (i == own_quadric) continue;
        Sight s = sight_of(i, pixel);
        float covered = outline_coverage(i, s);
        float front = depth_of(i, sphere_point(s, -1.0));
        // Things that lie on the front surface itself are not hidden by it.
        float ahead = front - depth + 0.75 * pixel_length(depth);
        float behind = covered * (1.0 - in_front(ahead, depth));
        clear *= 1.0 - behind;
        transmitted *= 1.0 - behind * quadrics[i].dy.w;
    }
    for (int i = 0; i < counts.y; ++i) {
        if (i == own_flat) continue;
        float height = dot(flats[i].normal.xyz, point) + flats[i].normal.w;
        // Where the line of sight crosses the plane.
        vec3 towards = ray_direction(pixel);
        float descent = dot(flats[i].normal.xyz, towards);
        float step_back = height / (abs(descent) < 1e-6 ? 1e-6 : descent);
        float ahead = height * flats[i].look.z + 0.75 * pixel_length(depth);
        float behind = (1.0 - in_front(ahead, depth)) * flat_opacity(i, point - step_back * towards);
        clear *= 1.0 - behind;
        transmitted *= 1.0 - behind;
    }
    return vec2(clear, 1.0 - transmitted);
}
