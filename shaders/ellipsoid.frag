// Translucent ellipsoids, ray-cast. MEMBERS of them may cross each other: every surface met by the
// line of sight is weighted by what lies before it.
#include "view.glsl"
#include "coverage.glsl"
#include "quadric.glsl"
uniform int members[MEMBERS];
uniform vec4 colours[MEMBERS];       // linear
uniform vec4 line_colours[MEMBERS];  // linear; w: width of the principal sections, px
uniform vec4 rulings[MEMBERS];       // width px, opacity, meridians, parallels
out vec4 fragment;

const float pi = 3.14159265358979;

// One surface met by the line of sight.
struct Layer {
    vec3 colour;
    float alpha;
    float depth;
    vec2 depth_change;  // with the pixel
};

float sixteenth_power(float x) {
    float x2 = x * x;
    float x4 = x2 * x2;
    float x8 = x4 * x4;
    return x8 * x8;
}

// Coverage by lines where s is an integer; change: of s over a pixel. Crowded lines fade.
float ruled(float s, float change, float width_px) {
    float spacing_px = 1.0 / max(change, 1e-9);
    float distance_px = abs(s - floor(s + 0.5)) * spacing_px;
    return line_coverage(distance_px, width_px) * smoothstep(4.0, 14.0, spacing_px);
}

// Body-fixed lines through the point u of the sphere, which changes by ux, uy with the pixel.
float body_lines(int k, vec3 u, vec3 ux, vec3 uy) {
    vec3 change = sqrt(ux * ux + uy * uy) + 1e-12;
    vec3 distance_px = abs(u) / change;
    float width = line_colours[k].w;
    vec3 sections = clamp(0.5 * width + 0.5 - distance_px, 0.0, min(1.0, width));
    float covered = max(max(sections.x, sections.y), sections.z);

    if (rulings[k].y > 0.0) {
        float rim_square = max(u.x * u.x + u.y * u.y, 1e-9);
        float rim = sqrt(rim_square);
        vec2 longitude_change = (u.x * vec2(ux.y, uy.y) - u.y * vec2(ux.x, uy.x)) / rim_square;
        float per_longitude = rulings[k].z / (2.0 * pi);
        float meridians = ruled(atan(u.y, u.x) * per_longitude,
                                length(longitude_change) * per_longitude, rulings[k].x);
        float per_latitude = (rulings[k].w + 1.0) / pi;
        float parallels = ruled((atan(u.z, rim) + 0.5 * pi) * per_latitude,
                                change.z / rim * per_latitude, rulings[k].x);
        covered = max(covered, rulings[k].y * max(rulings[k].z > 0.0 ? meridians : 0.0,
                                                  rulings[k].w > 0.0 ? parallels : 0.0));
    }
    return covered;
}

// Entry (side -1: the outer surface) or exit (side +1: the inner one) of the line of sight.
Layer surface(int k, Sight s, float side, vec3 to_eye, float covered) {
    int i = members[k];
    vec3 u = sphere_point(s, side);
    Layer layer;
    layer.depth = depth_of(i, u);

    // How the point slides over the sphere as the pixel changes.
    float stretch = mix(1.0, layer.depth, quadrics[i].eye.w);
    vec3 gx = stretch * quadrics[i].gx.xyz;
    vec3 gy = stretch * quadrics[i].gy.xyz;
    float slant = side * s.root;  // u·d
    vec3 ux = gx - s.d * (dot(u, gx) / slant);
    vec3 uy = gy - s.d * (dot(u, gy) / slant);
    layer.depth_change = vec2(dot(quadrics[i].depth.xyz, ux), dot(quadrics[i].depth.xyz, uy));

    vec3 outward = normalize(u.x * quadrics[i].to_u[0].xyz + u.y * quadrics[i].to_u[1].xyz +
                             u.z * quadrics[i].to_u[2].xyz);
    vec3 n = -side * outward;
    float facing = clamp(dot(n, to_eye), 0.0, 1.0);
    float limb = 1.0 - facing;
    limb *= limb * limb;

    // Key light wrapped a little round the edge, sky from above, weak light from the ground.
    float key = max((dot(n, light.xyz) + 0.25) / 1.25, 0.0);
    float up = 0.5 + 0.5 * dot(n, sky.xyz);
    float lit = light.w * key * key * (1.5 - 0.5 * key) + sky.w * mix(0.42, 1.0, up * up) + 0.06;
    float lines = body_lines(k, u, ux, uy);
    vec3 albedo = mix(colours[k].rgb, line_colours[k].rgb, lines);
    vec3 colour = albedo * lit;

    float opacity = quadrics[i].dy.w;
    float alpha;
    if (side < 0.0) {
        vec3 halfway = normalize(light.xyz + to_eye);
        float glint = max(dot(n, halfway), 0.0);
        float narrow_glint = sixteenth_power(glint);
        float gloss = 0.05 * narrow_glint + 0.16 * sixteenth_power(narrow_glint);
        colour += light.w * gloss * (1.0 - lines) + sky.w * 0.30 * limb * up;
        alpha = opacity + (1.0 - opacity) * 0.8 * limb;
        alpha = mix(alpha, max(alpha, 0.92), lines);
    } else {
        colour *= 0.62;
        alpha = opacity * (0.55 + 0.3 * limb);
        alpha = mix(alpha, max(alpha, 0.85), lines);
    }
    layer.colour = colour;
    layer.alpha = layer.depth > eye.w ? alpha * covered : 0.0;
    return layer;
}

// 1 if a lies before b, a pixel-wide step where they cross.
float before(Layer a, Layer b) {
    float change = length(a.depth_change - b.depth_change);
    float step_length = max(change, 0.02 * pixel_length(a.depth));
    return clamp(0.5 + (b.depth - a.depth) / step_length, 0.0, 1.0);
}

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 to_eye = -normalize(ray_direction(pixel));
#if MEMBERS == 1
    Sight s = sight_of(members[0], pixel);
    float covered = outline_coverage(members[0], s);
    Layer front = surface(0, s, -1.0, to_eye, covered);
    Layer back = surface(0, s, 1.0, to_eye, covered);
    float behind = (1.0 - front.alpha) * back.alpha;
    fragment = vec4(front.colour * front.alpha + back.colour * behind, front.alpha + behind);
#else
    Layer layers[2 * MEMBERS];
    for (int k = 0; k < MEMBERS; ++k) {
        Sight s = sight_of(members[k], pixel);
        float covered = outline_coverage(members[k], s);
        layers[2 * k] = surface(k, s, -1.0, to_eye, covered);
        layers[2 * k + 1] = surface(k, s, 1.0, to_eye, covered);
    }
    vec4 sum = vec4(0.0);
    float through = 1.0;
    for (int a = 0; a < 2 * MEMBERS; ++a) {
        float weight = layers[a].alpha;
        for (int b = 0; b < 2 * MEMBERS; ++b)
            if (b != a) weight *= 1.0 - layers[b].alpha * before(layers[b], layers[a]);
        sum += vec4(layers[a].colour, 1.0) * weight;
        through *= 1.0 - layers[a].alpha;
    }
    fragment = sum * ((1.0 - through) / max(sum.a, 1e-6));
#endif
}
