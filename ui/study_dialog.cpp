#include "ui/study_dialog.h"

#include "ui/elided_label.h"
#include "ui/flow_layout.h"
#include "ui/study_chart.h"
#include "ui/study_form.h"
#include "ui/study_place.h"
#include "ui/study_sight.h"
#include "ui/study_table.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace facetmill::ui {

StudyDialog::StudyDialog(QWidget* parent) : QDialog(parent, Qt::Window) {
    setObjectName(QStringLiteral("study_dialog"));
    setWindowTitle(tr("Study"));
    setSizeGripEnabled(true);
    title_ = new ElidedLabel(this);
    title_->setObjectName(QStringLiteral("study_title"));
    // Made in the order in which Tab goes on.
    pages_ = new QTabWidget(this);
    pages_->setObjectName(QStringLiteral("study_pages"));
    pages_->addTab(build_question(), tr("Question"));
    pages_->addTab(build_candidates(), tr("Candidates"));
    status_ = new QLabel(this);
    status_->setObjectName(QStringLiteral("study_status"));
    status_->setWordWrap(true);
    status_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("study_progress"));
    progress_->setAccessibleName(tr("How far the study is"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    QSizePolicy keep = progress_->sizePolicy();
    keep.setRetainSizeWhenHidden(true); // nothing moves when it comes
    progress_->setSizePolicy(keep);
    progress_->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 8);
    column->setSpacing(4);
    column->addWidget(title_);
    column->addWidget(pages_, 1);
    column->addWidget(status_);
    column->addWidget(progress_);
    build_buttons();
    show_title({}, {});
}

StudyDialog::~StudyDialog() = default;

/// A new study's form or the words of one that is there, and where either is worked on.
QWidget* StudyDialog::build_question() {
    auto* page = new QWidget(this);
    form_ = new StudyForm(this);
    asked_ = new QTextBrowser(this);
    asked_->setObjectName(QStringLiteral("study_asked"));
    asked_->setAccessibleName(tr("What the study asks"));
    asked_->setFrameShape(QFrame::NoFrame);
    question_ = new QStackedWidget(page);
    question_->addWidget(form_);
    question_->addWidget(asked_);
    place_ = new StudyPlaceForm(page);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(question_, 1);
    column->addWidget(place_);
    return page;
}

QWidget* StudyDialog::build_pictures() {
    pictures_ = new QTabWidget(this);
    pictures_->setObjectName(QStringLiteral("study_pictures"));
    pictures_->setDocumentMode(true);
    front_ = new StudyFrontChart(this);
    auto* page = new QWidget(this);
    y_ = new QComboBox(page);
    x_ = new QComboBox(page);
    stages_ = new StudyStageChart(this);
    parallel_ = new StudyParallelChart(this);
    x_->setAccessibleName(tr("To the right"));
    x_->setToolTip(tr("What is drawn to the right"));
    y_->setAccessibleName(tr("Upward"));
    y_->setToolTip(tr("What is drawn upward"));
    for (const Measure m : all_measures())
        for (QComboBox* box : {x_, y_})
            box->addItem(measure_label(m), int(m));
    x_->setCurrentIndex(x_->findData(int(Measure::machining_time)));
    y_->setCurrentIndex(y_->findData(int(Measure::excess_max)));
    for (QComboBox* box : {x_, y_}) {
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(box, &QComboBox::activated, this, [this] {
            front_->set_axes(Measure(x_->currentData().toInt()), Measure(y_->currentData().toInt()));
        });
    }
    auto* axes = new QHBoxLayout;
    axes->setContentsMargins(4, 2, 4, 2);
    axes->setSpacing(6); // the column's own is none
    axes->addWidget(y_, 1);
    axes->addWidget(new QLabel(tr("against"), page));
    axes->addWidget(x_, 1);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(front_, 1);
    column->addLayout(axes);
    pictures_->addTab(page, tr("Front"));
    pictures_->addTab(stages_, tr("Stages"));
    pictures_->addTab(parallel_, tr("Parallel"));
    pictures_->setTabToolTip(0, tr("Two measures against each other; the line joins the best"));
    pictures_->setTabToolTip(1, tr("What came of each candidate, planned, judged coarsely and finely"));
    pictures_->setTabToolTip(2,
                             tr("Everything that varies beside what comes of it; drag along an axis to keep "
                                "a range, click it to let go"));
    return pictures_;
}

QWidget* StudyDialog::build_candidates() {
    auto* above = new QSplitter(Qt::Horizontal, this);
    above->setChildrenCollapsible(false);
    above->addWidget(build_pictures());
    sight_ = new StudySight(this);
    above->addWidget(sight_);
    above->setStretchFactor(0, 1);
    above->setStretchFactor(1, 1);
    above->setSizes({500, 500});
    table_ = new StudyTable(this);
    auto* all = new QSplitter(Qt::Vertical, this);
    all->setChildrenCollapsible(false);
    all->addWidget(above);
    all->addWidget(table_);
    all->setStretchFactor(0, 5);
    all->setStretchFactor(1, 2);
    const auto take = [this](std::size_t candidate) { choose(candidate); };
    for (StudyChart* chart : std::initializer_list<StudyChart*>{front_, stages_, parallel_})
        connect(chart, &StudyChart::candidate_chosen, this, take);
    connect(table_, &StudyTable::candidate_chosen, this, take);
    connect(parallel_, &StudyParallelChart::ranges_changed, this, &StudyDialog::take_ranges);
    return all;
}

