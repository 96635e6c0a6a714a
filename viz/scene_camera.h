// Where the eye of a scene stands: standard views, fitting, zooming, and between pixels and places.
// Projection is parallel.
#pragma once

#include "core/base/vec.h"

#include <vtkWeakPointer.h>

#include <string>
#include <string_view>
#include <vector>

class vtkCamera;
class vtkRenderer;
class vtkRenderWindow;

namespace facetmill {

struct OverlayLayout; // overlay.h

/// All have Z up on the screen, but top and bottom, where Y is up. `front` looks along +Y, `right` along -X.
enum class StandardView { iso, front, top, right, rear, bottom, left };

/// "iso", "front", ...: the words of the command line. `view_label` is for menus: "Isometric".
const std::vector<StandardView>& standard_views();
std::string_view view_name(StandardView view);
std::string_view view_label(StandardView view);
/// Throws Error(out_of_range) that names `where` and lists the words.
StandardView parse_view(std::string_view text, const std::string& where);

/// Where the camera looks: see `SceneCamera::look_at`.
struct CameraPlace {
    Vec3 target = Vec3::Zero(), toward_eye = Vec3::UnitZ(), up = Vec3::UnitY();
    double height = 1; ///< mm in the window
};

class SceneCamera {
public:
    explicit SceneCamera(vtkRenderer* renderer);
    ~SceneCamera();

    /// VTK's own, for interactor styles.
    vtkCamera* vtk() const;
    /// nullptr: none.
    void set_window(vtkRenderWindow* window);
    vtkRenderWindow* window() const;

    CameraPlace place() const;
    /// The target comes to the middle of the window. `toward_eye` is a unit vector, not along `up`.
    void look_at(const CameraPlace& place);
    /// From where one sees a place of the part well: the direction of now, or where the surface turns away
    /// from it another one from above; at least so near that the window is `height` high.
    CameraPlace place_to_see(const Vec3& point, const Vec3& normal, double height) const;
    /// Looks from a standard direction, at what it looked at before.
    void turn_to(StandardView view);
    /// Centres and scales to a box with a margin, clear of what lies flat in the corners, keeping the
    /// direction. `ratio`: device pixels per layout pixel.
    void fit(const Box3& box, const OverlayLayout& clear_of, double ratio);
    /// To nothing.
    void fit_empty();
    /// Zoom by a factor (> 1: nearer) that keeps the world point under the pixel in place.
    void zoom_at(double x, double y, double factor);
    /// Brings a world point to the middle of the window, where the camera turns about it.
    void center_on(const Vec3& point);

    /// Device pixels of the window; {0, 0} when there is none.
    Eigen::Vector2i window_size() const;
    /// Axes of the camera: right, up, towards the eye; unit.
    Mat3 frame() const;
    Vec3 toward_eye() const;
    /// mm per device pixel; 0 without a window.
    double pixel_size() const;
    /// World point in the camera's plane through the focal point under a pixel.
    Vec3 point_at(double x, double y) const;
    /// Pixel of a world point.
    Vec2 display_of(const Vec3& point) const;

private:
    /// Half the height of the window shows `scale` mm.
    void place_at(const Vec3& focal, double distance, double scale);

    vtkRenderer* renderer_; // lives as long
    vtkWeakPointer<vtkRenderWindow> window_;
};

} // namespace facetmill
