// A row that turns, moves or scales the part by a typed value.
#pragma once

#include "core/base/units.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace facetmill::ui {

enum class PlaceChange { turn, move, scale };

class PlaceValueRow : public QWidget {
    Q_OBJECT
public:
    explicit PlaceValueRow(QWidget* parent = nullptr);

    /// Lengths are shown in this unit from now on.
    void set_unit(LengthUnit unit);
    /// What was done otherwise, in radians or mm.
    void show_value(PlaceChange what, int axis, double value);

signals:
    /// Radians about X, Y, Z (0, 1, 2), mm along it, or a factor.
    void wanted(facetmill::ui::PlaceChange what, int axis, double value);

private:
    PlaceChange what() const;
    int axis() const;
    void show_kind();
    void apply();

    QComboBox* kind_ = nullptr;
    QDoubleSpinBox* value_ = nullptr;
    QToolButton* apply_ = nullptr;
    LengthUnit unit_ = LengthUnit::mm;
};

} // namespace facetmill::ui
