// A candidate of a study as it would be cut: its path on the part, then what it leaves in colours, and its
// report. Planned and judged anew in the background when it is chosen, the last few are kept.
#pragma once

#include "core/study/evaluation.h"
#include "ui/background_job.h"
#include "ui/study_figures.h"
#include "viz/deviation_display.h"
#include "viz/part_display.h"
#include "viz/path_display.h"

#include <QTimer>
#include <QWidget>

#include <list>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QProgressBar;
class QTabWidget;
class QTextBrowser;

namespace facetmill::ui {

class Viewport;

/// What is drawn of one setup.
struct SetupSight {
    QString name;
    PartDisplayPtr part;
    PathDisplayPtr path;
    DeviationDisplayPtr deviation; ///< null until it is judged
};

/// What is shown of a candidate, as far as it has come.
struct CandidateSight {
    std::vector<SetupSight> setups;
    std::vector<SetupPlan> plans;
    QString why; ///< it cannot be planned or judged
};
using CandidateSightPtr = std::shared_ptr<const CandidateSight>;

class StudySight : public QWidget {
    Q_OBJECT
public:
    explicit StudySight(QWidget* parent = nullptr);
    ~StudySight() override;

    /// Another study, or the same with more known: what is shown of a candidate stays where its project is
    /// the same.
    void set_study(StudyLookPtr look, StudyFiguresPtr figures);
    void choose(std::optional<std::size_t> candidate);
    void set_palette(Palette palette);
    bool busy() const;
    /// What is shown; null: nothing yet.
    const CandidateSightPtr& shown() const { return shown_; }
    Viewport* viewport() { return viewport_; }
    QTextBrowser* report() { return report_; }
    QTabWidget* tabs() { return tabs_; }
    QSize minimumSizeHint() const override { return {220, 140}; }

signals:
    void failed(const QString& why);
    void settled();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* build_view();
    void begin();
    void take(const std::string& key, CandidateSightPtr sight, bool whole);
    void draw(bool fit);
    void write_report();
    QString operations_html() const;
    std::string key() const;

    StudyLookPtr look_;
    StudyFiguresPtr figures_;
    std::optional<std::size_t> chosen_;
    CandidateSightPtr shown_;
    bool whole_ = false;                                        ///< it was judged, or cannot be
    std::list<std::pair<std::string, CandidateSightPtr>> kept_; ///< the newest first
    std::size_t setup_ = 0;
    Viewport* viewport_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    QTextBrowser* report_ = nullptr;
    QCheckBox *path_ = nullptr, *deviation_ = nullptr;
    QComboBox* setups_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QTimer wait_;
    bool fitted_ = false;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
