flat in vec4 tint;
noperspective in float darkness;
out vec4 fragment;

void main() { fragment = tint * darkness; }
