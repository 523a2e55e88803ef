// Rays and ellipsoids. Needs view.glsl and coverage.glsl.

// The line of sight of one pixel in the axes of one ellipsoid.
struct Sight {
    vec3 d;
    vec3 m;
    float square;        // |d|²
    float discriminant;  // |d|² - |m|²: positive where the line meets the ellipsoid
    float root;          // its square root, not below a tiny part of |d|
    vec3 nearest;        // point of the line nearest to the centre
};

Sight sight_of(int i, vec2 pixel) {
    vec2 p = pixel - vec2(quadrics[i].d0.w, quadrics[i].dx.w);
    Sight s;
    s.d = quadrics[i].d0.xyz + p.x * quadrics[i].dx.xyz + p.y * quadrics[i].dy.xyz;
    s.m = quadrics[i].m0.xyz + p.x * quadrics[i].mx.xyz + p.y * quadrics[i].my.xyz;
    s.square = max(dot(s.d, s.d), 1e-30);
    s.discriminant = s.square - dot(s.m, s.m);
    s.root = sqrt(max(s.discriminant, 1e-7 * s.square));
    s.nearest = cross(s.d, s.m) / s.square;
    return s;
}

// Share of the pixel inside the outline.
float outline_coverage(int i, Sight s) {
    vec2 gradient = 2.0 * vec2(dot(s.d, quadrics[i].dx.xyz) - dot(s.m, quadrics[i].mx.xyz),
                               dot(s.d, quadrics[i].dy.xyz) - dot(s.m, quadrics[i].my.xyz));
    if (quadrics[i].narrow.z > 0.5) {
        // Both edges may lie within one pixel: the discriminant is a parabola across the outline.
        vec2 across = quadrics[i].narrow.xy;
        float slope = dot(gradient, across);
        float bend = quadrics[i].m0.w;
        float inside = slope * slope - 2.0 * bend * s.discriminant;
        float reach = sqrt(max(inside, 0.0)) / -bend;
        float middle = slope / -bend;
        float covered = min(middle + reach, 0.5) - max(middle - reach, -0.5);
        float along = dot(gradient, vec2(-across.y, across.x));
        float ridge = s.discriminant - slope * slope / (2.0 * bend);
        float end = clamp(0.5 + ridge / max(abs(along), 1e-30), 0.0, 1.0);
        return inside > 0.0 ? max(covered, 0.0) * end : 0.0;
    }
    float steepness = max(length(gradient), 1e-30);
    return edge_coverage(clamp(s.discriminant / steepness, -2.0, 2.0), gradient / steepness);
}

// Where the line enters (side -1) or leaves (side +1) the unit sphere.
vec3 sphere_point(Sight s, float side) {
    return normalize(s.nearest + (side * s.root / s.square) * s.d);
}

float depth_of(int i, vec3 u) { return quadrics[i].depth.w + dot(quadrics[i].depth.xyz, u); }
