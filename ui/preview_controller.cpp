#include "ui/preview_controller.h"

#include "core/job/preview_job.h"
#include "ui/layer_bar.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/worded.h"
#include "viz/preview_display.h"

namespace facetmill::ui {

namespace {

struct FoundPreview {
    PreviewDisplayPtr display;
    std::size_t passes = 0;
    QString without, wrong;
};

/// A legend is narrow: lines of no more than so many characters, where words allow it, and so many of them.
constexpr int legend_characters = 26;
constexpr int legend_lines = 6;

QStringList in_lines(const QString& words) {
    QStringList lines;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (lines.isEmpty() || lines.back().size() + 1 + word.size() > legend_characters)
            lines << word;
        else
            lines.back() += QLatin1Char(' ') + word;
    }
    if (lines.size() > legend_lines) {
        lines.erase(lines.begin() + legend_lines, lines.end());
        lines.back() += QStringLiteral("…");
    }
    return lines;
}

QString preview_label(const FoundPreview& found) {
    QStringList lines;
    if (!found.wrong.isEmpty()) {
        lines << PreviewController::tr("No preview") << in_lines(found.wrong);
        return lines.join(QLatin1Char('\n'));
    }
    lines << PreviewController::tr("Preview: about %1 passes", nullptr, int(found.passes))
                 .arg(count_text(found.passes));
    if (!found.without.isEmpty()) lines << in_lines(PreviewController::tr("without %1").arg(found.without));
    lines << in_lines(PreviewController::tr("not planned, not checked"));
    return lines.join(QLatin1Char('\n'));
}

} // namespace

PreviewController::PreviewController(Document& document, Viewport& viewport, const LayerBar& layers,
                                     QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), layers_(layers),
      previewer_(std::make_shared<PassPreviewer>()) {
    connect(&job_, &BackgroundJob::ended, this, &PreviewController::settled);
}

PreviewController::~PreviewController() = default;

void PreviewController::project_opened() {
    node_.reset();
    clear();
}

void PreviewController::node_chosen(const std::optional<TreeNode>& node) {
    node_ = node;
    refresh();
}

std::optional<std::size_t> PreviewController::wanted() const {
    const bool fits = node_ && node_->kind == TreeNode::Kind::operation
                      && node_->index < document_.operation_count() && document_.part_is_current()
                      && document_.has_stock() && !document_.program() && layers_.shown(ViewLayer::preview);
    if (!fits || document_.is_off(node_->index) || document_.state(node_->index) == OperationState::planned)
        return std::nullopt;
    return node_->index;
}

void PreviewController::refresh() {
    const auto operation = wanted();
    if (!operation) {
        if (!fingerprint_.empty()) clear();
        return;
    }
    std::string fingerprint = std::to_string(document_.operation_id(*operation)) + ' '
                              + Document::part_key(document_.project()) + ' '
                              + Document::fingerprint(document_.project(), *operation) + ' '
                              + std::string(unit_name(document_.unit()));
    if (fingerprint == fingerprint_) return;
    fingerprint_ = std::move(fingerprint);
    start(*operation);
}

void PreviewController::start(std::size_t operation) {
    auto found = std::make_shared<FoundPreview>();
    job_.start(
        tr("Previewing passes"),
        [=, previewer = previewer_, project = std::make_shared<const Project>(document_.project()),
         part = document_.part()](const Progress& progress) {
            try {
                const PassPreview preview =
                    previewer->preview(*project, operation, *part, progress.part(0, 0.9));
                found->passes = preview.passes;
                if (!preview.without.empty()) found->without = worded(preview.without.front());
                found->display = prepare_preview_display(preview, progress.part(0.9, 1));
            } catch (const Error& e) {
                found->wrong = with_lengths_in(sentence(worded(e.message())), project->unit);
            }
        },
        [=, this, fingerprint = fingerprint_](const JobEnd& end) {
            if (!end.done() || fingerprint != fingerprint_) return;
            viewport_.scene().preview().set(found->display, preview_label(*found).toStdString());
            viewport_.refresh();
        });
}

void PreviewController::clear() {
    job_.cancel();
    fingerprint_.clear();
    if (viewport_.scene().preview().label().empty()) return;
    viewport_.scene().preview().set(nullptr, {});
    viewport_.refresh();
}

} // namespace facetmill::ui
