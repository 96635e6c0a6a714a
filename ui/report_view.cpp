#include "ui/report_view.h"

#include "core/setup/machine.h"
#include "core/strategy/global_local/rework_plan.h"
#include "ui/scan_words.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"

#include <QEvent>
#include <QScrollBar>

namespace facetmill::ui {

namespace {

/// A table of facts, names on the left.
class Facts {
public:
    explicit Facts(const QPalette& palette)
        : quiet_(palette.color(QPalette::PlaceholderText).name()),
          line_(palette.color(QPalette::Mid).name()) {}
    Facts& add(const QString& name, const QString& value, const QString& color = {}) {
        rows_ += QStringLiteral("<tr><td style=\"color:%1; padding:1px 10px 1px 0\">%2</td>"
                                "<td style=\"padding:1px 0%4\">%3</td></tr>")
                     .arg(quiet_, name.toHtmlEscaped(), value.toHtmlEscaped(),
                          color.isEmpty() ? QString() : QStringLiteral("; color:") + color);
        return *this;
    }
    QString html() const {
        return QStringLiteral("<table width=\"100%\" cellspacing=\"0\">%1</table>").arg(rows_);
    }

private:
    QString quiet_, line_, rows_;
};

/// What a part that turns needs of its stock, and what no place of the cutter serves. `part`: empty where it
/// is another one than was planned for, whose length does not belong to these figures.
void add_turning(Facts& facts, const TurnedPath& turned, const Box3& part, LengthUnit unit,
                 const QString& attention) {
    const auto number = [&](double mm) { return number_text(mm / mm_per(unit), 4); };
    if (part.empty()) {
        facts.add(QObject::tr("Smallest stock"),
                  QStringLiteral("Ø %1").arg(shown_length(2 * turned.part_radius, unit, 4)));
    } else {
        // From the part's box: exact for an axis along X, Y or Z.
        const double length = part.size().dot(turned.axis.direction.cwiseAbs());
        facts.add(
            QObject::tr("Smallest stock"),
            QStringLiteral("Ø %1 × %2").arg(number(2 * turned.part_radius), shown_length(length, unit, 4)));
    }
    facts.add(QObject::tr("Stock turns in"),
              QStringLiteral("Ø %1").arg(shown_length(2 * turned.stock_radius, unit, 4)));
    double area = 0;
    for (const UnreachedRegion& r : turned.unreached)
        area += r.area;
    if (area > 0)
        facts.add(QObject::tr("Out of reach"),
                  QObject::tr("%1 % of the surface")
                      .arg(number_text(std::max(100 * area / turned.surface_area, 0.01), 2)),
                  attention);
}

QString heading(const QString& title) {
    return QStringLiteral("<p style=\"margin:0 0 4px 0; font-size:large\"><b>%1</b></p>")
        .arg(title.toHtmlEscaped());
}

QString note(const QString& text, const QColor& color) {
    return QStringLiteral("<p style=\"margin:6px 0 2px 0; color:%1\">%2</p>")
        .arg(color.name(), text.toHtmlEscaped());
}

} // namespace

ReportView::ReportView(Document& document, QWidget* parent) : QTextBrowser(parent), document_(document) {
    setObjectName(QStringLiteral("report"));
    setAccessibleName(tr("Report"));
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    this->document()->setDocumentMargin(8);
    connect(&document_, &Document::opened, this, &ReportView::refresh);
    connect(&document_, &Document::changed, this, &ReportView::refresh);
    connect(&document_, &Document::part_changed, this, &ReportView::refresh);
    connect(&document_, &Document::states_changed, this, &ReportView::refresh);
    refresh();
}

void ReportView::show_node(const std::optional<TreeNode>& node) {
    if (node == node_) return;
    node_ = node;
    refresh();
}

void ReportView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refresh();
}

void ReportView::refresh() {
    QString html;
    if (!document_.has_part()) {
        html = note(tr("Open a mesh or a project, and this panel tells what it holds."),
                    palette().color(QPalette::PlaceholderText));
    } else if (document_.program()) {
        html = program_html(*document_.program());
        if (node_ && node_->kind == TreeNode::Kind::part) html += part_html();
    } else if (node_
               && (node_->kind == TreeNode::Kind::operation || node_->kind == TreeNode::Kind::stock_after)
               && node_->index < document_.operation_count()) {
        html = operation_html(node_->index);
    } else if (node_
               && (node_->kind == TreeNode::Kind::operations || node_->kind == TreeNode::Kind::machine
                   || node_->kind == TreeNode::Kind::tools || node_->kind == TreeNode::Kind::tool)) {
        html = operations_html();
    } else {
        html = part_html();
    }
    html = kept_together(html);
    // Most of what it is told of changes nothing here, and laying it out is dear.
    if (html == shown_) return;
    shown_ = html;
    const int scrolled = verticalScrollBar()->value();
    setHtml(html);
    verticalScrollBar()->setValue(scrolled);
}

