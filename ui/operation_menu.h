// The menu of operations that can be added, each with a drawing of what it does.
#pragma once

#include <QIcon>
#include <QString>

#include <functional>
#include <string>

class QMenu;
class QWidget;

namespace facetmill::ui {

/// A kind of operation as the user's language calls it: "Finish, 3-axis".
QString operation_label(const std::string& kind);

/// What a kind of operation does, in a line; empty for a kind that nobody has described.
QString operation_words(const std::string& kind);

/// The drawing of a kind of operation where there is room for it, the sign of all operations where there is
/// not. In the colours of the palette of now.
QIcon operation_picture(const std::string& kind);

/// Entries of a menu stand beside pictures as wide as those of operations.
void show_pictures(QMenu* menu);

/// `add`: an operation of this kind is wanted.
QMenu* operation_menu(QWidget* parent, const std::function<void(const std::string&)>& add);

} // namespace facetmill::ui
