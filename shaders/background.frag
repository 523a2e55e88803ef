in vec3 colour;
uniform float alpha;
out vec4 fragment;

void main() { fragment = vec4(colour * alpha, alpha); }
