in vec4 colour;  // premultiplied
out vec4 fragment;

void main() { fragment = colour; }
