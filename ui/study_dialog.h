// The page of studies: the question, and what is known of its candidates, as pictures, a table, and one of
// them in a view of its own. It shows and asks; its controller (study_controller.h) runs the study.
#pragma once

#include "ui/study_figures.h"
#include "ui/study_runner.h"

#include <QDialog>

#include <optional>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTextBrowser;

namespace facetmill::ui {

class ElidedLabel;
class StudyChart;
class StudyForm;
class StudyFrontChart;
class StudyParallelChart;
class StudyPlaceForm;
class StudySight;
class StudyStageChart;
class StudyTable;

class StudyDialog : public QDialog {
    Q_OBJECT
public:
    explicit StudyDialog(QWidget* parent = nullptr);
    ~StudyDialog() override;

    StudyForm* form() { return form_; }
    StudyPlaceForm* place() { return place_; }
    StudyTable* table() { return table_; }
    StudySight* sight() { return sight_; }
    StudyFrontChart* front() { return front_; }
    StudyStageChart* stages() { return stages_; }
    StudyParallelChart* parallel() { return parallel_; }
    QTabWidget* pages() { return pages_; }
    QTabWidget* pictures() { return pictures_; }
    QPushButton* start_button() { return start_; }
    QPushButton* stop_button() { return stop_; }
    QPushButton* adopt_button() { return adopt_; }
    /// The picture that is seen.
    StudyChart* picture() const;

    /// What a study is about, above all; empty: a new one.
    void show_title(const QString& title, const QString& folder);
    /// Null: there is none yet. `look` is what `figures` were made of.
    void show_study(const StudyLookPtr& look, const StudyFiguresPtr& figures);
    /// The question of a study from a file, in words, in place of the form; empty: the form.
    void show_question(const QString& html);
    void show_status(const QString& words, bool alarm);
    QString status() const;
    struct Can {
        bool start = false, stop = false, adopt = false, save = false, renew = false;
        QString start_text; ///< "Start", "Resume"
    };
    void show_can(const Can& can);
    /// Below 0: nothing runs.
    void show_progress(double share);
    std::optional<std::size_t> chosen() const { return chosen_; }
    void choose(std::optional<std::size_t> candidate);
    QSize sizeHint() const override { return {1040, 720}; }
    QSize minimumSizeHint() const override { return {640, 440}; }

signals:
    void start_wanted();
    void stop_wanted();
    void open_wanted();
    void new_wanted();
    void adopt_wanted(std::size_t candidate);
    void table_wanted();
    void picture_wanted();
    void candidate_chosen();

private:
    QWidget* build_question();
    QWidget* build_candidates();
    QWidget* build_pictures();
    void build_buttons();
    void take_ranges();

    StudyFiguresPtr figures_;
    std::optional<std::size_t> chosen_;
    ElidedLabel* title_ = nullptr;
    QTabWidget *pages_ = nullptr, *pictures_ = nullptr;
    QStackedWidget* question_ = nullptr;
    QTextBrowser* asked_ = nullptr;
    StudyForm* form_ = nullptr;
    StudyPlaceForm* place_ = nullptr;
    StudyFrontChart* front_ = nullptr;
    StudyStageChart* stages_ = nullptr;
    StudyParallelChart* parallel_ = nullptr;
    StudyTable* table_ = nullptr;
    StudySight* sight_ = nullptr;
    QLabel* status_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QComboBox *x_ = nullptr, *y_ = nullptr;
    QPushButton *start_ = nullptr, *stop_ = nullptr, *open_ = nullptr, *new_ = nullptr, *adopt_ = nullptr,
                *table_file_ = nullptr, *picture_file_ = nullptr;
};

} // namespace facetmill::ui
