// The tool axis of an operation by two angles.
#pragma once

#include "core/base/vec.h"
#include "ui/document.h"

#include <QDialog>

class QDoubleSpinBox;
class QLabel;

namespace facetmill::ui {

/// A unit vector so rounded that an axis of the coordinates is just that.
Vec3 rounded_axis(const Vec3& direction);

/// A direction by how far it leans from upright (0 to 180) and towards where, from X about Z; in degrees.
struct AxisAngles {
    double tilt = 0, towards = 0;

    static AxisAngles of(const Vec3& axis);
    Vec3 axis() const; ///< rounded
};

class AxisDialog : public QDialog {
    Q_OBJECT
public:
    /// `operation`: its name. `axis` need not be of unit length.
    AxisDialog(const QString& operation, const Vec3& axis, QWidget* parent = nullptr);

    Vec3 axis() const;

private:
    void show_direction();

    QDoubleSpinBox *tilt_ = nullptr, *towards_ = nullptr;
    QLabel* direction_ = nullptr;
};

/// Asks for the angles of this operation's tool axis, in a dialog that stays open.
void ask_tool_axis(Document& document, std::size_t operation, QWidget* window);

} // namespace facetmill::ui
