#include "ui/study_sight.h"

#include "core/setup/machine.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr std::size_t kept_sights = 6;
constexpr std::size_t sight_samples = 400'000; ///< points of the deviation: what a processor can still draw
constexpr int step_pause_ms = 200;             ///< while candidates are stepped through none is planned

std::shared_ptr<CandidateSight> planned_sight(const std::vector<SetupPlan>& plans, const Progress& progress) {
    auto sight = std::make_shared<CandidateSight>();
    sight->plans = plans;
    for (const SetupPlan& plan : plans) {
        SetupSight setup;
        setup.name = text(plan.project.name);
        setup.part = prepare_part_display(plan.plan->part->mesh, progress.part(0, 0.5));
        std::vector<PathSource> sources;
        for (const auto& operation : plan.plan->operations)
            sources.push_back(path_source(operation));
        setup.path = prepare_path_display(sources, progress.part(0.5, 1));
        sight->setups.push_back(std::move(setup));
    }
    return sight;
}

/// Adds what was judged.
void add_deviations(CandidateSight& sight, const SeenCandidate& seen, const Progress& progress) {
    if (!seen.result.passed) sight.why = worded(seen.result.why);
    for (const JudgedChain& chain : seen.chains) {
        const LengthUnit unit = chain.setups.front().project.unit;
        const auto display =
            prepare_deviation_display(chain.result->surface, default_scale(*chain.result, unit), progress);
        for (const SetupPlan& setup : chain.setups) {
            const auto at = std::size_t(&setup - seen.setups.data());
            const SetupFrame frame = frame_between(chain.setups.front().project, setup.project);
            sight.setups[at].deviation =
                frame.is_identity() ? display : moved_display(*display, frame.turn, frame.move);
        }
    }
}

QString fact(const QString& name, const QString& value, const QColor& quiet, const QColor& color) {
    return QStringLiteral("<tr><td style=\"color:%1; padding:1px 10px 1px 0\">%2</td>"
                          "<td style=\"padding:1px 0; color:%4\">%3</td></tr>")
        .arg(quiet.name(), name.toHtmlEscaped(), value.toHtmlEscaped(), color.name());
}

} // namespace

StudySight::StudySight(QWidget* parent) : QWidget(parent) {
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName(QStringLiteral("study_sight_tabs"));
    tabs_->setDocumentMode(true);
    tabs_->addTab(build_view(), tr("View"));
    report_ = new QTextBrowser(this);
    report_->setObjectName(QStringLiteral("study_report"));
    report_->setAccessibleName(tr("Report of the candidate"));
    report_->setFrameShape(QFrame::NoFrame);
    report_->setOpenLinks(false);
    tabs_->addTab(report_, tr("Report"));
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("study_sight_progress"));
    progress_->setAccessibleName(tr("The candidate is planned and judged"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    QSizePolicy keep = progress_->sizePolicy();
    keep.setRetainSizeWhenHidden(true); // nothing moves when it comes
    progress_->setSizePolicy(keep);
    progress_->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(tabs_, 1);
    column->addWidget(progress_);
    wait_.setSingleShot(true);
    wait_.setInterval(step_pause_ms);
    connect(&wait_, &QTimer::timeout, this, &StudySight::begin);
    connect(&job_, &BackgroundJob::progressed, this,
            [this](double fraction, const QString&) { progress_->setValue(int(1000 * fraction)); });
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (!job_.running()) progress_->hide();
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    write_report();
}

StudySight::~StudySight() = default;

QWidget* StudySight::build_view() {
    auto* page = new QWidget(this);
    viewport_ = new Viewport(page);
    viewport_->setObjectName(QStringLiteral("study_view"));
    viewport_->setAccessibleName(tr("View of the candidate"));
    viewport_->scene().set_visible(Layer::title, false);
    path_ = new QCheckBox(tr("Path"), page);
    path_->setToolTip(tr("The tool's path"));
    deviation_ = new QCheckBox(tr("Deviation"), page);
    deviation_->setToolTip(tr("What is left and what is missing, in colours"));
    for (QCheckBox* box : {path_, deviation_}) {
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, [this] { draw(false); });
    }
    setups_ = new QComboBox(page);
    setups_->setObjectName(QStringLiteral("study_setup"));
    setups_->setAccessibleName(tr("Setup"));
    setups_->setToolTip(tr("The setup that is shown"));
    setups_->hide();
    connect(setups_, &QComboBox::activated, this, [this](int i) {
        setup_ = std::size_t(i);
        draw(true);
    });
    connect(viewport_, &Viewport::drawn, this, &StudySight::settled);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(6, 2, 6, 2);
    bar->addWidget(path_);
    bar->addWidget(deviation_);
    bar->addStretch(1);
    bar->addWidget(setups_);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(viewport_, 1);
    column->addLayout(bar);
    return page;
}

