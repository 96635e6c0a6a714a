// The rework regions as they would be, in the dialog of their settings: each is switched on and off, grown
// and shrunk here.
#pragma once

#include "core/base/units.h"
#include "core/strategy/global_local/global_local.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QStackedWidget;
class QTableWidget;
class QToolButton;

namespace facetmill::ui {

class RegionPage : public QWidget {
    Q_OBJECT
public:
    enum Column { name_column, area_column, grow_column, tool_column, reason_column };

    explicit RegionPage(QWidget* parent);

    /// Growing goes by a share of the offset.
    void set_lengths(LengthUnit unit, double rework_offset);
    void show_regions(const std::vector<ReworkRegion>& regions);
    /// Instead of regions, with the reason.
    void show_no_regions(const QString& why);
    /// Something was changed by hand, and can be taken back.
    void set_edited(bool edited);
    std::optional<std::size_t> chosen() const;
    void choose(std::optional<std::size_t> region);
    QTableWidget* table() { return table_; }

signals:
    void region_switched(std::size_t region, bool on);
    /// Its boundary is to lie this far outside the offset, mm.
    void region_grown(std::size_t region, double grow);
    void region_chosen(std::optional<std::size_t> region);
    void edits_dropped();
    /// An entry cannot be taken; empty: it can, now.
    void refused(const QString& why);

protected:
    void changeEvent(QEvent* event) override;

private:
    void cell_edited(int row, int column);
    void step_grow(int direction);
    void update_buttons();
    void color();

    QStackedWidget* stack_ = nullptr; ///< the table, or why it is empty
    QTableWidget* table_ = nullptr;
    QLabel* none_ = nullptr;
    QToolButton *grow_ = nullptr, *shrink_ = nullptr;
    QPushButton* drop_ = nullptr;
    LengthUnit unit_ = LengthUnit::mm;
    std::vector<double> grown_; ///< growth of each row, mm
    double step_ = 1;           ///< growing goes by this, mm
    bool filling_ = false;
};

} // namespace facetmill::ui
