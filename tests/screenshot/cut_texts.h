// Words that cannot be read as they stand: what any page of the window is asked.
#pragma once

#include <QStringList>
#include <QWidget>

namespace facetmill::test {

/// Texts of a window's visible widgets that need more room than they have, or lie beyond the edge of what
/// they stand in, each with its place and the pixels; empty when all can be read. Texts that shorten
/// themselves are right where a tool tip has the whole. Also widgets of one layout that lie over each other.
QStringList cut_texts(const QWidget& window);

/// Numbers in sentences of a window's visible widgets whose units may go to the next line: "2" and "%". Pages
/// of the manual are as they were written.
QStringList parted_numbers(const QWidget& window);

} // namespace facetmill::test
