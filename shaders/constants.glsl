// Values that are the same over a whole draw. llvmpipe reads a uniform lane by lane, some thirty
// instructions a component, but a flat varying in one; so the first N_FLAT values reach the
// fragment shader as flat varyings, and only what finds no room there as uniforms.
flat in vec4 flat_constants[N_FLAT];
#if N_CONSTANTS > N_FLAT
uniform vec4 more_constants[N_CONSTANTS - N_FLAT];
vec4 constant(int i) {
    return i < N_FLAT ? flat_constants[min(i, N_FLAT - 1)] : more_constants[max(i - N_FLAT, 0)];
}
#else
vec4 constant(int i) { return flat_constants[i]; }
#endif
