#include "viz/offscreen.h"

#include <GL/osmesa.h>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWeakPointer.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace facetmill {

namespace {
// Larger framebuffers than this no renderer of Mesa has.
constexpr int largest_framebuffer_side = 16384;
constexpr std::size_t largest_framebuffer = 64u << 20;
constexpr double ordinary_picture_side = 1400; // of a square of as many pixels
} // namespace

struct OffscreenWindow::Impl {
    OSMesaContext context = nullptr;
    // OSMesa insists on a buffer to draw on. VTK draws on framebuffers of its own, so a small one will do.
    std::array<std::uint8_t, 4 * 16 * 16> canvas{};
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
    std::function<void()> detach;         // the scene that is attached
    vtkWeakPointer<vtkRenderer> renderer; // the scene's; gone when the scene is
    vtkNew<vtkCallbackCommand> make_current_callback;
    int width = 0, height = 0, samples = 1;

    bool make_current() {
        return OSMesaMakeCurrent(context, canvas.data(), GL_UNSIGNED_BYTE, 16, 16) == GL_TRUE;
    }
};

OffscreenWindow::OffscreenWindow() : impl_(std::make_unique<Impl>()) {
    ::setenv("GALLIUM_DRIVER", "llvmpipe", 1); // softpipe gives other pixels
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_ACCUM_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              2,
                              0};
    impl_->context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!impl_->context || !impl_->make_current()) {
        if (impl_->context) OSMesaDestroyContext(impl_->context);
        throw Error(ErrorCode::internal, "OSMesa", "no OpenGL 3.2 context for drawing without a display",
                    "install libosmesa6 and libgl1-mesa-dri");
    }
    impl_->window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    impl_->window->SetMultiSamples(0);
    impl_->window->SetReadyForRendering(true);
    impl_->window->SetIsCurrent(true);
    impl_->window->SetOwnContext(0);
    impl_->window->SetFrameBlitModeToNoBlit();
    impl_->window->SwapBuffersOff();
    // Whoever frees what VTK keeps on the graphics card asks for the context first.
    impl_->make_current_callback->SetClientData(impl_.get());
    impl_->make_current_callback->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->make_current(); });
    impl_->window->AddObserver(vtkCommand::WindowMakeCurrentEvent, impl_->make_current_callback);
}

OffscreenWindow::~OffscreenWindow() {
    if (impl_->renderer) impl_->detach();
    impl_->make_current();
    impl_->window->Finalize();
    impl_->window = nullptr;
    OSMesaDestroyContext(impl_->context);
}

void OffscreenWindow::show(Scene& scene, int width, int height) {
    show_any(scene, width, height);
}

void OffscreenWindow::show(CSpaceScene& scene, int width, int height) {
    show_any(scene, width, height);
}

template <class AnyScene>
void OffscreenWindow::show_any(AnyScene& scene, int width, int height) {
    check_picture_size(width, height, "picture size");
    if (impl_->renderer != scene.renderer()) {
        if (impl_->renderer) impl_->detach();
        scene.attach(impl_->window);
        impl_->detach = [&scene] { scene.detach(); };
        impl_->renderer = scene.renderer();
    }
    impl_->make_current();
    impl_->width = width;
    impl_->height = height;
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    impl_->samples =
        2 * std::max(width, height) <= largest_framebuffer_side && 4 * pixels <= largest_framebuffer ? 2 : 1;
    impl_->window->SetSize(impl_->samples * width, impl_->samples * height);
    // Large pictures are for paper and large screens: text and lines grow with them.
    const double enlarged = std::max(1.0, std::sqrt(double(pixels)) / ordinary_picture_side);
    scene.set_pixel_ratio(impl_->samples * enlarged);
    scene.set_antialiasing(impl_->samples == 1);
}

Picture OffscreenWindow::render() {
    if (!impl_->detach)
        throw Error(ErrorCode::internal, "OffscreenWindow", "no scene to draw", "call show first");
    impl_->make_current();
    impl_->window->Render();
    const int s = impl_->samples, w = impl_->width * s, h = impl_->height * s;
    vtkNew<vtkUnsignedCharArray> pixels;
    impl_->window->GetPixelData(0, 0, w - 1, h - 1, 0, pixels, 0);
    const std::uint8_t* in = pixels->GetPointer(0);
    Picture picture{impl_->width, impl_->height,
                    std::vector<std::uint8_t>(3 * std::size_t(impl_->width) * std::size_t(impl_->height))};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) {
                int sum = s * s / 2; // rounds
                for (int j = 0; j < s; ++j) {
                    const std::size_t row =
                        std::size_t(h - 1 - (y * s + j)); // VTK's rows run from the bottom up
                    for (int i = 0; i < s; ++i)
                        sum += in[3 * (row * std::size_t(w) + std::size_t(x * s + i)) + std::size_t(c)];
                }
                picture.pixel(x, y)[c] = std::uint8_t(sum / (s * s));
            }
    return picture;
}

void check_picture_size(long width, long height, const std::string& where) {
    const auto good = [](long side) { return side >= 1 && side <= largest_picture_side; };
    if (!good(width) || !good(height))
        throw Error(ErrorCode::out_of_range, where,
                    std::to_string(width) + "x" + std::to_string(height) + " is outside 1 to "
                        + std::to_string(largest_picture_side) + " pixels a side",
                    "give a size like 1200x900");
    if (std::size_t(width) * std::size_t(height) > largest_picture)
        throw Error(ErrorCode::out_of_range, where,
                    std::to_string(width) + "x" + std::to_string(height) + " has more than "
                        + std::to_string(largest_picture) + " pixels",
                    "give a size like 1200x900");
}

} // namespace facetmill
