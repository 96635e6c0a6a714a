// Below the form of a boundary that is painted or drawn: starts and ends that, chooses what paints, and
// changes all that is painted at once.
#pragma once

#include "core/base/units.h"
#include "core/setup/boundary.h"
#include "ui/facet_tool.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace facetmill::ui {

class BoundaryBox : public QWidget {
    Q_OBJECT
public:
    enum class Change { invert, clear, grow, shrink };

    explicit BoundaryBox(QWidget* parent);

    void show_kind(Boundary::Kind kind, LengthUnit unit);
    /// Painting or drawing is under way.
    void set_active(bool active);
    bool active() const;
    /// The brush begins with a size that suits the part, mm.
    void set_radius(double radius);
    PaintSettings settings() const;
    /// How far to grow and shrink, mm; 0: by one ring of facets.
    double distance() const;

signals:
    void activated(bool on);
    void settings_changed();
    void change_wanted(facetmill::ui::BoundaryBox::Change change);

private:
    void build_shapes(QVBoxLayout* column);
    void build_changes(QVBoxLayout* column);
    void update_enabled();

    Boundary::Kind kind_ = Boundary::Kind::facets;
    LengthUnit unit_ = LengthUnit::mm;
    QPushButton* start_ = nullptr;
    QWidget* painting_ = nullptr; ///< what facets alone have
    QButtonGroup* shapes_ = nullptr;
    QLabel *radius_label_ = nullptr, *angle_label_ = nullptr;
    QDoubleSpinBox *radius_ = nullptr, *angle_ = nullptr, *distance_ = nullptr;
    QCheckBox *erase_ = nullptr, *through_ = nullptr;
    QLabel* help_ = nullptr;
};

} // namespace facetmill::ui
