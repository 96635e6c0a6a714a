// Texts of a window that have not the room they need: words that are cut at a widget's edge.
#pragma once

#include <QStringList>

class QWidget;

namespace facetmill::test {

/// One line for each label, button, check box, tab, title or head of a table that is shown cut: what it is,
/// what it says, and what room it has and needs, in pixels. Names that end in dots on purpose (ElidedLabel,
/// combo boxes) are not meant, nor is what lies outside of a scroll area's view.
QStringList cut_texts(const QWidget& window);

} // namespace facetmill::test