bool StudySight::busy() const {
    return wait_.isActive() || job_.running() || (viewport_->isVisible() && !viewport_->finished());
}

std::string StudySight::key() const {
    return look_ && chosen_ && *chosen_ < look_->outcome.keys.size() ? look_->outcome.keys[*chosen_] : "";
}

void StudySight::set_study(StudyLookPtr look, StudyFiguresPtr figures) {
    const bool other = !look || !look_ || look->folder != look_->folder;
    look_ = std::move(look);
    figures_ = std::move(figures);
    if (other) {
        choose(std::nullopt);
        kept_.clear();
    }
    write_report();
}

void StudySight::choose(std::optional<std::size_t> candidate) {
    if (candidate == chosen_) return;
    chosen_ = candidate;
    job_.cancel();
    whole_ = false;
    const std::string wanted = key();
    for (const auto& [known, sight] : kept_)
        if (!wanted.empty() && known == wanted) {
            wait_.stop();
            return take(wanted, sight, true);
        }
    shown_ = nullptr;
    draw(false);
    write_report();
    if (wanted.empty())
        wait_.stop();
    else
        wait_.start();
}

void StudySight::begin() {
    if (!look_ || !chosen_) return;
    const std::string wanted = key();
    const auto project = look_->outcome.candidates[*chosen_].project;
    if (wanted.empty() || !project) return;
    progress_->setValue(0);
    progress_->show();
    auto sight = std::make_shared<std::shared_ptr<CandidateSight>>();
    job_.start(
        tr("Looking at the candidate"),
        [this, sight, wanted, project, folder = look_->folder](const Progress& p) {
            const auto seen = see_candidate(
                *project, folder->project(), sight_samples,
                [&](const std::vector<SetupPlan>& plans) {
                    *sight = planned_sight(plans, p.part(0.3, 0.35));
                    // The path is there before it is judged.
                    QMetaObject::invokeMethod(
                        this,
                        [this, wanted, part = std::make_shared<const CandidateSight>(**sight)] {
                            take(wanted, part, false);
                        },
                        Qt::QueuedConnection);
                },
                p.part(0, 0.95));
            if (!*sight) *sight = std::make_shared<CandidateSight>();
            add_deviations(**sight, *seen, p.part(0.95, 1));
        },
        [this, sight, wanted](const JobEnd& end) {
            if (end.done()) take(wanted, *sight, true);
        });
}

void StudySight::take(const std::string& wanted, CandidateSightPtr sight, bool whole) {
    if (whole) {
        kept_.remove_if([&](const auto& one) { return one.first == wanted; });
        kept_.emplace_front(wanted, sight);
        if (kept_.size() > kept_sights) kept_.pop_back();
    }
    if (wanted != key() || (!whole && whole_)) return;
    const bool first = !shown_;
    shown_ = std::move(sight);
    whole_ = whole;
    const QSignalBlocker quiet(setups_);
    setups_->clear();
    for (const SetupSight& setup : shown_->setups)
        setups_->addItem(setup.name);
    setups_->setVisible(shown_->setups.size() > 1);
    if (setup_ >= shown_->setups.size()) setup_ = 0;
    if (!shown_->setups.empty()) setups_->setCurrentIndex(int(setup_));
    draw(first && !std::exchange(fitted_, true));
    write_report();
}

