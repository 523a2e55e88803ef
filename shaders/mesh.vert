// Triangles of a mesh, with depth.
uniform mat4 placement;   // from the mesh's axes to the view's
uniform mat3 normal_map;  // the same for normals
uniform mat4 view;        // from the view's axes to the camera's
uniform mat4 projection;  // of the layer
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
    vec4 placed = placement * vec4(position, 1.0);
    point = placed.xyz;
    normal_out = normal_map * normal;
    gl_Position = projection * (view * placed);
}
