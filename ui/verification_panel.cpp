#include "ui/verification_panel.h"

#include "core/job/project_setup.h"
#include "core/job/verification.h"
#include "ui/html_label.h"
#include "ui/icons.h"
#include "ui/sorted_item.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTextDocument>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr std::size_t max_listed = 1000; // findings: more nobody goes through one by one
enum Column { kind_column, depth_column, goto_column, operation_column };
constexpr int finding_role = Qt::UserRole;

VerdictAdvice advice_of(const VerificationModel& model, const Project& project) {
    if (model.verdict() != Verdict::failed) return {};
    VerdictAdvice advice = verdict_advice(model.verification(), project);
    if (setup_count(project) > 1) advice.add.clear();
    return advice;
}

void show_advised(QPushButton& button, const QString& what) {
    button.setText(what);
    button.setVisible(!what.isEmpty());
}

} // namespace

VerificationPanel::VerificationPanel(Document& document, VerificationModel& model, QWidget* parent)
    : QScrollArea(parent), document_(document), model_(model) {
    setObjectName(QStringLiteral("verification"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);

    const auto named = [](QLabel* l, const char* name) {
        l->setObjectName(QLatin1String(name));
        l->setTextInteractionFlags(Qt::TextSelectableByMouse);
        return l;
    };
    const auto label = [&](const char* name) {
        QLabel* l = named(new QLabel(page), name);
        l->setWordWrap(true);
        l->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        return l;
    };
    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    icon_ = new QLabel(page);
    verdict_ = label("verdict");
    verdict_->setTextFormat(Qt::PlainText);
    head->addWidget(icon_, 0, Qt::AlignTop);
    head->addWidget(verdict_, 1);
    column->addLayout(head);
    note_ = label("verification_note");
    note_->setTextFormat(Qt::PlainText);
    column->addWidget(note_);
    advised_ = new QPushButton(icon(Icon::add), QString(), page);
    advised_->setObjectName(QStringLiteral("advised_button"));
    connect(advised_, &QPushButton::clicked, this, [this] { emit add_wanted(advice_); });
    column->addWidget(advised_, 0, Qt::AlignLeft);
    verify_ = new QPushButton(icon(Icon::verify), tr("Verify"), page);
    verify_->setObjectName(QStringLiteral("verify_button"));
    connect(verify_, &QPushButton::clicked, this, &VerificationPanel::verify_requested);
    verify_all_ = new QPushButton(icon(Icon::verify), tr("Verify all setups"), page);
    verify_all_->setObjectName(QStringLiteral("verify_all_button"));
    verify_all_->setToolTip(tr("Plan what is not planned yet, and judge all setups as one job (Shift+F6)"));
    connect(verify_all_, &QPushButton::clicked, this, &VerificationPanel::verify_all_requested);
    column->addWidget(verify_, 0, Qt::AlignLeft);
    column->addWidget(verify_all_, 0, Qt::AlignLeft);

    results_ = new QWidget(page);
    auto* results = new QVBoxLayout(results_);
    results->setContentsMargins(0, 0, 0, 0);
    results->setSpacing(6);
    figures_ = named(new HtmlLabel(page), "figures");
    histogram_ = new DeviationHistogramView(results_);
    range_ = new DeviationRangeEditor(results_);
    connect(range_, &DeviationRangeEditor::edited, this, &VerificationPanel::range_edited);
    connect(range_, &DeviationRangeEditor::reset, this, &VerificationPanel::range_reset);
    findings_title_ = label("findings_title");
    findings_title_->setTextFormat(Qt::PlainText);
    findings_ = new QTreeWidget(results_);
    findings_->setObjectName(QStringLiteral("findings"));
    findings_->setHeaderLabels({tr("Found"), tr("Depth"), tr("GOTO"), tr("Operation")});
    findings_->setRootIsDecorated(false);
    findings_->setUniformRowHeights(true);
    findings_->setSortingEnabled(true);
    findings_->setTextElideMode(Qt::ElideMiddle);
    findings_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    findings_->setMinimumHeight(110);
    findings_->header()->setSectionsMovable(false);
    findings_->header()->setMinimumSectionSize(36);
    findings_->header()->setStretchLastSection(true);
    connect(findings_, &QTreeWidget::itemClicked, this, &VerificationPanel::choose);
    connect(findings_, &QTreeWidget::itemActivated, this, &VerificationPanel::choose);
    remarks_ = named(new HtmlLabel(page), "remarks");
    for (QWidget* w : std::initializer_list<QWidget*>{figures_, histogram_, range_, findings_title_})
        results->addWidget(w);
    results->addWidget(findings_, 100);
    results->addWidget(remarks_);
    results->addStretch(1); // words stay together where there is nothing to list
    column->addWidget(results_, 1);
    column->addStretch(0);
    setWidget(page);

    rest_timer_.setSingleShot(true);
    rest_timer_.setInterval(0);
    connect(&rest_timer_, &QTimer::timeout, this, &VerificationPanel::go_on);
    connect(&model_, &VerificationModel::changed, this, &VerificationPanel::refresh);
    connect(&document_, &Document::changed, this, &VerificationPanel::refresh); // units
    connect(&document_, &Document::states_changed, this, &VerificationPanel::refresh);
    connect(&document_, &Document::opened, this, &VerificationPanel::refresh);
    refresh();
}

void VerificationPanel::set_ready(bool on) {
    verify_->setEnabled(on);
    verify_all_->setEnabled(on);
}

void VerificationPanel::set_scale(const DeviationScale& scale) {
    scale_ = scale;
    range_->set_scale(scale_, document_.unit());
    const JudgedSetup* setup = model_.shown_setup();
    if (setup) histogram_->show_deviation(setup->display, scale_, document_.unit());
}

QString VerificationPanel::verdict_line() const {
    return verdict_->text();
}

QString VerificationPanel::figures_text() const {
    QTextDocument plain;
    plain.setHtml(figures_->text());
    return plain.toPlainText();
}

void VerificationPanel::changeEvent(QEvent* event) {
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && findings_) refresh();
}

