// The vertex shader's side of constants.glsl.
uniform vec4 constants[N_FLAT];
#ifdef GL_ES
void pass_constants() {}
#else
flat out vec4 flat_constants[N_FLAT];
void pass_constants() {
    for (int i = 0; i < N_FLAT; ++i) flat_constants[i] = constants[i];
}
#endif
