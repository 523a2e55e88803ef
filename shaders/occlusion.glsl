// Visibility behind the solids of the view. Needs view.glsl and quadric.glsl. The solids' constants
// begin at SOLIDS: those of N_QUADRICS ellipsoids, then of N_FLATS planes (three each), then two of
// the layer of meshes if there is one (N_MESHES is 1). Planes:
//   0: normal; offset, so that the signed height of X is xyz·X + w
//   1: centre; radius   2: opacity, where fading begins (share of the radius), side of the eye (±1)
// Meshes:
//   0: corner of the layer px; its size px   1: the depth buffer holds x + y/depth (orthographic:
//      x + y·depth); opacity
#if N_MESHES > 0
#ifdef GL_ES  // four pictures beside and below each other, one for each sample
uniform sampler2D texture_1;
float depth_sample(ivec2 texel, int k) {
    return texelFetch(texture_1, texel + ivec2(k & 1, k >> 1) * (textureSize(texture_1, 0) / 2), 0).r;
}
#else
uniform sampler2DMS texture_1;  // depth of the meshes, four samples per pixel
float depth_sample(ivec2 texel, int k) { return texelFetch(texture_1, texel, k).r; }
#endif
#endif

// A step from 1 (in front) to 0 (behind), one pixel wide. ahead: depth difference, positive in
// front.
float in_front(float ahead, float pixel) {
    float slope = length(vec2(dFdx(ahead), dFdy(ahead)));
    return clamp(0.5 + ahead / clamp(slope, 0.25 * pixel, 8.0 * pixel), 0.0, 1.0);
}

// The strength of hiding by an ellipsoid of this opacity: as the ellipsoid fades out, it gradually
// stops hiding, so that finally the picture is as if it were absent.
float hold(float opacity) { return clamp(4.0 * opacity, 0.0, 1.0); }

// x: visible share of the point; y: opacity of the objects that hide the rest; z: visible share if
// there were no planes; w: what the planes transmit. Ignores solids to which the point belongs (by
// number; -1: none).
vec4 visibility(vec4 v[5], vec2 pixel, float depth, float own_quadric, float own_flat) {
    float clear = 1.0;
    float transmitted = 1.0;
    float before_bodies = 1.0;
    float through_planes = 1.0;
    float unit = pixel_length(v, depth);
    for (int i = 0; i < N_QUADRICS; ++i) {
        int at = SOLIDS + i * quadric_size;
        Sight s = sight_of(at, pixel);
        float front = depth_of(at, sphere_point(s, -1.0));
        // Objects on the front surface itself are not hidden by it.
        float hidden = outline_coverage(at, s) * (1.0 - in_front(front - depth + 0.75 * unit, unit));
        if (own_quadric == float(i)) hidden = 0.0;
        clear *= 1.0 - hidden * hold(constant(at + 2).w);
        before_bodies *= 1.0 - hidden * hold(constant(at + 2).w);
        transmitted *= 1.0 - hidden * constant(at + 2).w;
    }
    for (int i = 0; i < N_FLATS; ++i) {
        int at = SOLIDS + N_QUADRICS * quadric_size + 3 * i;
        vec3 point = point_at(v, pixel, depth);
        float height = dot(constant(at).xyz, point) + constant(at).w;
        // The intersection of the line of sight with the plane.
        vec3 towards = ray_direction(v, pixel);
        float descent = dot(constant(at).xyz, towards);
        vec3 crossing = point - (height / (abs(descent) < 1e-6 ? 1e-6 : descent)) * towards;
        float r = length(crossing - constant(at + 1).xyz) / constant(at + 1).w;
        float opacity = constant(at + 2).x * (1.0 - smoothstep(constant(at + 2).y, 1.0, r));
        float behind = 1.0 - in_front(height * constant(at + 2).z + 0.75 * unit, unit);
        float hidden = own_flat == float(i) ? 0.0 : behind * opacity;
        clear *= 1.0 - hidden;
        transmitted *= 1.0 - hidden;
        through_planes *= 1.0 - hidden;
    }
#if N_MESHES > 0
    int at_mesh = SOLIDS + N_QUADRICS * quadric_size + 3 * N_FLATS;
    ivec2 texel = ivec2(pixel - constant(at_mesh).xy);
    bool within = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(constant(at_mesh).zw)));
    vec2 scale = constant(at_mesh + 1).xy;
    float covered = 0.0;
    for (int k = 0; k < 4; ++k) {
        float stored = depth_sample(within ? texel : ivec2(0), k);
        float offset = stored - scale.x;
        float front = v[0].w > 0.5 ? scale.y / (abs(offset) < 1e-12 ? 1e-12 : offset) : offset / scale.y;
        // The buffer is cleared to 1: no mesh at this pixel.
        float ahead = clamp(0.5 + (front - depth + 0.75 * unit) / unit, 0.0, 1.0);
        covered += stored < 1.0 ? 0.25 * (1.0 - ahead) : 0.0;
    }
    covered = within ? covered : 0.0;
    clear *= 1.0 - covered;
    before_bodies *= 1.0 - covered;
    transmitted *= 1.0 - covered * constant(at_mesh + 1).z;
#endif
    return vec4(clear, 1.0 - transmitted, before_bodies, through_planes);
}

// Where hidden lines are dashed or omitted, planes are glass: what lies behind them is paler, but
// not hidden. As seen_through_planes in src/picture/vector/occluders.cpp.
float through_glass(float through_planes) {
    return through_planes + (1.0 - through_planes) * max(0.75, through_planes);
}

// Weight of a point in a layer (0: hidden, 1: visible), given its visible share and the covered
// share of the pixel: the two layers, one over the other, give the full coverage.
float layer_weight(float layer, vec4 seen, float hidden_opacity, float covered) {
    if (hidden_opacity < 0.0)  // omitted where hidden
        return layer > 0.5 ? seen.z * through_glass(seen.w) : 0.0;
    if (layer > 0.5) return seen.x;
    return (1.0 - seen.x) * max(hidden_opacity, 1.0 - seen.y) / max(1.0 - covered * seen.x, 1e-3);
}
