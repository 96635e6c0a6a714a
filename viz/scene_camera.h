// Where the eye of a scene stands: standard views, fitting, zooming, and between pixels and places.
// Projection is parallel at first, so that one scale holds everywhere; in perspective the scale is that of
// the plane through the focal point, which turning and moving keep at its distance.
#pragma once

#include "core/base/vec.h"

#include <vtkWeakPointer.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

class vtkCamera;
class vtkRenderer;
class vtkRenderWindow;

namespace facetmill {

struct LayoutRect;
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

/// A line of sight through a place, away from the eye.
struct SightLine {
    Vec3 at = Vec3::Zero(), direction = -Vec3::UnitZ();
    double back = infinity; ///< so far behind `at` the eye is; infinitely in parallel projection
    /// Where to look for what is seen first of things that end `reach` before `at`.
    Vec3 start(double reach) const { return at - std::min(reach, back) * direction; }
};

/// Between places and pixels as the view is at one moment; for any thread.
class Projection {
public:
    /// Device pixel of a place; far off the window for one behind the eye.
    Vec2 pixel(const Vec3& place) const;
    /// mm a device pixel at a place.
    double pixel_size(const Vec3& place) const;
    /// How far a place lies behind the focal point's plane as one looks; negative before it.
    double depth(const Vec3& place) const { return -axes_.row(2).dot(place - focal_); }
    SightLine sight_to(const Vec3& place) const;
    /// Through a device pixel, where it meets the focal point's plane.
    SightLine sight_at(double x, double y) const;

private:
    friend class SceneCamera;
    Vec3 focal_ = Vec3::Zero();
    Mat3 axes_ = Mat3::Identity(); ///< right, up, towards the eye
    Vec2 middle_ = Vec2::Zero();   ///< of the window, pixels
    double mm_ = 0;                ///< a pixel in the focal point's plane; 0 without a window
    double eye_ = infinity;        ///< distance from the focal point
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

    /// In perspective as through a lens of 30° from the lower to the upper edge. What the focal point's plane
    /// shows stays.
    void set_perspective(bool on);
    bool perspective() const;

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
    /// A rectangle in layout pixels, y down, lies over the shadow of a box; in perspective about.
    bool shadow_meets(const Box3& box, const LayoutRect& rect, double ratio) const;
    /// Zoom by a factor (> 1: nearer) that keeps the point of the focal point's plane under the pixel in
    /// place.
    void zoom_at(double x, double y, double factor);
    /// The focal point goes along the line of sight to the depth of a place: what is moved or zoomed keeps
    /// pace with the pointer there. The picture stays. In perspective only; not for a place behind the eye.
    void focus_at(const Vec3& place);
    /// Brings a world point to the middle of the window, where the camera turns about it.
    void center_on(const Vec3& point);

    /// Device pixels of the window; {0, 0} when there is none.
    Eigen::Vector2i window_size() const;
    /// Axes of the camera: right, up, towards the eye; unit.
    Mat3 frame() const;
    Vec3 toward_eye() const;
    Projection projection() const;
    /// mm per device pixel, in the focal point's plane; 0 without a window.
    double pixel_size() const;
    /// The same at a place.
    double pixel_size(const Vec3& place) const { return projection().pixel_size(place); }
    /// World point in the camera's plane through the focal point under a pixel.
    Vec3 point_at(double x, double y) const;
    /// Pixel of a world point.
    Vec2 display_of(const Vec3& point) const;
    SightLine sight_at(double x, double y) const { return projection().sight_at(x, y); }
    SightLine sight_to(const Vec3& place) const { return projection().sight_to(place); }

private:
    /// Half the height of the window shows `scale` mm, from `distance` where projection is parallel.
    void place_at(const Vec3& focal, double distance, double scale);
    /// In perspective: until the shadow of a box is about as large as the parallel one in `fit` (pixels),
    /// which it is not at first, and in its middle.
    void fit_perspective(const Box3& box, const Vec2& middle, const Vec2& reach);

    vtkRenderer* renderer_; // lives as long
    double away_ = 1;       ///< the eye's distance in parallel projection, mm
    vtkWeakPointer<vtkRenderWindow> window_;
};

} // namespace facetmill
