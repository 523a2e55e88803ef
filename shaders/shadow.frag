flat in vec4 tint;
in float darkness;
out vec4 fragment;

void main() { fragment = tint * darkness; }
