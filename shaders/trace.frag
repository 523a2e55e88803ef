// Segments of a curve that lasts, as they are kept from picture to picture: the depth of the point
// and, on an ellipsoid, the share in which it faces the eye. Where segments meet, the fuller coverage
// counts, which the depth buffer keeps as (1 - coverage)/2; the first drawn of equal ones.
#include "constants.glsl"
#include "coverage.glsl"
#include "stroke.glsl"
//   0…4: the view   5: corner of the layer px; width of the stroke px; least step of facing
//   6: period of the dashes in lengths of the curve (0: solid), share of it that is drawn; how far
//      from a segment something is kept px
flat in vec4 ends;
flat in vec4 neighbours;
flat in vec4 along;
flat in vec4 depths;
out vec2 kept;

void main() {
    Trace trace = trace_of(gl_FragCoord.xy + constant(5).xy, ends, depths.xy, depths.zw, along.zw,
                           constant(0).w > 0.5, constant(5).z, constant(6).xy, constant(5).w);
    kept = vec2(trace.depth, trace.front);
    gl_FragDepth = trace.away_px > constant(6).z ? 1.0 : 0.5 - 0.5 * trace.covered;
}
