// The list of a clean-up's strips, each to be switched on and off, with the place along the one that is
// chosen.
#pragma once

#include "core/base/units.h"
#include "core/strategy/plan/strip.h"
#include "viz/scene.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace facetmill::ui {

class ElidedLabel;

/// Which operation, its strips, and the place along the one that is chosen.
class StripPanel : public QWidget {
    Q_OBJECT
public:
    enum Column { name_column, type_column, width_column, length_column, reason_column };

    explicit StripPanel(QWidget* parent = nullptr);

    QTreeWidget* list() { return list_; }
    QComboBox* operation_box() { return operation_; }
    QCheckBox* touch_box() { return touch_; }
    QSlider* place() { return place_; }
    QLabel* readout() { return readout_; }
    ElidedLabel* note() { return note_; }
    /// What stands instead of the list; empty: the list itself.
    void set_empty_text(const QString& text);
    QString empty_text() const;
    QSize sizeHint() const override { return {300, 380}; }
    QSize minimumSizeHint() const override { return {170, 120}; }
    /// Lists the strips, with lengths in a unit.
    void fill(const std::vector<Strip>& strips, LengthUnit unit, Palette palette);
    /// Check marks and colours: whether each strip is cut, as many as were listed.
    void show_states(const std::vector<bool>& cut, Palette palette);
    /// The strip of a line of the list, and the line of a strip.
    static std::size_t strip_of(const QTreeWidgetItem& item);
    QTreeWidgetItem* item_of(std::size_t strip) const;

private:
    /// All columns but the last as wide as they need, with room for the mark of sorting where it is.
    void fit_columns();

    QComboBox* operation_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QLabel *empty_ = nullptr, *readout_ = nullptr;
    ElidedLabel* note_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QCheckBox* touch_ = nullptr;
    QSlider* place_ = nullptr;
};

} // namespace facetmill::ui