QString ReportView::part_html() const {
    const SignalColors signal = signal_colors(palette());
    const auto& part = document_.part();
    const QString name = path_text(document_.project().part_path().filename());
    QString html = heading(elided(name, 30));
    if (!part) return html + note(tr("The part has not been read."), signal.quiet);
    const MeshReport& r = part->report;
    const LengthUnit unit = document_.unit();
    const Vec3 s = part->box.size();
    const double size[3] = {s.x(), s.y(), s.z()};
    Facts facts(palette());
    facts.add(tr("Format"), worded(r.format));
    if (!r.name.empty()) facts.add(tr("Name"), elided(text(r.name), 40));
    facts.add(tr("Size"), size_text(size, unit, 5));
    const auto corner = [&](const Vec3& p) {
        QStringList numbers;
        for (int k = 0; k < 3; ++k)
            numbers << number_text(std::abs(p[k]) < 1e-9 ? 0 : p[k] / mm_per(unit), 5);
        return number_list(numbers) + QChar(' ') + text(unit_name(unit));
    };
    facts.add(tr("From"), corner(part->box.lo));
    facts.add(tr("To"), corner(part->box.hi));
    facts.add(tr("File unit"), text(unit_name(r.assumed_unit)));
    facts.add(tr("Facets"), count_text(r.facets));
    facts.add(tr("Vertices"), count_text(r.welded_vertices));
    facts.add(tr("Shells"), count_text(r.shells));
    facts.add(tr("Watertight"), r.watertight ? tr("yes") : tr("no"),
              r.watertight ? QString() : signal.attention.name());
    html += facts.html();

    const std::pair<std::size_t, QString> defects[] = {
        {r.open_edges, tr("open edges")},
        {r.non_manifold_edges, tr("edges of more than two facets")},
        {r.inconsistent_edges, tr("edges between facets of opposite winding")},
        {r.non_manifold_vertices, tr("vertices where shells touch")},
        {r.degenerate, tr("facets without area, left out")},
        {r.duplicate, tr("facets that occur twice, kept")},
    };
    QString list;
    for (const auto& [count, what] : defects)
        if (count > 0)
            list += QStringLiteral(
                        "<tr><td align=\"right\" style=\"padding:1px 8px 1px 0\">%1</td><td>%2</td></tr>")
                        .arg(count_text(count), what.toHtmlEscaped());
    if (!list.isEmpty()) {
        html += note(tr("Found in the mesh"), signal.attention);
        html += QStringLiteral("<table cellspacing=\"0\">%1</table>").arg(list);
    }
    for (const std::string& word : r.warnings)
        html += note(sentence(worded(explain_warning(word))), signal.attention);
    if (list.isEmpty() && r.warnings.empty()) html += note(tr("No defects found."), signal.good);
    if (part->repairs.empty()) return html;
    html += note(tr("The recipe of the scan room was carried out"), signal.good);
    for (const StepReport& step : part->repairs)
        html += QStringLiteral("<p style=\"margin:2px 0\"><b>%1</b>: %2</p>")
                    .arg(step_name(step.kind).toHtmlEscaped(), step_result(step, -1, unit).toHtmlEscaped());
    return html;
}

QString ReportView::program_html(const OpenedProgram& opened) const {
    const SignalColors signal = signal_colors(palette());
    const LengthUnit unit = document_.unit();
    QString html = heading(elided(text(opened.name), 30));
    html += note(tr("A program from a file, shown in place of the plan."), signal.quiet);
    for (std::size_t i = 0; i < opened.operations.size(); ++i) {
        const OperationResult& o = *opened.operations[i];
        if (opened.operations.size() > 1) html += note(elided(text(o.name), 40), signal.quiet);
        Facts facts(palette());
        if (!o.program.operation_name.empty())
            facts.add(tr("Operation"), elided(text(o.program.operation_name), 40));
        facts.add(tr("Tool"), tr("T%1, %2 %3")
                                  .arg(o.program.tool_number)
                                  .arg(worded(opened.tools[i].shape_name()),
                                       shown_length(opened.tools[i].diameter, unit, 4)));
        facts.add(tr("Motions"), count_text(o.program.motions.motions.size()));
        facts.add(tr("Cut length"), shown_length(o.totals.cut_length, unit, 5));
        facts.add(tr("Rapid length"), shown_length(o.totals.rapid_length, unit, 5));
        facts.add(tr("Machining time"), duration_text(o.totals.time_seconds));
        html += facts.html();
    }
    for (const std::string& remark : opened.remarks)
        html += note(sentence(worded(remark)), signal.attention);
    return html;
}

