#include "ui/suggest_controller.h"

#include "core/job/new_operation.h"
#include "core/job/project_setup.h"
#include "ui/operation_list.h"
#include "ui/operation_menu.h"
#include "ui/suggest_dialog.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

QString share_words(double share) {
    return number_text(100 * share, share < 0.1 ? 1 : 2);
}

QString suggestion_title(const Suggestion& s) {
    return SuggestController::tr("%1, %2").arg(operation_label(std::string(s.operation->kind())),
                                               text(s.tool));
}

QString suggestion_figures(const Suggestion& s, LengthUnit unit) {
    const Measures& m = s.result.measures;
    const double per = mm_per(unit);
    if (s.previewed)
        return SuggestController::tr("About %1, by a preview of its passes").arg(duration_text(s.seconds));
    return SuggestController::tr("About %1; leaves at most %2 on 99 % of the surface, and %3 % of it uncut")
        .arg(duration_text(s.seconds), shown_length(m[Measure::excess_p99].value_or(0) * per, unit, 2),
             share_words(m[Measure::uncut_share].value_or(0)));
}

/// What speaks for its kind on this part.
QString kind_reason(const std::string& kind, const SuggestedPart& part) {
    const QString steep = share_words(part.steep_share), limit = number_text(degrees(part.steep), 2);
    if (kind == "waterline")
        return SuggestController::tr("%1 % of the surface is steeper than %2°: levels go round it")
            .arg(steep, limit);
    // A share that would be told as 0 is no reason.
    constexpr double some_share = 0.005;
    if (kind == "steep_shallow" && part.steep_share >= some_share)
        return SuggestController::tr(
                   "%1 % of the surface is steeper than %2°: levels there leave less, passes "
                   "side by side cut the rest")
            .arg(steep, limit);
    if (kind == "finish3" || kind == "steep_shallow")
        return SuggestController::tr(
                   "%1 % of the surface is no steeper than %2°: passes side by side lie far apart "
                   "there")
            .arg(share_words(1 - part.steep_share), limit);
    if (kind == "scallop")
        return SuggestController::tr(
            "Passes follow the border, everywhere as far apart as the tolerance allows");
    if (kind == "spiral") return SuggestController::tr("One pass that winds over the part needs few links");
    if (kind == "radial")
        return SuggestController::tr("Passes from the middle outward meet its rims head on");
    if (kind == "morph") return SuggestController::tr("Passes follow the part's outline");
    if (kind == "finish5" || kind == "global_local")
        return SuggestController::tr("The tool leans with the surface, and leaves wide strips");
    if (kind == "lathe_finish") return SuggestController::tr("The part turns under the tool");
    return operation_words(kind);
}

/// What goes before all of them, and why; empty where nothing has to.
QString roughing_words(const Suggestions& all, const Project& project) {
    if (!all.rough) return {};
    const std::optional<Tool>& own = all.rough->tool;
    const Tool& tool = own ? *own : project.tool_of(*all.rough->operation);
    return SuggestController::tr("%1 goes before it, with %2: the stock stands up to %3 above the part, and "
                                 "the finishing tool comes %4 deep into it")
        .arg(text(first_name_of("rough")), text(tool.name),
             shown_length(all.unroughed.highest, project.unit, 3),
             shown_length(all.unroughed.reach, project.unit, 3));
}

/// More of the surface stays uncut than the verification allows, as hollows are narrower than its cutter, and
/// nothing is there yet that goes over them.
bool asks_clean_up(const Suggestion& s, const Project& project) {
    const auto cleans = [](const Operation* o) { return o->purpose() == Purpose::cleaning; };
    const bool runs = s.operation->keeps_axis() && !s.operation->turning();
    return runs && s.result.measures[Measure::uncut_share].value_or(0) > project.limits.uncut_limit
           && std::ranges::none_of(operations_on(project), cleans);
}

/// What goes after it, and why; empty where nothing has to.
QString clean_up_words(const Suggestion& s, const Project& project) {
    if (!asks_clean_up(s, project)) return {};
    return SuggestController::tr(
               "%1 goes after it, with a smaller tool: alone it leaves about %2 % uncut, and "
               "%3 % is allowed")
        .arg(text(first_name_of("cleanup")), share_words(s.result.measures[Measure::uncut_share].value_or(0)),
             share_words(project.limits.uncut_limit));
}

