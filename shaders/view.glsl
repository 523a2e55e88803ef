// The projection of a view, from its five constants v[0…4]. Pixels are those of the whole picture,
// x right, y down, centres at half-integers.
//   0: pixel of the view axis; 1/focal length in px (orthographic: view units per px); 1 if perspective
//   1: eye; least depth that is drawn
//   2, 3, 4: unit vectors right, down and forward

// Direction of the line of sight, with unit component along the view axis.
vec3 ray_direction(vec4 v[5], vec2 pixel) {
    vec2 slope = (pixel - v[0].xy) * (v[0].z * v[0].w);
    return v[4].xyz + slope.x * v[2].xyz + slope.y * v[3].xyz;
}

// Side of a pixel at a depth, in view units.
float pixel_length(vec4 v[5], float depth) { return v[0].z * (v[0].w > 0.5 ? depth : 1.0); }

// The point at this depth on the line of sight of a pixel.
vec3 point_at(vec4 v[5], vec2 pixel, float depth) {
    vec2 across = (pixel - v[0].xy) * pixel_length(v, depth);
    return v[1].xyz + depth * v[4].xyz + across.x * v[2].xyz + across.y * v[3].xyz;
}

// xy: pixel, z: depth.
vec3 projected(vec4 v[5], vec3 point) {
    vec3 from_eye = point - v[1].xyz;
    float depth = dot(from_eye, v[4].xyz);
    vec2 across = vec2(dot(from_eye, v[2].xyz), dot(from_eye, v[3].xyz));
    return vec3(v[0].xy + across / pixel_length(v, depth), depth);
}
