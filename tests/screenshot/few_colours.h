// Pictures of windows as small files.
#pragma once

#include <QImage>

namespace facetmill::test {

/// The picture in the 256 colours that suit it best, by median cut: a third of the bytes of one of all
/// colours, and nothing that one would see in a window.
QImage in_few_colours(const QImage& picture);

} // namespace facetmill::test