/// Longer than that takes a word before it is added; seconds of a processor.
constexpr double long_planning = 60;

/// In whole minutes: more is not known of it.
double rough_duration(double seconds) {
    return 60 * std::round(seconds / 60);
}

QStringList reasons_of(const Suggestions& all, std::size_t i) {
    const Suggestion& s = all.best[i];
    QStringList reasons{kind_reason(std::string(s.operation->kind()), all.part)};
    const auto left = [&](std::size_t k) {
        return all.best[k].result.measures[Measure::excess_p99].value_or(0);
    };
    bool quickest = true, cleanest = !s.previewed;
    for (std::size_t k = 0; k < all.best.size(); ++k) {
        quickest = quickest && s.seconds <= all.best[k].seconds;
        cleanest = cleanest && left(i) <= left(k);
    }
    if (quickest) reasons << SuggestController::tr("The quickest of these");
    if (cleanest && all.best.size() > 1) reasons << SuggestController::tr("Leaves least of these");
    if (!quickest) {
        double least = s.seconds;
        for (const Suggestion& other : all.best)
            least = std::min(least, other.seconds);
        if (least > 0)
            reasons << SuggestController::tr("Takes %1 times as long as the quickest")
                           .arg(number_text(s.seconds / least, 3));
    }
    if (s.previewed && s.planning_seconds >= long_planning)
        reasons << SuggestController::tr("Planning and verifying it takes about %1")
                       .arg(duration_text(rough_duration(s.planning_seconds)));
    if (!s.result.passed && s.previewed)
        reasons << SuggestController::tr("Leaves about %1 % of what the tool sees of the part uncut")
                       .arg(share_words(s.result.measures[Measure::uncut_share].value_or(0)));
    else if (!s.result.passed)
        reasons
            << SuggestController::tr("Alone it does not pass the verification: %1").arg(worded(s.result.why));
    return reasons;
}

} // namespace

SuggestController::SuggestController(Document& document, QWidget* window)
    : Controller(window), document_(document), window_(window) {
    connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, const QString& label) {
        dialog_->show_progress(fraction);
        dialog_->show_status(tr("Planning and judging operations for this part: %1").arg(label));
    });
    connect(&job_, &BackgroundJob::ended, this, &SuggestController::settled);
}

SuggestController::~SuggestController() = default;

std::string SuggestController::asked() const {
    // A name or a program's number makes no difference; every value that planning reads does.
    return document_.has_part()
               ? Document::part_key(document_.project()) + project_to_json(document_.project())
               : std::string();
}

