// A disc with a grid, box-filtered over each pixel so that it melts away instead of beating.
#include "view.glsl"
uniform mat3 plane_from_pixel;  // homogeneous, of the pixel from `anchor`
uniform vec2 anchor;
uniform vec4 disc;    // radius, where fading begins (fraction), opacity, grid width in px
uniform vec4 colour;  // linear; w: 1/grid spacing
uniform vec3 grid_colour;
out vec4 fragment;

// Integral of a train of unit pulses of this width centred on the integers.
float train(float x, float width) {
    float cell = floor(x + 0.5);
    return cell * width + clamp(x - cell + 0.5 * width, 0.0, width);
}

// Share of the pixel covered by the lines x = integer; per_px: change of x over a pixel.
float lines(float x, float per_px, float width_px) {
    float footprint = max(per_px, 1e-6);
    float width = min(width_px * footprint, 1.0);
    float covered = (train(x + 0.5 * footprint, width) - train(x - 0.5 * footprint, width)) / footprint;
    // Lines closer than a few pixels would merge into a tone.
    return covered * smoothstep(3.0, 14.0, 1.0 / footprint);
}

void main() {
    vec3 h = plane_from_pixel * vec3(gl_FragCoord.xy - anchor, 1.0);
    if (h.z <= 0.0) discard;
    vec2 at = h.xy / h.z;
    // Change of the plane's coordinates with the pixel.
    vec2 per_x = (plane_from_pixel[0].xy - at * plane_from_pixel[0].z) / h.z;
    vec2 per_y = (plane_from_pixel[1].xy - at * plane_from_pixel[1].z) / h.z;
    vec2 per_px = sqrt(per_x * per_x + per_y * per_y);

    float r = length(at) / disc.x;
    float visible = disc.z * (1.0 - smoothstep(disc.y, 1.0, r));
    vec2 cell = at * colour.w;
    vec2 grid = vec2(lines(cell.x, per_px.x * colour.w, disc.w), lines(cell.y, per_px.y * colour.w, disc.w));
    float ruled = grid.x + grid.y - grid.x * grid.y;
    fragment = vec4(mix(colour.rgb, grid_colour, ruled), 1.0) * visible;
}