QString ReportView::operation_html(std::size_t i) const {
    const SignalColors signal = signal_colors(palette());
    const Operation& operation = document_.operation(i);
    const OperationState state = document_.state(i);
    const LengthUnit unit = document_.unit();
    QString html = heading(elided(text(operation.common().name), 30));
    const QColor color = state == OperationState::planned  ? signal.good
                         : state == OperationState::stale  ? signal.attention
                         : state == OperationState::failed ? signal.bad
                                                           : signal.quiet;
    html += note(state_text(state), color);
    if (state == OperationState::failed) return html + note(sentence(document_.failure(i)), signal.bad);
    const auto result = document_.result(i);
    if (!result)
        return state == OperationState::planning
                   ? html
                   : html + note(tr("Press Plan (F5) to plan it."), signal.quiet);

    if (!result->nothing_to_do.empty())
        return html
               + note(tr("Nothing to do: %1. No program is written for it.")
                          .arg(with_lengths_in(worded(result->nothing_to_do), unit)),
                      signal.quiet);
    const StrategyResult& path = result->path;
    const auto* turned = path.as<TurnedPath>();
    Facts facts(palette());
    facts.add(tr("Passes"), count_text(std::size_t(std::max(0, path.drive_planes))));
    facts.add(turned ? tr("Side feed") : tr("Step-over"),
              path.stepover_min == path.stepover_max
                  ? shown_length(path.stepover_min, unit, 4)
                  : tr("%1 to %2")
                        .arg(number_text(path.stepover_min / mm_per(unit), 4),
                             shown_length(path.stepover_max, unit, 4)));
    if (!turned)
        facts.add(tr("Direction"), tr("%1° from X").arg(number_text(degrees(path.direction), 4)));
    else if (document_.part())
        add_turning(facts, *turned, state == OperationState::stale ? Box3() : document_.part()->box, unit,
                    signal.attention.name());
    facts.add(tr("CC points"), count_text(result->cc_points));
    facts.add(tr("CL points"), count_text(result->cl_points));
    double cut = 0, rapid = 0, time = 0;
    for (const auto& program : programs_of(result)) {
        cut += program->totals.cut_length;
        rapid += program->totals.rapid_length;
        time += program->totals.time_seconds;
    }
    facts.add(tr("Cut length"), shown_length(cut, unit, 5));
    facts.add(tr("Rapid length"), shown_length(rapid, unit, 5));
    facts.add(tr("Machining time"), duration_text(time));
    for (const auto& program : result->further) {
        facts.add(tr("of it the main path"), duration_text(result->totals.time_seconds));
        facts.add(tr("T%1 in regions").arg(program->program.tool_number),
                  tr("%1, %2 passes", nullptr, std::max(0, program->path.drive_planes))
                      .arg(duration_text(program->totals.time_seconds),
                           count_text(std::size_t(std::max(0, program->path.drive_planes)))));
    }
    if (const auto* global_local = path.as<GlobalLocalPath>()) {
        const ReworkRegions& r = global_local->rework->regions;
        facts.add(tr("Rework regions"),
                  r.regions.empty()
                      ? tr("none")
                      : tr("%1, %2 % of the surface")
                            .arg(count_text(r.regions.size()), number_text(100 * r.area / r.part_area, 2)));
    }
    const double tolerance = operation.common().tolerance;
    facts.add(tr("Expected cusp"), shown_length(path.cusp_max, unit, 4),
              state == OperationState::planned && path.cusp_max > tolerance * (1 + 1e-9)
                  ? signal.attention.name()
                  : QString());
    // Of an older plan it is not known any more: the operation's own stands beside other figures.
    if (state != OperationState::stale) facts.add(tr("Tolerance"), shown_length(tolerance, unit, 4));
    if (path.cleanup_points > 0)
        facts.add(tr("Left for clean-up"), tr("%1 CC points").arg(count_text(path.cleanup_points)),
                  signal.attention.name());
    facts.add(tr("Planned in"), duration_text(result->seconds_planning));
    html += facts.html();
    for (const std::string& warning : result->warnings())
        html += note(sentence(with_lengths_in(worded(warning), unit)), signal.attention);
    return html;
}

QString ReportView::operations_html() const {
    const SignalColors signal = signal_colors(palette());
    QString html = heading(tr("Operations"));
    if (document_.operation_count() == 0)
        return html + note(tr("There is no operation yet. Add one below the tree."), signal.quiet);
    QString rows;
    double total = 0;
    bool all = true;
    for (std::size_t i = 0; i < document_.operation_count(); ++i) {
        const auto result = document_.state(i) == OperationState::planned ? document_.result(i) : nullptr;
        all &= result != nullptr;
        double time = 0;
        if (result)
            for (const auto& program : programs_of(result))
                time += program->totals.time_seconds;
        total += time;
        rows += QStringLiteral("<tr><td style=\"padding:1px 10px 1px 0\">%1</td><td align=\"right\" "
                               "style=\"padding:1px 0; color:%3\">%2</td></tr>")
                    .arg(elided(text(document_.operation(i).common().name), 24).toHtmlEscaped(),
                         result ? duration_text(time) : state_text(document_.state(i)),
                         (result ? palette().color(QPalette::Text) : signal.quiet).name());
    }
    if (all)
        rows += QStringLiteral("<tr><td style=\"padding:6px 10px 1px 0\"><b>%1</b></td><td align=\"right\" "
                               "style=\"padding:6px 0 1px 0\"><b>%2</b></td></tr>")
                    .arg(tr("Total"), duration_text(total));
    html += QStringLiteral("<table width=\"100%\" cellspacing=\"0\">%1</table>").arg(rows);
    return html;
}

} // namespace facetmill::ui