void SuggestController::open() {
    if (!dialog_) {
        dialog_ = new SuggestDialog(window_);
        connect(dialog_, &SuggestDialog::again_wanted, this, &SuggestController::look);
        connect(dialog_, &SuggestDialog::stop_wanted, &job_, &BackgroundJob::cancel);
        connect(dialog_, &SuggestDialog::add_wanted, this, &SuggestController::add);
        connect(dialog_, &QDialog::finished, &job_, &BackgroundJob::cancel);
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    if (!job_.running() && (!found_ || found_for_ != asked())) look();
}

void SuggestController::look() {
    if (!document_.part_is_current()) return;
    found_.reset();
    dialog_->show_cards({});
    dialog_->show_progress(0);
    dialog_->show_status(tr("Planning and judging operations for this part"));
    auto found = std::make_shared<Suggestions>();
    job_.start(
        tr("Looking for suggestions"),
        [found, project = std::make_shared<const Project>(document_.project()),
         part = document_.part()](const Progress& progress) { *found = suggest(*project, *part, progress); },
        [this, found, asked = asked()](const JobEnd& end) {
            dialog_->show_progress(-1);
            if (end.how == JobEnd::How::failed) return dialog_->show_status(end.message);
            if (!end.done()) return dialog_->show_status(tr("Stopped. Nothing is suggested."));
            found_ = found;
            found_for_ = looked_for_ = asked;
            show();
            if (found_for_ != this->asked()) show_stale();
        });
}

void SuggestController::show() {
    as_found_ = true;
    std::vector<SuggestDialog::Card> cards;
    for (std::size_t i = 0; i < found_->best.size(); ++i) {
        const Suggestion& s = found_->best[i];
        QStringList reasons = reasons_of(*found_, i);
        if (const QString first = roughing_words(*found_, document_.project()); !first.isEmpty())
            reasons.prepend(first);
        if (const QString last = clean_up_words(s, document_.project()); !last.isEmpty()) reasons << last;
        cards.push_back({operation_picture(std::string(s.operation->kind())), suggestion_title(s),
                         suggestion_figures(s, document_.unit()), reasons});
    }
    dialog_->show_cards(cards);
    if (found_->best.front().previewed)
        return dialog_->show_status(
            tr("The best of %1 operations by previews of their passes. Planning all of them, to judge what "
               "they leave, would take long: add one, then plan and verify it.",
               nullptr, int(found_->looked_at))
                .arg(count_text(found_->looked_at)));
    dialog_->show_status(
        tr("The best of %1 operations that were planned for this part and the project's tools, "
           "by time and by what they leave",
           nullptr, int(found_->looked_at))
            .arg(count_text(found_->looked_at)));
}

void SuggestController::show_stale() {
    as_found_ = false;
    dialog_->show_status(tr("The project has changed since: look again to be sure."));
}

std::size_t SuggestController::put_in(const Suggestion& suggestion, QStringList& off) {
    const Operation& suggested = *suggestion.operation;
    const Project& project = document_.project();
    const auto cuts_the_same = [&](const Operation& o) {
        const OperationCommon &its = o.common(), &new_one = suggested.common();
        return o.purpose() == Purpose::finishing && !its.off && its.boundary == new_one.boundary
               && its.avoid == new_one.avoid;
    };
    for (std::size_t k = 0; k < project.operations.size(); ++k)
        if (cuts_the_same(*project.operations[k])) {
            off << text(project.operations[k]->common().name);
            switch_operation(document_, k, true);
        }
    if (found_->rough && unroughed_stock(project, *document_.part(), suggested))
        document_.add_operation("rough");
    auto operation = suggested.clone();
    operation->common().name = document_.free_operation_name(first_name_of(std::string(suggested.kind())));
    const std::size_t place = new_operation(suggested.kind(), project).place;
    std::vector<std::unique_ptr<Operation>> one;
    one.push_back(std::move(operation));
    document_.add_operations(tr("Add operation"), place, std::move(one), {});
    if (asks_clean_up(suggestion, project)) document_.add_operation("cleanup");
    return place;
}

void SuggestController::add(std::size_t i) {
    if (!found_ || i >= found_->best.size() || !document_.part_is_current()) return;
    const auto found = found_; // a step of the history may drop what was found
    QStringList off;
    document_.undo_stack().beginMacro(tr("Add operation"));
    const std::size_t place = put_in(found->best[i], off);
    document_.undo_stack().endMacro();
    const QString name = text(document_.operation(place).common().name);
    found_for_ = asked(); // with one of them more the others are no worse
    as_found_ = false;
    dialog_->show_status(
        off.isEmpty() ? tr("%1 was added to the project. Undo takes it away.").arg(name)
                      : tr("%1 was added to the project in place of %2 (switched off). Undo takes it back.")
                            .arg(name, off.join(QStringLiteral(", "))));
    emit added(place);
}

void SuggestController::project_opened() {
    job_.cancel();
    found_.reset();
    if (!dialog_) return;
    dialog_->show_cards({});
    dialog_->show_progress(-1);
    dialog_->show_status({});
    dialog_->close();
}

void SuggestController::project_changed() {
    if (!dialog_ || !found_) return;
    const std::string now = asked();
    if (now == looked_for_ && !as_found_) {
        found_for_ = now; // undone
        show();
    } else if (now != found_for_ && now != looked_for_) {
        show_stale();
    }
}

} // namespace facetmill::ui
