// Debian's VTK finds its OpenGL functions through a GLEW that was built for GLX. These three functions answer
// it in the X server's place, from OSMesa. They stand in the executable, where the loader looks first. They
// would break a real X window, so only programs that never open one link this file.
#include <GL/osmesa.h>

#include <cstring>

namespace {
// GLEW only asks whether there is a display, never what is in it.
void* current_display() {
    static int display = 0;
    return &display;
}
} // namespace

extern "C" {

using Function = void (*)();

__attribute__((visibility("default"))) Function glXGetProcAddressARB(const unsigned char* name) {
    const char* text = reinterpret_cast<const char*>(name);
    if (std::strcmp(text, "glXGetCurrentDisplay") == 0) return reinterpret_cast<Function>(&current_display);
    return OSMesaGetProcAddress(text);
}

__attribute__((visibility("default"))) int glXQueryVersion(void*, int* major, int* minor) {
    if (major) *major = 1;
    if (minor) *minor = 4;
    return 1;
}

__attribute__((visibility("default"))) const char* glXGetClientString(void*, int) {
    return "";
}
}
