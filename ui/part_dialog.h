// Mesh files carry no unit: shows how large the part would be in each, and asks.
#pragma once

#include "core/mesh/mesh_report.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QRadioButton;

namespace facetmill::ui {

class PartDialog : public QDialog {
    Q_OBJECT
public:
    /// `suggestion` is chosen at first.
    PartDialog(const QString& file, const MeshReport& report, LengthUnit suggestion,
               QWidget* parent = nullptr);

    LengthUnit unit() const;
    /// "Do not ask again for this file."
    bool remember() const;

private:
    std::array<QRadioButton*, mesh_units.size()> choices_{}; ///< in the order of mesh_units
    QCheckBox* remember_ = nullptr;
};

} // namespace facetmill::ui
