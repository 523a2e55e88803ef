/* A libEGL with one graphics card and no software device, as on a machine without Mesa. It draws nothing. */
#include <string.h>

typedef void (*Function)(void);

static unsigned query_devices(int most, void** devices, int* n_devices) {
    if (most > 0) devices[0] = &devices;
    *n_devices = 1;
    return 1;
}
static const char* query_string(void* device, int name) {
    (void)device;
    return name == 0x3055 ? "EGL_EXT_device_drm EGL_EXT_device_drm_render_node" : "/dev/dri/card0";
}
static void* get_display(unsigned platform, void* device, const int* attributes) {
    (void)platform, (void)attributes;
    return device;
}

Function eglGetProcAddress(const char* name) {
    if (strcmp(name, "eglQueryDevicesEXT") == 0) return (Function)query_devices;
    if (strcmp(name, "eglQueryDeviceStringEXT") == 0) return (Function)query_string;
    if (strcmp(name, "eglGetPlatformDisplayEXT") == 0) return (Function)get_display;
    return 0;
}
unsigned eglInitialize(void* display, int* major, int* minor) {
    (void)display, (void)major, (void)minor;
    return 0;
}
unsigned eglMakeCurrent(void* a, void* b, void* c, void* d) {
    (void)a, (void)b, (void)c, (void)d;
    return 1;
}
unsigned eglDestroyContext(void* display, void* context) {
    (void)display, (void)context;
    return 1;
}