void VerificationPanel::refresh() {
    show_verdict();
    results_->setVisible(model_.any());
    if (!model_.any()) {
        listed_ = nullptr;
        findings_->clear();
        histogram_->show_deviation(nullptr, scale_, document_.unit());
        return;
    }
    // To lay out tables and a list takes a while each: the window answers in between.
    figures_shown_ = false;
    rest_timer_.start();
}

void VerificationPanel::go_on() {
    if (!model_.any()) return;
    if (!std::exchange(figures_shown_, true)) {
        show_figures();
        rest_timer_.start();
        return;
    }
    set_scale(scale_);
    fill_findings();
}

void VerificationPanel::show_figures() {
    figures_->setText(kept_together(figures_html()));
    QString remarks;
    for (const std::string& r : model_.verification().remarks)
        remarks += QStringLiteral("<p style=\"margin:2px 0\">%1</p>")
                       .arg(with_lengths_in(sentence(worded(r)), document_.unit()).toHtmlEscaped());
    remarks_->setText(kept_together(remarks));
    remarks_->setVisible(!remarks.isEmpty());
}

void VerificationPanel::show_verdict() {
    const SignalColors signal = signal_colors(palette());
    const Verdict verdict = model_.verdict();
    Icon which = Icon::information;
    QColor color = palette().color(QPalette::WindowText);
    QString line = verdict_text(verdict), note;
    advice_ = advice();
    switch (verdict) {
    case Verdict::none:
        note = document_.operation_count() > 0 ? tr(
                   "The path has not been verified. Verifying cuts an independent model of the stock with "
                   "it and compares what is left with the part (F6).")
                                               : tr("There is no operation to verify.");
        break;
    case Verdict::verified: {
        which = Icon::verified;
        color = signal.good;
        line = model_.subject_text().isEmpty()
                   ? tr("Verified: no gouge, no collision")
                   : tr("Verified: %1: no gouge, no collision").arg(model_.subject_text());
        const double uncut = model_.verification().uncut_share;
        if (uncut > 0) note = tr("Material is left on %1 of the area to be cut.").arg(percent_text(uncut));
        break;
    }
    case Verdict::failed:
        which = Icon::verify_failed;
        color = signal.bad;
        line = model_.subject_text().isEmpty()
                   ? tr("Failed: %1").arg(model_.failure_text())
                   : tr("Failed: %1: %2").arg(model_.subject_text(), model_.failure_text());
        note = advice_.text;
        break;
    case Verdict::not_judged:
        which = Icon::verify_stale;
        color = signal.attention;
        note = sentence(model_.failure_text());
        if (!advice_.text.isEmpty()) note += QStringLiteral(". ") + advice_.text;
        break;
    case Verdict::stale:
        which = Icon::verify_stale;
        color = signal.attention;
        line = tr("Out of date");
        note = tr("The project has changed since. What is shown here is of the plan as it was.");
        break;
    }
    const bool part_of_job = model_.any() && !model_.covers_all();
    if (part_of_job && verdict != Verdict::stale)
        note += (note.isEmpty() ? QString() : QStringLiteral(" "))
                + tr("This setup alone was judged, not the whole job.");
    icon_->setPixmap(icon(which).pixmap(20, 20));
    verdict_->setText(kept_together(line));
    QFont bold = font();
    bold.setBold(true);
    verdict_->setFont(bold);
    QPalette colored = palette();
    colored.setColor(QPalette::WindowText, color);
    verdict_->setPalette(colored);
    note_->setText(kept_together(note));
    note_->setVisible(!note.isEmpty());
    show_advised(*advised_, advised_button(advice_));
    verify_->setVisible(verdict == Verdict::none || verdict == Verdict::stale);
    verify_->setText(verdict == Verdict::stale ? tr("Verify again") : tr("Verify"));
    verify_all_->setVisible(setup_count(document_.project()) > 1
                            && (verdict == Verdict::none || verdict == Verdict::stale || part_of_job));
}