void StudySight::draw(bool fit) {
    Scene& scene = viewport_->scene();
    const SetupSight* setup = shown_ && setup_ < shown_->setups.size() ? &shown_->setups[setup_] : nullptr;
    if (setup) {
        scene.set_unit(shown_->plans[setup_].project.unit);
        scene.part().set(setup->part);
        scene.paths().set(setup->path);
        scene.deviation().set(setup->deviation);
        if (setup->deviation) scene.deviation().set_scale(setup->deviation->scale);
    } else {
        scene.paths().set(nullptr);
        scene.deviation().set(nullptr);
    }
    scene.set_visible(Layer::cl, path_->isChecked());
    scene.set_visible(Layer::cc, false);
    scene.set_visible(Layer::deviation, deviation_->isChecked());
    scene.set_empty_text(utf8(tr("Choose a candidate in a picture or in the table")));
    viewport_->content_changed();
    if (fit && setup) viewport_->set_view(StandardView::iso);
}

void StudySight::set_palette(Palette palette) {
    viewport_->scene().set_palette(palette);
    viewport_->refresh();
}

void StudySight::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && report_) write_report();
}

void StudySight::write_report() {
    const SignalColors signal = signal_colors(palette());
    const QColor quiet = palette().color(QPalette::PlaceholderText), ink = palette().color(QPalette::Text);
    if (!figures_ || !chosen_ || *chosen_ >= figures_->rows.size()) {
        report_->setHtml(
            QStringLiteral("<p style=\"color:%1\">%2</p>")
                .arg(quiet.name(), tr("Choose a candidate in a picture or in the table.").toHtmlEscaped()));
        return;
    }
    const StudyRow& row = figures_->rows[*chosen_];
    const QString title = *chosen_ == 0 ? tr("The project as it stands") : tr("Candidate %1").arg(*chosen_);
    QString html = QStringLiteral("<p style=\"margin:0 0 4px 0; font-size:large\"><b>%1</b></p>")
                       .arg(title.toHtmlEscaped());
    const QColor color = row.standing == CandidateStanding::winner || row.standing == CandidateStanding::front
                             ? signal.good
                         : row.standing == CandidateStanding::out ? signal.bad
                                                                  : signal.quiet;
    html += QStringLiteral("<p style=\"margin:2px 0; color:%1\">%2</p>")
                .arg(color.name(), sentence(standing_label(row.standing)).toHtmlEscaped());
    if (!row.why.isEmpty()) html += QStringLiteral("<p>%1</p>").arg(sentence(row.why).toHtmlEscaped());
    html += QStringLiteral("<table cellspacing=\"0\">");
    for (std::size_t v = 0; v < row.chosen.size(); ++v)
        html += fact(figures_->variations[qsizetype(v)], figures_->choices[v][qsizetype(row.chosen[v])],
                     quiet, ink);
    for (const Measure m : all_measures()) {
        const auto value = row.measures[m];
        if (!value) continue;
        const auto most = figures_->limit(m);
        QString words = measure_text(m, *value);
        if (most) words = tr("%1, at most %2").arg(words, measure_text(m, *most));
        html +=
            fact(measure_head(m, figures_->unit), words, quiet, most && *value > *most ? signal.bad : ink);
    }
    html += QStringLiteral("</table>") + operations_html();
    report_->setHtml(kept_together(html));
}

QString StudySight::operations_html() const {
    if (!shown_) return {};
    const QColor quiet = palette().color(QPalette::PlaceholderText);
    QString html = QStringLiteral("<table cellspacing=\"0\" style=\"margin-top:8px\"><tr>");
    for (const QString& head : {tr("Operation"), tr("Tool"), tr("Machining time"), tr("Cut length")})
        html += QStringLiteral("<td style=\"color:%1; padding:1px 10px 1px 0\">%2</td>")
                    .arg(quiet.name(), head.toHtmlEscaped());
    html += QStringLiteral("</tr>");
    for (const SetupPlan& setup : shown_->plans)
        for (const auto& o : setup.plan->operations) {
            html += QStringLiteral("<tr>");
            for (const QString& cell : {elided(text(o->name), 30), tr("T%1").arg(o->program.tool_number),
                                        duration_text(o->totals.time_seconds),
                                        shown_length(o->totals.cut_length, setup.project.unit)})
                html +=
                    QStringLiteral("<td style=\"padding:1px 10px 1px 0\">%1</td>").arg(cell.toHtmlEscaped());
            html += QStringLiteral("</tr>");
        }
    html += QStringLiteral("</table>");
    if (!shown_->why.isEmpty())
        html += QStringLiteral("<p>%1</p>").arg(sentence(shown_->why).toHtmlEscaped());
    return html;
}

} // namespace facetmill::ui
