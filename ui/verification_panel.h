// What the verification found: the verdict, figures, a histogram with the range of the colours, and a list of
// places to fly to.
#pragma once

#include "ui/deviation_view.h"
#include "ui/verdict_advice.h"
#include "ui/verification_model.h"

#include <QScrollArea>
#include <QTimer>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace facetmill::ui {

class VerificationPanel : public QScrollArea {
    Q_OBJECT
public:
    VerificationPanel(Document& document, VerificationModel& model, QWidget* parent = nullptr);

    /// The range of the colours, as the view has it.
    void set_scale(const DeviationScale& scale);
    /// Verifying is possible now.
    void set_ready(bool on);

    /// "Verified", "Failed verification: ...".
    QString verdict_line() const;
    QString figures_text() const;
    /// What to do about the verdict; nothing is to be added where there are several setups: it is not known
    /// whether it belongs into the one that is shown.
    VerdictAdvice advice() const;
    QTreeWidget* findings() { return findings_; }
    DeviationHistogramView* histogram() { return histogram_; }
    DeviationRangeEditor* range() { return range_; }
    QSize sizeHint() const override { return {270, 420}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void verify_requested();
    /// All setups, as one job.
    void verify_all_requested();
    /// The operation that is advised about a failure.
    void add_wanted(const facetmill::ui::VerdictAdvice& advice);
    /// Its place in the model's list.
    void finding_chosen(std::size_t which);
    void range_edited(double low, double high);
    void range_reset();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void go_on();
    void show_verdict();
    void show_figures();
    QString figures_html() const;
    void fill_findings();
    void choose();

    Document& document_;
    VerificationModel& model_;
    DeviationScale scale_;
    VerdictAdvice advice_; ///< as the panel shows it
    QTimer rest_timer_;
    bool figures_shown_ = false; ///< since the last refresh
    QLabel *icon_ = nullptr, *verdict_ = nullptr, *note_ = nullptr, *figures_ = nullptr,
           *findings_title_ = nullptr, *remarks_ = nullptr;
    QPushButton *verify_ = nullptr, *verify_all_ = nullptr, *advised_ = nullptr;
    QWidget* results_ = nullptr;
    DeviationHistogramView* histogram_ = nullptr;
    DeviationRangeEditor* range_ = nullptr;
    QTreeWidget* findings_ = nullptr;
    const VerificationOutcome* listed_ = nullptr; ///< whose findings the list has
    LengthUnit listed_unit_ = LengthUnit::mm;
};

} // namespace facetmill::ui
