// What is written into a configuration space: names beside the markers of postures, and the legend.
#pragma once

#include "viz/cspace_display.h"
#include "viz/overlay.h"

#include <functional>

namespace facetmill {

/// What the colours mean, of what there is to see.
std::vector<LegendEntry> cspace_legend(const CSpaceContent& content, Palette palette);

/// A posture's marker, layout pixels.
struct CSpaceMarker {
    Vec2 at;
    Rgb color;
    std::string name;
};

/// Choices that are one posture have one marker with all their names. `shown`: where a posture is in the
/// picture.
std::vector<CSpaceMarker> cspace_markers(const CSpaceContent& content,
                                         const std::function<Vec2(const PostureValue&)>& shown);

/// Spots and names, unless they are empty. A name stands beside its marker where it covers neither another
/// marker nor another name, nor a note that is there, as the numbers of the axes are; else on a line below or
/// above. `name_width`: of a text in layout pixels.
void add_markers(OverlayContent& content, std::vector<CSpaceMarker> markers,
                 const std::function<double(const std::string&)>& name_width);

/// Notes without a panel that spots or panels lie on go: half a number says something else.
void leave_out_covered(OverlayContent& content, const std::function<double(const std::string&)>& name_width);

/// Its letters and those of a note that the content has meet. Widths as above.
bool lies_on_another(const OverlayContent& content, const OverlayNote& note,
                     const std::function<double(const std::string&)>& name_width);

} // namespace facetmill
