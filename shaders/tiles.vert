// Whole tiles of the picture.
uniform vec4 picture;  // width, height and their inverses
layout(location = 0) in vec2 corner;        // px

void main() { gl_Position = vec4(2.0 * min(corner, picture.xy) * picture.zw - 1.0, 0.0, 1.0); }