VerdictAdvice VerificationPanel::advice() const {
    return advice_of(model_, document_.project());
}

QString VerificationPanel::figures_html() const {
    const Verification& v = model_.verification();
    const LengthUnit unit = document_.unit();
    const SignalColors signal = signal_colors(palette());
    const QString quiet = signal.quiet.name();
    const auto number = [&](double mm) {
        return number_text(mm / mm_per(unit), 2).replace(QChar('-'), QChar(0x2212));
    };
    const auto row = [&](const QString& name, const QString& value, const QString& color = {}) {
        return QStringLiteral("<tr><td style=\"color:%1; padding:1px 10px 1px 0\">%2</td>"
                              "<td align=\"right\" style=\"padding:1px 0%4\">%3</td></tr>")
            .arg(quiet, name.toHtmlEscaped(), value.toHtmlEscaped(),
                 color.isEmpty() ? QString() : QStringLiteral("; color:") + color);
    };
    const auto length = [&](double mm) { return shown_length(mm, unit, 3); };
    const DeviationFigures& f = v.figures;
    QString html = QStringLiteral("<table width=\"100%\" cellspacing=\"0\">");
    const bool gouged = f.gouge_max > v.used.gouge_limit;
    html += row(tr("Deepest gouge"), length(f.gouge_max), gouged ? signal.bad.name() : QString());
    if (v.border.samples > 0)
        html += row(tr("… near open borders"), length(v.border.gouge_max),
                    v.border.gouge_max > v.used.gouge_limit ? signal.bad.name() : QString());
    html += row(tr("Excess, half below"), length(f.excess_p50));
    html += row(tr("… 95 % below"), length(f.excess_p95));
    html += row(tr("… 99 % below"), length(f.excess_p99));
    html += row(tr("… largest"), length(f.excess_max));
    if (v.used.tolerance > 0) {
        html += row(tr("Over the tolerance %1").arg(length(v.used.tolerance)), percent_text(f.over_fraction));
        html +=
            row(tr("Uncut, allowed %1").arg(percent_text(v.used.uncut_limit)), percent_text(v.uncut_share),
                v.left_uncut()      ? signal.bad.name()
                : v.uncut_share > 0 ? signal.attention.name()
                                    : QString());
        for (const UncutReason& r : v.uncut)
            html += row(tr("… %1").arg(worded(uncut_reason_text(r))),
                        tr("%1, up to %2").arg(shown_area(r.area, unit), length(r.excess_max)));
    }
    html += row(tr("Collisions"), count_text(v.collisions.size()),
                v.collisions.empty() ? QString() : signal.bad.name());
    html += row(tr("Samples", "places looked at"), count_text(f.samples));
    html += row(tr("Resolution"), length(v.used.resolution));
    html += QStringLiteral("</table>");

    QString bands;
    for (const SlopeBand& b : v.bands) {
        if (b.figures.samples == 0) continue;
        const auto cell = [&](const QString& value, const QString& color = {}) {
            return QStringLiteral(
                       "<td align=\"right\" style=\"white-space:nowrap; padding:1px 0 1px 8px%2\">%1</td>")
                .arg(value.toHtmlEscaped(), color.isEmpty() ? QString() : QStringLiteral("; color:") + color);
        };
        bands += QStringLiteral("<tr><td style=\"white-space:nowrap; color:%1; padding:1px 0\">%2–%3°</td>")
                     .arg(quiet, QString::number(std::lround(degrees(b.from))),
                          QString::number(std::lround(degrees(b.to))));
        bands += cell(number(b.figures.gouge_max),
                      b.figures.gouge_max > v.used.gouge_limit ? signal.bad.name() : QString());
        bands += cell(number(b.figures.excess_p95)) + cell(number(b.figures.excess_max))
                 + cell(percent_text(b.figures.uncut_fraction)) + QStringLiteral("</tr>");
    }
    if (!bands.isEmpty()) {
        const QString in = text(unit_name(unit));
        const auto head = [&](const QString& name) {
            return QStringLiteral("<td align=\"right\" style=\"color:%1; padding:1px 0 1px 8px\">%2</td>")
                .arg(quiet, name.toHtmlEscaped());
        };
        html += QStringLiteral("<table width=\"100%\" cellspacing=\"0\" style=\"margin-top:8px\"><tr>"
                               "<td style=\"color:%1; padding:1px 0\">%2</td>")
                    .arg(quiet, tr("Slope").toHtmlEscaped())
                + head(tr("Gouge")) + head(tr("95 %")) + head(tr("Max")) + head(tr("Uncut"))
                + QStringLiteral("</tr><tr><td></td>") + head(in) + head(in) + head(in)
                + QStringLiteral("<td></td></tr>") + bands + QStringLiteral("</table>");
    }
    return html;
}

