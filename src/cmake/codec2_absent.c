// Stands in the bundle for libcodec2: FFmpeg's libavcodec is linked with that speech codec, whose 17 MB of tables (8 of the 80 MB packed) no
// film needs. What libavcodec calls of it, in codec2.h's signatures: none can be made, as when there is no memory for one.
#include <stddef.h>

struct CODEC2;

struct CODEC2* codec2_create(int mode) {
    (void)mode;
    return NULL;
}

// What takes a codec is never called, as there is none.
void codec2_destroy(struct CODEC2* codec) { (void)codec; }
void codec2_encode(struct CODEC2* codec, unsigned char* bytes, short* speech) { (void)codec, (void)bytes, (void)speech; }
void codec2_decode(struct CODEC2* codec, short* speech, const unsigned char* bytes) { (void)codec, (void)speech, (void)bytes; }
int codec2_samples_per_frame(struct CODEC2* codec) { return (void)codec, 0; }
int codec2_bits_per_frame(struct CODEC2* codec) { return (void)codec, 0; }
void codec2_set_natural_or_gray(struct CODEC2* codec, int gray) { (void)codec, (void)gray; }
