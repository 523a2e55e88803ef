// The finished picture, encoded as render/encoding.h does, for a framebuffer whose first row is the
// lowest.
uniform sampler2D texture_0;   // premultiplied linear light
uniform highp usampler2D texture_1;  // 65536 levels in rows of 256, then the 64 thresholds
uniform int alpha;             // 0: opaque; 1: premultiplied; 2: not premultiplied
out vec4 fragment;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    pixel.y = textureSize(texture_0, 0).y - 1 - pixel.y;
    vec4 light = clamp(texelFetch(texture_0, pixel, 0), 0.0, 1.0);
    float opacity = alpha == 0 ? 1.0 : floor(65535.0 * light.a + 0.5) / 65535.0;
    uint threshold = texelFetch(texture_1, ivec2((pixel.x & 7) + 8 * (pixel.y & 7), 256), 0).r;
    vec3 colour;
    for (int c = 0; c < 3; ++c) {
        float part = opacity > 0.0 ? min(light[c] / opacity, 1.0) : 0.0;
        int k = int(floor(65535.0 * part + 0.5));
        uint level = texelFetch(texture_1, ivec2(k & 255, k >> 8), 0).r + threshold;
        colour[c] = float(level >> 8) / 255.0;
    }
    fragment = vec4(alpha == 1 ? opacity * colour : colour, opacity);
}
