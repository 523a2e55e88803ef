uniform vec4 tint;  // linear colour of the deepest shadow
in float darkness;
out vec4 fragment;

void main() { fragment = tint * darkness; }
