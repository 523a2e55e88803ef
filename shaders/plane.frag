// A disc with a grid, box-filtered over each pixel so that dense lines fade without moiré.
#include "constants.glsl"
//   0, 1, 2: columns of the homogeneous map from the pixel (relative to an anchor) to the plane;
//            w: anchor x, anchor y, 1/grid spacing
//   3: radius, where fading begins (share of the radius), opacity, grid width in px
//   4: colour, linear   5: the grid's colour, linear
out vec4 fragment;

// Integral of a train of unit pulses of this width, centred on the integers.
vec2 train(vec2 x, vec2 width) {
    vec2 cell = floor(x + 0.5);
    return cell * width + clamp(x - cell + 0.5 * width, vec2(0.0), width);
}

// Share of the pixel covered by the lines at integers; per_px: change of x per pixel.
vec2 lines(vec2 x, vec2 per_px, float width_px) {
    vec2 footprint = max(per_px, 1e-6);
    vec2 width = min(width_px * footprint, 1.0);
    vec2 spacing_px = 1.0 / footprint;
    vec2 half_step = 0.5 * footprint;
    vec2 covered = (train(x + half_step, width) - train(x - half_step, width)) * spacing_px;
    // Lines closer than a few pixels would merge into a uniform tone.
    return covered * smoothstep(3.0, 14.0, spacing_px);
}

void main() {
    vec2 p = gl_FragCoord.xy - vec2(constant(0).w, constant(1).w);
    vec3 h = constant(2).xyz + p.x * constant(0).xyz + p.y * constant(1).xyz;
    float depth = 1.0 / (h.z > 0.0 ? h.z : 1.0);
    vec2 at = h.xy * depth;
    // Derivatives of the plane's coordinates with respect to the pixel.
    vec2 per_x = (constant(0).xy - at * constant(0).z) * depth;
    vec2 per_y = (constant(1).xy - at * constant(1).z) * depth;
    vec2 per_px = sqrt(per_x * per_x + per_y * per_y);

    float r = length(at) / constant(3).x;
    float visible = constant(3).z * (1.0 - smoothstep(constant(3).y, 1.0, r));
    float per_unit = constant(2).w;
    vec2 grid = lines(at * per_unit, per_px * per_unit, constant(3).w);
    float ruled = grid.x + grid.y - grid.x * grid.y;
    vec3 colour = mix(constant(4).rgb, constant(5).rgb, ruled);
    fragment = h.z > 0.0 ? vec4(colour, 1.0) * visible : vec4(0.0);
}
