// One segment of a curve as a rectangle around it, with four corners per segment. The points are in
// a texture that is filled once; only the drawn range changes. For cached curves: rectangles
// given by their corners, for the cached part and one more segment.
#include "clip.glsl"
#include "view.glsl"
uniform sampler2D texture_0;  // in rows of 1024: xyz: point; w: length of the curve up to it
uniform int n_points;
uniform bool closed;
uniform vec4 stroke[8];
//   0: first and last point shown, width px, length of the whole curve
//   1, 2, 3: rows of the map from the geometry's axes to the view's
//   4, 5, 6: rows of the map to the sphere of the ellipsoid on which the curve lies
//   7: eye, or direction towards it, in the sphere's axes; 1 if perspective
uniform bool on_ellipsoid;
uniform bool in_rectangles;
//   then the texture contains the rectangles, and 0: the segment px; 1: depths at both ends, cosine by which they face the eye; 2: lengths up to them
#include "pass_constants.glsl"
flat out vec4 ends;        // this segment, px: from, to
flat out vec4 neighbours;  // beginning of the previous and end of the next segment, px
flat out vec4 along;       // point number and length at both ends
flat out vec4 depths;      // at both ends; then the cosine by which the surface faces the eye

vec4 stored_texel(int i) { return texelFetch(texture_0, ivec2(i & 1023, i >> 10), 0); }

vec4 point_number(int i) {
    int wrapped = closed ? (i + n_points) % n_points : clamp(i, 0, n_points - 1);
    vec4 stored = stored_texel(wrapped);
    float turn = closed && i >= n_points ? stroke[0].w : 0.0;
    vec4 x = vec4(stored.xyz, 1.0);
    return vec4(dot(stroke[1], x), dot(stroke[2], x), dot(stroke[3], x), stored.w + turn);
}

float facing_of(vec3 point) {
    if (!on_ellipsoid) return 1.0;
    vec4 x = vec4(point, 1.0);
    vec3 u = normalize(vec3(dot(stroke[4], x), dot(stroke[5], x), dot(stroke[6], x)));
    vec4 e = stroke[7];
    return (dot(u, e.xyz) - e.w) / max(length(e.xyz - e.w * u), 1e-20);
}

// Moves `point` towards `other` until it is in front of the eye.
vec4 before_eye(vec4 point, vec4 other, float depth, float other_depth) {
    if (depth >= constants[1].w || constants[0].w < 0.5) return point;
    return mix(point, other, clamp((constants[1].w - depth) / (other_depth - depth), 0.0, 1.0));
}

float depth_of_point(vec4 point) { return dot(point.xyz - constants[1].xyz, constants[4].xyz); }

// Unit vector from a to b, or `otherwise` if they are equal.
vec2 direction_of(vec2 a, vec2 b, vec2 otherwise) {
    vec2 run = b - a;
    float square = dot(run, run);
    return square > 1e-12 ? run * inversesqrt(square) : otherwise;
}

void main() {
    pass_constants();
    if (in_rectangles) {
        ends = stroke[0];
        neighbours = stroke[0];
        depths = stroke[1];
        along = vec4(0.0, 0.0, stroke[2].xy);
        vec4 box = stored_texel(gl_VertexID >> 2);
        gl_Position = clip_from_pixel(vec2((gl_VertexID & 1) == 0 ? box.x : box.z,
                                           (gl_VertexID & 2) == 0 ? box.y : box.w));
        return;
    }
    vec4 view[5] = vec4[5](constants[0], constants[1], constants[2], constants[3], constants[4]);
    int segment = gl_VertexID >> 2;
    vec4 p[4];
    for (int k = 0; k < 4; ++k) p[k] = point_number(segment + k - 1);

    // The range may begin or end inside this segment.
    float from = clamp(stroke[0].x - float(segment), 0.0, 1.0);
    float to = clamp(stroke[0].y - float(segment), 0.0, 1.0);
    vec4 a = mix(p[1], p[2], from);
    vec4 b = mix(p[1], p[2], to);
    bool begins = stroke[0].x >= float(segment) || (!closed && segment == 0);
    bool ends_here = stroke[0].y <= float(segment + 1) || (!closed && segment == n_points - 2);
    // A closed curve that is drawn completely has no ends.
    if (closed && stroke[0].y - stroke[0].x >= float(n_points)) begins = ends_here = false;
    vec4 previous = begins ? a : p[0];
    vec4 next = ends_here ? b : p[3];

    float depth_a = depth_of_point(a);
    float depth_b = depth_of_point(b);
    bool hidden = view[0].w > 0.5 && max(depth_a, depth_b) < view[1].w;
    vec4 clipped_a = before_eye(a, b, depth_a, depth_b);
    vec4 clipped_b = before_eye(b, a, depth_b, depth_a);
    vec3 at_a = projected(view, clipped_a.xyz);
    vec3 at_b = projected(view, clipped_b.xyz);
    vec3 at_previous = projected(view, before_eye(previous, a, depth_of_point(previous), depth_a).xyz);
    vec3 at_next = projected(view, before_eye(next, b, depth_of_point(next), depth_b).xyz);

    ends = vec4(at_a.xy, at_b.xy);
    neighbours = vec4(at_previous.xy, at_next.xy);
    along = vec4(float(segment) + from, float(segment) + to, clipped_a.w, clipped_b.w);
    depths = vec4(at_a.z, at_b.z, facing_of(clipped_a.xyz), facing_of(clipped_b.xyz));

    // A rectangle that contains the segment and its share of the joins: beyond an end it extends as
    // far as the turn opens a gap there; at a real end, by a full round cap.
    vec2 direction = direction_of(at_a.xy, at_b.xy, vec2(1.0, 0.0));
    float reach = 0.5 * stroke[0].z + 0.75;
    bool at_end = (gl_VertexID & 2) != 0;
    vec2 neighbour = at_end ? direction_of(at_b.xy, at_next.xy, -direction)
                            : direction_of(at_previous.xy, at_a.xy, -direction);
    float straight = dot(direction, neighbour);
    float turn = abs(direction.x * neighbour.y - direction.y * neighbour.x);
    float beyond = reach * (straight > 0.0 ? turn : 1.0) + 0.05;
    vec2 side = vec2(-direction.y, direction.x) * ((gl_VertexID & 1) == 0 ? -reach : reach);
    vec2 corner = at_end ? at_b.xy + direction * beyond : at_a.xy - direction * beyond;
    gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : clip_from_pixel(corner + side);
}
