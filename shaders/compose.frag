// What moves over what stands still, in linear light, then encoded to sRGB.
uniform sampler2D texture_0;  // what moves, premultiplied
uniform sampler2D texture_1;  // what stands still, premultiplied
out vec4 fragment;

// The sRGB curve as a polynomial in the fourth root; within 0.009 of an 8-bit level.
vec3 encoded(vec3 x) {
    vec3 s = sqrt(x);
    vec3 q = sqrt(s);
    vec3 upper = ((0.0813555 * q - 0.3355649) * q + 1.1227386) * s + 0.1961140 * q - 0.0646085;
    return mix(upper, 12.92 * x, lessThan(x, vec3(0.0031308)));
}

// Ordered dither: the 8×8 Bayer matrix, -0.5…0.5 exclusive.
float dither(ivec2 p) {
    int x = p.x ^ p.y;
    int m = ((x & 1) << 5) | ((p.y & 1) << 4) | ((x & 2) << 2) | ((p.y & 2) << 1) | ((x & 4) >> 1) |
            ((p.y & 4) >> 2);
    return (float(m) - 31.5) / 64.0;
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 moving = texelFetch(texture_0, p, 0);
    vec4 still_part = texelFetch(texture_1, p, 0);
    vec4 mixed = moving + (1.0 - moving.a) * still_part;
#ifdef TRANSPARENT
    mixed.rgb /= max(mixed.a, 1e-5);
#else
    mixed.a = 1.0;
#endif
    // Slightly less than a level, so that colours that are exact levels stay flat.
    vec3 level = encoded(clamp(mixed.rgb, 0.0, 1.0)) * 255.0 + 0.85 * dither(p);
    fragment = vec4(floor(level + 0.5) / 255.0, mixed.a);
}
