// Lines of sight and ellipsoids. Needs constants.glsl and coverage.glsl.
//
// An ellipsoid has seven constants, in axes where it is the unit sphere about the origin. For the
// pixel p the line of sight has direction d and moment m (Plücker coordinates), both affine in p: d
// = d0 + x dx + y dy with (x, y) = p - anchor; d and m have the same scale.
//   0: d0, anchor x   1: dx, anchor y   2: dy, opacity for objects behind it
//   3: m0, and x of the direction in which the outline is narrowest   4: mx, and its y
//   5: my, and the curvature of |d|² - |m|² along it (0 if the outline is wider than 3 px)
//   6: depth along the view axis is w + xyz·u for the point u of the sphere
const int quadric_size = 7;

// The line of sight of one pixel in the axes of one ellipsoid.
struct Sight {
    vec3 d;
    vec3 m;
    float square;        // |d|²
    float per_square;    // its inverse
    float discriminant;  // |d|² - |m|²: positive where the line meets the ellipsoid
    float root;          // its square root, not below a tiny part of |d|
    vec3 nearest;        // point of the line nearest to the centre
};

Sight sight_along(vec3 d, vec3 m) {
    Sight s;
    s.d = d;
    s.m = m;
    s.square = max(dot(s.d, s.d), 1e-30);
    s.per_square = 1.0 / s.square;
    s.discriminant = s.square - dot(s.m, s.m);
    s.root = sqrt(max(s.discriminant, 1e-7 * s.square));
    s.nearest = s.per_square * cross(s.d, s.m);
    return s;
}

Sight sight_of(int at, vec2 pixel) {
    vec2 p = pixel - vec2(constant(at).w, constant(at + 1).w);
    return sight_along(constant(at).xyz + p.x * constant(at + 1).xyz + p.y * constant(at + 2).xyz,
                       constant(at + 3).xyz + p.x * constant(at + 4).xyz + p.y * constant(at + 5).xyz);
}

// Distance of the pixel from the outline, px, positive inside; normal: of the outline, unit.
float outline_distance(int at, Sight s, out vec2 normal) {
    // |d| - |m| is nearly linear across the outline, and exactly so for a sphere.
    float per_d = inversesqrt(s.square);
    float m_square = max(dot(s.m, s.m), 1e-30);
    float per_m = inversesqrt(m_square);
    vec3 d = per_d * s.d;
    vec3 m = per_m * s.m;
    vec2 gradient = vec2(dot(d, constant(at + 1).xyz) - dot(m, constant(at + 4).xyz),
                         dot(d, constant(at + 2).xyz) - dot(m, constant(at + 5).xyz));
    float steepness = inversesqrt(max(dot(gradient, gradient), 1e-36));
    normal = gradient * steepness;
    return s.discriminant / (s.square * per_d + m_square * per_m) * steepness;
}

// Share of the pixel inside the outline.
float outline_coverage(int at, Sight s) {
    float bend = constant(at + 5).w;
    if (bend < 0.0) {
        // Both edges may be inside one pixel: the discriminant is a parabola across the outline.
        vec2 gradient = 2.0 * vec2(dot(s.d, constant(at + 1).xyz) - dot(s.m, constant(at + 4).xyz),
                                   dot(s.d, constant(at + 2).xyz) - dot(s.m, constant(at + 5).xyz));
        vec2 across = vec2(constant(at + 3).w, constant(at + 4).w);
        float slope = dot(gradient, across);
        float inside = slope * slope - 2.0 * bend * s.discriminant;
        float reach = sqrt(max(inside, 0.0)) / -bend;
        float middle = slope / -bend;
        float covered = min(middle + reach, 0.5) - max(middle - reach, -0.5);
        float along = dot(gradient, vec2(-across.y, across.x));
        float ridge = s.discriminant - slope * slope / (2.0 * bend);
        float end = clamp(0.5 + ridge / max(abs(along), 1e-30), 0.0, 1.0);
        return inside > 0.0 ? max(covered, 0.0) * end : 0.0;
    }
    vec2 normal;
    float distance_px = outline_distance(at, s, normal);
    return edge_coverage(clamp(distance_px, -2.0, 2.0), normal);
}

// The point where the line enters (side -1) or leaves (side +1) the unit sphere.
vec3 sphere_point(Sight s, float side) {
    vec3 u = s.nearest + (side * s.root * s.per_square) * s.d;
    return u * inversesqrt(max(dot(u, u), 1e-30));
}

float depth_of(int at, vec3 u) { return constant(at + 6).w + dot(constant(at + 6).xyz, u); }