void VerificationPanel::fill_findings() {
    const auto& all = model_.findings();
    findings_title_->setText(
        all.empty() ? tr("Nothing was found.")
        : all.size() > max_listed
            ? tr("Found %1 places; the first %2 of them:").arg(count_text(all.size()), count_text(max_listed))
            : tr("Found (click to go there):"));
    findings_->setVisible(!all.empty());
    if (listed_ == &model_.outcome() && listed_unit_ == document_.unit()) return;
    listed_ = &model_.outcome();
    listed_unit_ = document_.unit();
    findings_->setSortingEnabled(false);
    findings_->clear();
    const std::size_t n = std::min(all.size(), max_listed);
    for (std::size_t i = 0; i < n; ++i) {
        const Finding& f = all[i];
        auto* item = new SortedItem;
        item->setText(kind_column, finding_text(f.kind));
        item->setData(kind_column, finding_role, qulonglong(i));
        item->setData(kind_column, SortedItem::sort_role, double(i)); // the order of their weight
        item->setIcon(kind_column, icon(f.kind == Finding::Kind::excess ? Icon::information : Icon::error));
        item->setText(depth_column, number_text(f.depth / mm_per(listed_unit_), 3));
        item->setData(depth_column, SortedItem::sort_role, f.depth);
        item->setTextAlignment(depth_column, Qt::AlignRight | Qt::AlignVCenter);
        item->setTextAlignment(goto_column, Qt::AlignRight | Qt::AlignVCenter);
        const QString where = f.by.known() ? model_.program_name(f.by.program) : tr("not reached by any");
        item->setText(goto_column, f.by.known() ? count_text(f.by.motion + 1) : QStringLiteral("–"));
        item->setData(goto_column, SortedItem::sort_role, f.by.known() ? double(f.by.motion + 1) : 0.0);
        item->setText(operation_column, where);
        QString tip = QStringLiteral("%1 %2, %3")
                          .arg(finding_text(f.kind), shown_length(f.depth, listed_unit_, 4), where);
        if (f.by.known()) tip += tr(", GOTO %1").arg(f.by.motion + 1);
        if (f.with_part) tip += tr(", into the part");
        if (!f.fixture.isEmpty()) tip += tr(", into the fixture '%1'").arg(f.fixture);
        for (int c = kind_column; c <= operation_column; ++c)
            item->setToolTip(c, tip);
        findings_->addTopLevelItem(item);
    }
    findings_->headerItem()->setText(depth_column, tr("Depth, %1").arg(text(unit_name(listed_unit_))));
    findings_->setColumnHidden(operation_column, model_.outcome().programs.size() < 2);
    findings_->setSortingEnabled(true);
    findings_->sortByColumn(kind_column, Qt::AscendingOrder);
    for (const int c : {kind_column, depth_column, goto_column})
        findings_->resizeColumnToContents(c);
    findings_->header()->setMinimumSectionSize(60);
}

void VerificationPanel::choose() {
    const QTreeWidgetItem* item = findings_->currentItem();
    if (!item || !model_.any()) return;
    const auto i = std::size_t(item->data(kind_column, finding_role).toULongLong());
    if (i < model_.findings().size()) emit finding_chosen(i);
}

} // namespace facetmill::ui
