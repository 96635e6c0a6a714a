// The configuration space as a VTK scene: box with axes, the two surfaces, the free volume, markers of
// the chosen postures, legend and title. Like Scene it owns a renderer but no window, knows no widgets, runs
// on the thread that renders, and counts device pixels from the top left.
#pragma once

#include "viz/cspace_display.h"
#include "viz/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace facetmill {

struct LegendEntry;

class CSpaceScene {
public:
    CSpaceScene();
    ~CSpaceScene();
    CSpaceScene(const CSpaceScene&) = delete;
    CSpaceScene& operator=(const CSpaceScene&) = delete;

    void attach(vtkRenderWindow* window);
    void detach();
    vtkRenderer* renderer();

    void set_pixel_ratio(double ratio);
    void set_antialiasing(bool on);
    void set_palette(Palette palette);
    void set_unit(LengthUnit unit);

    /// nullptr: the empty text is shown.
    void set_content(std::shared_ptr<const CSpaceContent> content);
    const std::shared_ptr<const CSpaceContent>& content() const;
    void set_title(const std::string& title, const std::string& subtitle = {});
    void set_empty_text(const std::string& text);
    void set_legend_visible(bool on);
    /// A posture that is tried out.
    void set_probe(const std::optional<PostureValue>& posture);
    /// What the colours mean, of what there is to see.
    std::vector<LegendEntry> legend() const;
    /// A picture lower than this, in layout pixels, has no room for the names of postures beside those of the
    /// axes: the legend alone has them then.
    static constexpr double min_height_of_names = 200;

    /// Looks from the standard direction and fits.
    void reset_view();
    /// Fits the box between title and legend, keeping the direction.
    void fit();
    /// About the vertical and about the horizontal of the screen, radians.
    void turn(double about_up, double about_right);
    void zoom(double factor);

    std::optional<CSpaceDisplay::Hit> hit(double x, double y) const;
    /// The marker within `radius` pixels: a choice's number, cspace_choices for the probe.
    std::optional<std::size_t> marker_at(double x, double y, double radius) const;
    /// Needs content.
    Vec2 display_of(const PostureValue& posture) const;
    /// What stands beside axes and markers, layout pixels.
    std::vector<OverlayNote> notes() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace facetmill
