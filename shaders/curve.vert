// One segment of a curve as a rectangle about it, four corners a segment. The points lie in a
// buffer texture that is filled once; only the range shown changes.
#include "view.glsl"
uniform samplerBuffer texture_0;  // xyz: point; w: length of the curve up to it
uniform int n_points;
uniform bool closed;
uniform vec4 range;      // first and last point shown; width px; 0
uniform mat4 placement;  // view axes from the geometry's
uniform float total_length;
uniform int on_quadric;
flat out vec4 ends;        // this segment, px: from, to
flat out vec4 neighbours;  // where the segments before and after it begin and end, px
flat out vec4 depths;      // of the four points, in order along the curve
flat out vec4 along;       // point number and length at both ends
flat out vec2 facing;      // cosine by which the surface faces the eye, at both ends

vec4 point_number(int i) {
    int wrapped = closed ? (i + n_points) % n_points : clamp(i, 0, n_points - 1);
    vec4 stored = texelFetch(texture_0, wrapped);
    float turn = closed && i >= n_points ? total_length : 0.0;
    return vec4((placement * vec4(stored.xyz, 1.0)).xyz, stored.w + turn);
}

float facing_of(vec3 point) {
    if (on_quadric < 0) return 1.0;
    vec4 x = vec4(point, 1.0);
    vec3 u = vec3(dot(quadrics[on_quadric].to_u[0], x), dot(quadrics[on_quadric].to_u[1], x),
                  dot(quadrics[on_quadric].to_u[2], x));
    u = normalize(u);
    vec4 e = quadrics[on_quadric].eye;
    return (dot(u, e.xyz) - e.w) / max(length(e.xyz - e.w * u), 1e-20);
}

// Moves `point` towards `other` until it lies before the eye.
vec4 before_eye(vec4 point, vec4 other, float depth, float other_depth) {
    if (depth >= eye.w || lens.w < 0.5) return point;
    return mix(point, other, clamp((eye.w - depth) / (other_depth - depth), 0.0, 1.0));
}

float depth_of_point(vec4 point) { return dot(point.xyz - eye.xyz, forward.xyz); }

void main() {
    int segment = gl_VertexID >> 2;
    vec4 p[4];
    for (int k = 0; k < 4; ++k) p[k] = point_number(segment + k - 1);

    // The range may begin or end within this segment.
    float from = clamp(range.x - float(segment), 0.0, 1.0);
    float to = clamp(range.y - float(segment), 0.0, 1.0);
    vec4 a = mix(p[1], p[2], from);
    vec4 b = mix(p[1], p[2], to);
    bool begins = range.x >= float(segment) || (!closed && segment == 0);
    bool ends_here = range.y <= float(segment + 1) || (!closed && segment == n_points - 2);
    // A closed curve shown whole has neither beginning nor end.
    if (closed && range.y - range.x >= float(n_points)) begins = ends_here = false;
    vec4 previous = begins ? a : p[0];
    vec4 next = ends_here ? b : p[3];

    float depth_a = depth_of_point(a);
    float depth_b = depth_of_point(b);
    bool hidden = lens.w > 0.5 && max(depth_a, depth_b) < eye.w;
    vec4 clipped_a = before_eye(a, b, depth_a, depth_b);
    vec4 clipped_b = before_eye(b, a, depth_b, depth_a);
    vec3 at_a = projected(clipped_a.xyz);
    vec3 at_b = projected(clipped_b.xyz);
    vec3 at_previous = projected(before_eye(previous, a, depth_of_point(previous), depth_a).xyz);
    vec3 at_next = projected(before_eye(next, b, depth_of_point(next), depth_b).xyz);

    ends = vec4(at_a.xy, at_b.xy);
    neighbours = vec4(at_previous.xy, at_next.xy);
    depths = vec4(at_previous.z, at_a.z, at_b.z, at_next.z);
    along = vec4(float(segment) + from, float(segment) + to, clipped_a.w, clipped_b.w);
    facing = vec2(facing_of(clipped_a.xyz), facing_of(clipped_b.xyz));

    // A rectangle that holds the segment with its round ends and soft edges.
    vec2 run = at_b.xy - at_a.xy;
    float run_length = length(run);
    vec2 direction = run_length > 1e-6 ? run / run_length : vec2(1.0, 0.0);
    float reach = 0.5 * range.z + 1.0;
    vec2 side = vec2(-direction.y, direction.x) * ((gl_VertexID & 1) == 0 ? -reach : reach);
    vec2 corner = (gl_VertexID & 2) == 0 ? at_a.xy - direction * reach : at_b.xy + direction * reach;
    gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : clip_from_pixel(corner + side);
}
