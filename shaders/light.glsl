// Lighting of all surfaces: the only place of these formulas and their constants. Written in the
// common subset of GLSL and C++, with `real` as the type of numbers: the shaders include this file,
// and so does src/picture/vector/light.cpp.
//   key_strength, sky_strength: of the two lights
//   to_key: cosine between the normal and the direction to the key light
//   up: 0.5 + 0.5 · cosine between the normal and the direction to the middle of the sky
//   limb: (1 - cosine between the normal and the direction to the eye)³

real light_wrapped(real key) { return key > 0.0 ? key : 0.0; }

// Ellipsoids. The key light extends a little beyond the terminator; weak light comes from the
// ground.
real ellipsoid_lit(real key_strength, real sky_strength, real to_key, real up) {
    real key = light_wrapped(0.8 * to_key + 0.2);
    return key_strength * key * key * (1.5 - 0.5 * key) + sky_strength * (0.42 + 0.58 * up * up) + 0.06;
}
// glint: square of the cosine between the normal and the direction halfway between eye and key
// light
real ellipsoid_gloss(real glint) {
    real g4 = glint * glint, g8 = g4 * g4, g16 = g8 * g8, g32 = g16 * g16;
    return 0.05 * g16 + 0.16 * g32 * g32;
}
// White light added by the outer surface; lines: 1 on its lines, which have no gloss.
real ellipsoid_white(real key_strength, real sky_strength, real gloss, real lines, real limb, real up) {
    return key_strength * gloss * (1.0 - lines) + sky_strength * 0.30 * limb * up;
}
real ellipsoid_outer_opacity(real opacity, real limb) { return opacity + (1.0 - opacity) * 0.8 * limb; }
real ellipsoid_inner_opacity(real opacity, real limb) { return opacity * (0.55 + 0.3 * limb); }
// The minimum opacity of lines on the outer and on the inner surface, and the darkening of the
// inner one.
real ellipsoid_outer_lines() { return 0.92; }
real ellipsoid_inner_lines() { return 0.85; }
real ellipsoid_inner_lit(real lit) { return 0.62 * lit; }

// Cones.
real cone_lit(real key_strength, real sky_strength, real to_key, real up) {
    return key_strength * light_wrapped(0.7 * to_key + 0.3) + sky_strength * (0.5 + 0.5 * up) + 0.10;
}
real cone_opacity(real opacity, real limb) { return opacity + (1.0 - opacity) * 0.5 * limb; }
// Generators and rim: their tone relative to the cone's colour, their opacity, and the share of the
// generators' ink that is used.
real cone_line_tone() { return 0.35; }
real cone_generator_ink() { return 0.55; }
real cone_generator_opacity() { return 0.85; }
real cone_rim_opacity() { return 0.9; }

// Arrows.
real arrow_lit(real key_strength, real sky_strength, real to_key, real up) {
    return key_strength * light_wrapped(0.77 * to_key + 0.23) + sky_strength * (0.5 + 0.5 * up) + 0.10;
}
// glint: cosine between the normal and the direction halfway between eye and key light
real arrow_white(real key_strength, real glint) {
    real g2 = glint * glint, g4 = g2 * g2, g8 = g4 * g4;
    return 0.10 * key_strength * g8 * g8 * g8;
}

// Bodies of triangles.
real mesh_lit(real key_strength, real sky_strength, real to_key, real up) {
    return key_strength * light_wrapped(0.85 * to_key + 0.15) + sky_strength * (0.40 + 0.60 * up) + 0.06;
}
real mesh_gloss(real key_strength, real glint) {
    real g2 = glint * glint, g4 = g2 * g2, g8 = g4 * g4, g16 = g8 * g8;
    return key_strength * 0.06 * g16;
}
real mesh_rim(real sky_strength, real limb, real up) { return sky_strength * 0.15 * limb * up; }
