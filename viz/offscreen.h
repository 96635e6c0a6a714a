// Pictures without a display: an OSMesa context (Mesa's llvmpipe on the processor, the same pixels on every
// machine with the same Mesa) behind VTK's generic window.
#pragma once

#include "viz/cspace_scene.h"
#include "viz/picture.h"
#include "viz/scene.h"

#include <memory>

namespace facetmill {

inline constexpr int largest_picture_side = 16384;        ///< pixels
inline constexpr std::size_t largest_picture = 64u << 20; ///< pixels; 16384 x 4096 or 8192 x 8192

/// One context; make it, use it and end it on one thread. Scenes may come and go.
class OffscreenWindow {
public:
    /// Throws Error(internal) when OSMesa gives no context.
    OffscreenWindow();
    ~OffscreenWindow();
    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    /// Attaches a scene in place of the one before and sets the size that views are fitted to. Throws
    /// Error(out_of_range) for a size that is not 1 .. largest_picture_side or more than largest_picture.
    void show(Scene& scene, int width, int height);
    void show(CSpaceScene& scene, int width, int height);
    /// Draws the attached scene with 2 x 2 samples a pixel (one, where the picture would be too large).
    Picture render();

private:
    template <class AnyScene>
    void show_any(AnyScene& scene, int width, int height);
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Throws Error(out_of_range) that names `where`.
void check_picture_size(long width, long height, const std::string& where);

} // namespace facetmill
