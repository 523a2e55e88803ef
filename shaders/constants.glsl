// Constants of one draw call. llvmpipe reads a uniform lane by lane, with about thirty instructions
// per component, but a flat varying with one. So the first N_FLAT values are passed to the fragment
// shader as flat varyings, and only the remaining ones as uniforms.
// In OpenGL ES all are uniforms, and N_FLAT is N_CONSTANTS: WebGL has too few varyings.
#ifdef GL_ES
uniform vec4 constants[N_FLAT];
vec4 constant(int i) { return constants[i]; }
#else
flat in vec4 flat_constants[N_FLAT];
#if N_CONSTANTS > N_FLAT
uniform vec4 more_constants[N_CONSTANTS - N_FLAT];
vec4 constant(int i) {
    return i < N_FLAT ? flat_constants[min(i, N_FLAT - 1)] : more_constants[max(i - N_FLAT, 0)];
}
#else
vec4 constant(int i) { return flat_constants[i]; }
#endif
#endif
