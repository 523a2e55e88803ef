// Triangles of a mesh, with depth.
#include "clip.glsl"
#include "view.glsl"
uniform vec4 constants[5];  // the view
uniform vec4 placement[3];  // rows of the map from the mesh's axes to the view's
uniform vec4 normal_map[3];  // the same for normals
uniform vec2 depth_map;     // depth in the buffer is x + y/depth (orthographic: x + y·depth)
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#ifdef PICTURE
layout(location = 2) in vec2 place;
out vec2 place_out;
#endif
out vec3 normal_out;
out vec3 point;

void main() {
#ifdef PICTURE
    place_out = place;
#endif
    vec4 x = vec4(position, 1.0);
    point = vec3(dot(placement[0], x), dot(placement[1], x), dot(placement[2], x));
    normal_out = vec3(dot(normal_map[0].xyz, normal), dot(normal_map[1].xyz, normal), dot(normal_map[2].xyz, normal));
    vec4 view[5] = vec4[5](constants[0], constants[1], constants[2], constants[3], constants[4]);
    vec3 from_eye = point - view[1].xyz;
    float depth = dot(from_eye, view[4].xyz);
    vec2 across = vec2(dot(from_eye, view[2].xyz), dot(from_eye, view[3].xyz));
    bool perspective = view[0].w > 0.5;
    float w = perspective ? depth : 1.0;
    vec2 pixel_w = view[0].xy * w + across / view[0].z;
    float z = perspective ? depth_map.x * depth + depth_map.y : depth_map.x + depth_map.y * depth;
    gl_Position = vec4(2.0 * pixel_w * picture.zw - w, z, w);
}