void StudyDialog::build_buttons() {
    auto* row = new QWidget(this);
    auto* flow = new FlowLayout(row, 6);
    flow->setContentsMargins(0, 0, 0, 0);
    const auto button = [&](const QString& words, const char* name, const QString& tip,
                            void (StudyDialog::*signal)()) {
        auto* b = new QPushButton(words, row);
        b->setObjectName(QLatin1String(name));
        b->setToolTip(tip);
        b->setAutoDefault(false);
        flow->addWidget(b);
        connect(b, &QPushButton::clicked, this, signal);
        return b;
    };
    start_ = button(tr("&Start"), "study_start", tr("Plan and verify the candidates in the background"),
                    &StudyDialog::start_wanted);
    stop_ = button(tr("S&top"), "study_stop",
                   tr("End the run at once; what was found is kept, and Resume goes on"),
                   &StudyDialog::stop_wanted);
    adopt_ = new QPushButton(tr("&Adopt"), row);
    adopt_->setObjectName(QStringLiteral("study_adopt"));
    adopt_->setToolTip(tr("Put the chosen candidate into the project, as one step that Undo takes back"));
    adopt_->setAutoDefault(false);
    flow->addWidget(adopt_);
    connect(adopt_, &QPushButton::clicked, this, [this] {
        if (chosen_) emit adopt_wanted(*chosen_);
    });
    open_ = button(tr("&Open study…"), "study_open", tr("Open a study's file, or the folder of one"),
                   &StudyDialog::open_wanted);
    new_ = button(tr("&New study"), "study_new", tr("Ask anew, from the project as it is now"),
                  &StudyDialog::new_wanted);
    table_file_ = button(tr("Export ta&ble…"), "study_table_file", tr("All candidates as a table (CSV)"),
                         &StudyDialog::table_wanted);
    picture_file_ = button(tr("Export p&icture…"), "study_picture_file",
                           tr("The picture that is seen, as PNG"), &StudyDialog::picture_wanted);
    layout()->addWidget(row);
}

StudyChart* StudyDialog::picture() const {
    switch (pictures_->currentIndex()) {
    case 0:
        return front_;
    case 1:
        return stages_;
    default:
        return parallel_;
    }
}

void StudyDialog::show_title(const QString& title, const QString& folder) {
    title_->set_text(title.isEmpty() ? tr("A new study of this project") : title);
    title_->setToolTip(folder);
}

void StudyDialog::show_study(const StudyLookPtr& look, const StudyFiguresPtr& figures) {
    figures_ = figures;
    for (StudyChart* chart : std::initializer_list<StudyChart*>{front_, stages_, parallel_})
        chart->show_figures(figures);
    table_->show_figures(figures);
    take_ranges();
    if (!figures || (chosen_ && *chosen_ >= figures->rows.size())) choose(std::nullopt);
    sight_->set_study(look, figures);
}

void StudyDialog::take_ranges() {
    const std::vector<char> kept = parallel_->kept_by_ranges();
    for (StudyChart* chart : std::initializer_list<StudyChart*>{front_, stages_, parallel_})
        chart->set_kept(kept);
    table_->set_kept(kept);
    table_->choose(chosen_);
}

void StudyDialog::choose(std::optional<std::size_t> candidate) {
    chosen_ = candidate;
    for (StudyChart* chart : std::initializer_list<StudyChart*>{front_, stages_, parallel_})
        chart->choose(candidate);
    table_->choose(candidate);
    sight_->choose(candidate);
    emit candidate_chosen();
}

void StudyDialog::show_question(const QString& html) {
    asked_->setHtml(kept_together(html));
    question_->setCurrentIndex(html.isEmpty() ? 0 : 1);
}

void StudyDialog::show_status(const QString& words, bool alarm) {
    status_->setText(kept_together(words));
    QPalette colors = palette();
    if (alarm) colors.setColor(QPalette::WindowText, signal_colors(palette()).bad);
    status_->setPalette(colors);
}

QString StudyDialog::status() const {
    return status_->text();
}

void StudyDialog::show_can(const Can& can) {
    start_->setEnabled(can.start);
    start_->setText(can.start_text);
    stop_->setEnabled(can.stop);
    adopt_->setEnabled(can.adopt);
    table_file_->setEnabled(can.save);
    picture_file_->setEnabled(can.save);
    new_->setEnabled(can.renew);
    open_->setEnabled(!can.stop);
}

void StudyDialog::show_progress(double share) {
    progress_->setVisible(share >= 0);
    progress_->setValue(int(1000 * share));
}

} // namespace facetmill::ui
