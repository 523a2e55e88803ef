uniform vec4 picture;  // width, height and their inverses, px

vec4 clip_from_pixel(vec2 pixel) { return vec4(2.0 * pixel * picture.zw - 1.0, 0.0, 1.0); }
