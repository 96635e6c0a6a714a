// "Settings of Rework Region" of a global-local operation (Wang 3.4): limits and directions that decide the
// regions, the regions as they would be, and what other limits and tools would take. It shows and asks; its
// controller (region_controller.h) finds the regions and keeps what is asked.
#pragma once

#include "core/strategy/global_local/tool_advice.h"
#include "ui/parameter_editor.h"

#include <QDialog>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QTableWidget;
class QTabWidget;
class QToolButton;

namespace facetmill::ui {

class ParameterForm;
class PlotView;

class RegionDialog : public QDialog {
    Q_OBJECT
public:
    enum Column { name_column, area_column, grow_column, tool_column, reason_column };

    explicit RegionDialog(QWidget* parent = nullptr);
    ~RegionDialog() override;

    /// An operation with rework regions. `tools`: for the rework tool.
    void show_settings(const Operation& operation, LengthUnit unit, const std::vector<FormChoice>& tools);
    void show_regions(const std::vector<ReworkRegion>& regions, const QString& status);
    /// Instead of regions, with the reason.
    void show_no_regions(const QString& why);
    /// Something was changed by hand, and can be taken back.
    void set_edited(bool edited);
    /// What cannot be, under the field that it is about (`key`) where there is one; empty: all is well.
    void show_problem(const std::string& key, const QString& message);
    /// `diameter`: of the operation's tool; `lead_limit` where the cursor stands.
    void show_advice(const ToolAdvice& advice, double diameter, double lead_limit);
    void clear_advice(const QString& why);
    void set_busy(bool busy, double fraction = 0, const QString& label = {});

    std::optional<std::size_t> chosen() const;
    void choose(std::optional<std::size_t> region);

    ParameterForm* form() { return form_; }
    QTableWidget* table() { return table_; }
    PlotView* plot() { return plot_; }
    QTabWidget* tabs() { return tabs_; }
    QComboBox* quantity_box() { return quantity_; }
    QComboBox* axis_box() { return axis_; }
    QPushButton* use_suggested() { return use_; }
    QString problem() const;
    QString status() const;
    QString advice_text() const;
    /// Lead limit of the least time with the operation's own tool.
    std::optional<double> suggested() const;
    QSize sizeHint() const override { return {470, 640}; }
    QSize minimumSizeHint() const override { return {360, 380}; }

signals:
    /// A value of the form while it is typed, and that the user is through with it.
    void edited(const std::string& key, const facetmill::ParameterValue& value);
    void finished_editing();
    /// The chart's cursor was put on a lead limit, radians.
    void lead_wanted(double lead_limit);
    void lead_chosen(double lead_limit);
    void region_switched(std::size_t region, bool on);
    /// Its boundary is to lie this far outside the offset, mm.
    void region_grown(std::size_t region, double grow);
    void region_chosen(std::optional<std::size_t> region);
    void edits_dropped();
    void closed();

protected:
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* make_region_page();
    QWidget* make_advice_page();
    void cell_edited(int row, int column);
    void step_grow(int direction);
    void update_buttons();
    void fill_chart();
    void show_cursor();
    void color();
    bool over_lead() const;
    QString estimate_text(const StrategyEstimate& e) const;

    ParameterForm* form_ = nullptr;
    QScrollArea* scroll_ = nullptr; ///< around the form
    QTabWidget* tabs_ = nullptr;
    QStackedWidget* stack_ = nullptr; ///< the table, or why it is empty
    QTableWidget* table_ = nullptr;
    QLabel *none_ = nullptr, *problem_ = nullptr, *status_ = nullptr, *readout_ = nullptr,
           *suggestion_ = nullptr;
    QToolButton *grow_ = nullptr, *shrink_ = nullptr;
    QPushButton *drop_ = nullptr, *use_ = nullptr;
    PlotView* plot_ = nullptr;
    QComboBox *quantity_ = nullptr, *axis_ = nullptr;
    QProgressBar* progress_ = nullptr;
    LengthUnit unit_ = LengthUnit::mm;
    std::vector<FormChoice> tools_;
    std::string marked_; ///< field that carries the problem
    QString marked_with_;
    QString told_;              ///< the status while nothing runs
    std::vector<double> grown_; ///< growth of each row, mm
    double step_ = 1;           ///< growing goes by this, mm
    std::optional<ToolAdvice> advice_;
    double diameter_ = 0, lead_limit_ = 0;
    bool filling_ = false, built_ = false;
};

} // namespace facetmill::ui
