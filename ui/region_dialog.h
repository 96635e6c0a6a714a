// "Settings of Rework Region" of a global-local operation (Wang 3.4): limits and directions that decide the
// regions, the regions as they would be, and what other limits and tools would take. It shows and asks; its
// controller (region_controller.h) finds the regions and keeps what is asked.
#pragma once

#include "ui/advice_page.h"
#include "ui/parameter_editor.h"
#include "ui/region_page.h"

#include <QDialog>

#include <optional>
#include <vector>

class QLabel;
class QProgressBar;
class QScrollArea;
class QTabWidget;

namespace facetmill::ui {

class ParameterForm;

class RegionDialog : public QDialog {
    Q_OBJECT
public:
    explicit RegionDialog(QWidget* parent = nullptr);
    ~RegionDialog() override;

    /// An operation with rework regions. `tools`: for the rework tool.
    void show_settings(const Operation& operation, LengthUnit unit, const std::vector<FormChoice>& tools);
    void show_regions(const std::vector<ReworkRegion>& regions, const QString& status);
    /// Instead of regions, with the reason.
    void show_no_regions(const QString& why);
    /// Something was changed by hand, and can be taken back.
    void set_edited(bool edited) { regions_->set_edited(edited); }
    /// What cannot be, under the field that it is about (`key`) where there is one; empty: all is well.
    void show_problem(const std::string& key, const QString& message);
    /// `diameter`: of the operation's tool; `lead_limit` where the cursor stands.
    void show_advice(const ToolAdvice& advice, double diameter, double lead_limit) {
        advice_->show_advice(advice, diameter, lead_limit);
    }
    void clear_advice(const QString& why) { advice_->clear_advice(why); }
    void set_busy(bool busy, double fraction = 0, const QString& label = {});

    std::optional<std::size_t> chosen() const { return regions_->chosen(); }
    void choose(std::optional<std::size_t> region) { regions_->choose(region); }

    ParameterForm* form() { return form_; }
    QTabWidget* tabs() { return tabs_; }
    RegionPage& regions() { return *regions_; }
    AdvicePage& advice() { return *advice_; }
    QString problem() const;
    QString status() const;
    QSize sizeHint() const override { return {470, 640}; }
    QSize minimumSizeHint() const override { return {360, 380}; }

signals:
    /// A value of the form while it is typed, and that the user is through with it.
    void edited(const std::string& key, const facetmill::ParameterValue& value);
    void finished_editing();
    // Those of the pages.
    void lead_wanted(double lead_limit);
    void lead_chosen(double lead_limit);
    void region_switched(std::size_t region, bool on);
    void region_grown(std::size_t region, double grow);
    void region_chosen(std::optional<std::size_t> region);
    void edits_dropped();
    void closed();

protected:
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void color();

    ParameterForm* form_ = nullptr;
    QScrollArea* scroll_ = nullptr; ///< around the form
    QTabWidget* tabs_ = nullptr;
    RegionPage* regions_ = nullptr;
    AdvicePage* advice_ = nullptr;
    QLabel *problem_ = nullptr, *status_ = nullptr;
    QProgressBar* progress_ = nullptr;
    std::vector<FormChoice> tools_;
    std::string marked_; ///< field that carries the problem
    QString marked_with_;
    QString told_; ///< the status while nothing runs
    bool built_ = false;
};

} // namespace facetmill::ui
