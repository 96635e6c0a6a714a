// Pictures against baselines, window by window: the structural similarity (Wang et al. 2004) of the worst 8 x
// 8 window, because a mean over the picture does not see a small wrong spot.
#pragma once

#include "viz/picture.h"

#include <string>

namespace facetmill::test {

/// Pictures are the same when no window is below this.
inline constexpr double min_similarity = 0.98;

struct PictureDifference {
    double worst = 1.0; ///< similarity of the worst window and colour; 0 for pictures of different sizes
    int x = 0, y = 0;   ///< its top left corner
};

/// Every 8 x 8 window (smaller where the picture is), red, green and blue each for itself.
PictureDifference compare_pictures(const Picture& a, const Picture& b);

/// How many pixels differ between two pictures of one size.
std::size_t different_pixels(const Picture& a, const Picture& b);

/// Black where equal, brighter the more two pictures of one size differ.
Picture difference_picture(const Picture& a, const Picture& b);

/// Compares with tests/screenshot/baseline/NAME.png. Empty when they are the same; otherwise what is wrong,
/// and NAME-out.png and NAME-diff.png in `out_folder` show it. With FACETMILL_UPDATE_PICTURES=1 in the
/// environment the baseline is written instead (only where it would not pass, so that unchanged pictures keep
/// their bytes).
std::string check_picture(const Picture& picture, const std::string& name, const std::string& out_folder);

} // namespace facetmill::test
