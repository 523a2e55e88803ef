// Families of lines on a surface. Needs coverage.glsl.

// Coverage by the lines of integer s with this spacing in pixels. Dense lines fade.
float ruled_apart(float s, float spacing_px, float width_px) {
    float distance_px = abs(s - floor(s + 0.5)) * spacing_px;
    return line_coverage(distance_px, width_px) * clamp(0.1 * spacing_px - 0.4, 0.0, 1.0);
}

// The same, given the square of the change of s per pixel.
float ruled(float s, float square, float width_px) {
    return ruled_apart(s, inversesqrt(max(square, 1e-12)), width_px);
}

// Angle of a vector; Abramowitz & Stegun 4.4.47, accurate to 1e-4 rad: a fiftieth of a pixel.
float angle_of(vec2 v) {
    vec2 a = abs(v);
    float t = min(a.x, a.y) / max(max(a.x, a.y), 1e-20);
    float s = t * t;
    float p = ((((0.0208351 * s - 0.0851330) * s + 0.1801410) * s - 0.3302995) * s + 0.9998660) * t;
    p = a.y > a.x ? 1.5707963 - p : p;
    p = v.x < 0.0 ? 3.1415927 - p : p;
    return v.y < 0.0 ? -p : p;
}
