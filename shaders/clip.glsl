uniform mat4 projection;  // of the picture's pixels

vec4 clip_from_pixel(vec2 pixel) { return projection * vec4(pixel, 0.0, 1.0); }
