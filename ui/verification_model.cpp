#include "ui/verification_model.h"

#include "ui/aside.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <algorithm>

namespace facetmill::ui {

namespace {
constexpr std::size_t listed_gouges = 10; // verify() lists no more
}

QString verdict_text(Verdict verdict) {
    switch (verdict) {
    case Verdict::none:
        return VerificationModel::tr("Not verified");
    case Verdict::verified:
        return VerificationModel::tr("Verified");
    case Verdict::failed:
        return VerificationModel::tr("Failed verification");
    case Verdict::not_judged:
        return VerificationModel::tr("Cannot be judged");
    case Verdict::stale:
        return VerificationModel::tr("Verification out of date");
    }
    return {};
}

QString finding_text(Finding::Kind kind) {
    switch (kind) {
    case Finding::Kind::gouge:
        return VerificationModel::tr("Gouge");
    case Finding::Kind::shank:
        return VerificationModel::tr("Shank");
    case Finding::Kind::holder:
        return VerificationModel::tr("Holder");
    case Finding::Kind::cutter:
        return VerificationModel::tr("Cutter");
    case Finding::Kind::rapid:
        return VerificationModel::tr("Rapid");
    case Finding::Kind::excess:
        return VerificationModel::tr("Excess");
    }
    return {};
}

VerificationModel::VerificationModel(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document_, &Document::opened, this, &VerificationModel::clear);
    connect(&document_, &Document::changed, this, &VerificationModel::update);
    connect(&document_, &Document::part_changed, this, &VerificationModel::update);
    connect(&document_, &Document::states_changed, this, &VerificationModel::update);
}

void VerificationModel::take(std::shared_ptr<const VerificationOutcome> outcome) {
    const auto judges = [&](std::size_t place) {
        const auto& setups = outcome->setups;
        return std::any_of(setups.begin(), setups.end(),
                           [place](const JudgedSetup& s) { return s.place == place; });
    };
    std::erase_if(outcomes_, [&](auto& earlier) {
        const bool again = std::all_of(earlier->setups.begin(), earlier->setups.end(),
                                       [&](const JudgedSetup& s) { return judges(s.place); });
        if (again) let_go(std::move(earlier));
        return again;
    });
    outcomes_.insert(outcomes_.begin(), std::move(outcome));
    choose_outcome();
    emit changed();
}

void VerificationModel::clear() {
    if (outcomes_.empty()) return;
    for (auto& outcome : outcomes_)
        let_go(std::move(outcome));
    outcomes_.clear();
    choose_outcome();
    emit changed();
}

bool VerificationModel::covers(const VerificationOutcome& outcome) const {
    const std::size_t shown = chosen_setup(document_.project());
    const std::vector<int>& own = document_.setup_ids()[shown];
    for (const JudgedSetup& setup : outcome.setups) {
        if (setup.place == shown && (outcome.program || own.empty())) return true;
        // By their operations: setups change places.
        if (std::any_of(setup.ids.begin(), setup.ids.end(),
                        [&](int id) { return std::find(own.begin(), own.end(), id) != own.end(); }))
            return true;
    }
    return false;
}

void VerificationModel::choose_outcome() {
    const auto it =
        std::find_if(outcomes_.begin(), outcomes_.end(), [&](const auto& o) { return covers(*o); });
    const auto chosen = it == outcomes_.end() ? nullptr : *it;
    const std::size_t shown = chosen_setup(document_.project());
    if (chosen != outcome_ || shown != listed_setup_) {
        outcome_ = chosen;
        listed_setup_ = shown;
        list_findings();
    }
    current_ = is_current();
}

const JudgedSetup* VerificationModel::shown_setup() const {
    if (!outcome_) return nullptr;
    for (const JudgedSetup& setup : outcome_->setups)
        if (setup.place == chosen_setup(document_.project())) return &setup;
    return nullptr;
}

bool VerificationModel::covers_all() const {
    if (!outcome_) return false;
    const Project& project = document_.project();
    const auto [first, last] = setups_of_stock(project, chosen_setup(project));
    std::size_t working = 0; // those that are left out have nothing to judge
    for (std::size_t k = first; k < last; ++k)
        working += last - first == 1 || !operations_on(setup_at(project, k)).empty() ? 1 : 0;
    return outcome_->setups.size() == working;
}

void VerificationModel::list_findings() {
    findings_.clear();
    if (!outcome_) return;
    const Verification& v = *outcome_->verification;
    const JudgedSetup* setup = shown_setup();
    const SetupFrame frame = setup ? setup->frame : SetupFrame();
    for (const DeviationExtreme& e : v.gouges)
        findings_.push_back(
            {Finding::Kind::gouge, -e.deviation, frame(e.point), frame.turn * e.normal, e.by});
    for (const Collision& c : v.collisions) {
        const auto kind = c.kind == Collision::Kind::shank    ? Finding::Kind::shank
                          : c.kind == Collision::Kind::holder ? Finding::Kind::holder
                          : c.kind == Collision::Kind::cutter ? Finding::Kind::cutter
                                                              : Finding::Kind::rapid;
        findings_.push_back({kind, c.depth, frame(c.place), Vec3::Zero(), c.at, c.with_part,
                             QString::fromStdString(printable(c.fixture, 60))});
    }
    for (const DeviationExtreme& e : v.excess)
        findings_.push_back(
            {Finding::Kind::excess, e.deviation, frame(e.point), frame.turn * e.normal, e.by});
}

bool VerificationModel::is_current() const {
    const Project& project = document_.project();
    if (!outcome_ || !document_.part_is_current() || outcome_->limits != project.limits
        || outcome_->program != document_.program())
        return false;
    for (const JudgedSetup& setup : outcome_->setups) {
        if (setup.place >= setup_count(project)) return false;
        const Project view = view_of_setup(project, setup.place);
        if (setup.part_key != Document::part_key(view)) return false;
        if (outcome_->program) continue;
        std::vector<int> ids = document_.setup_ids()[setup.place];
        if (!outcome_->last.isEmpty())
            ids.resize(std::min(ids.size(), setup.ids.size())); // what comes after is free
        if (setup.posting_key != Document::posting_key(view) || setup.ids != ids) return false;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (Document::fingerprint(view, i) != setup.fingerprints[i]) return false;
            if (!view.operations[i]->common().off && !document_.result_of(ids[i], setup.fingerprints[i]))
                return false;
        }
    }
    return true;
}

void VerificationModel::update() {
    if (outcomes_.empty()) return;
    const auto was = outcome_;
    const bool before = current_;
    choose_outcome();
    if (outcome_ != was || current_ != before || !current_)
        emit changed(); // stale: the operations may be others, too
}

bool VerificationModel::fits_part() const {
    const JudgedSetup* setup = shown_setup();
    return setup && setup->part_key == Document::part_key(document_.project());
}

bool VerificationModel::judged(std::size_t operation) const {
    if (!outcome_ || operation >= document_.operation_count() || document_.is_off(operation)) return false;
    const int id = document_.operation_id(operation);
    return std::any_of(outcome_->setups.begin(), outcome_->setups.end(), [id](const JudgedSetup& s) {
        return std::find(s.ids.begin(), s.ids.end(), id) != s.ids.end();
    });
}

bool VerificationModel::by(const Finding& finding, int id) const {
    const auto& programs = outcome_->programs;
    return finding.by.known() && finding.by.program < programs.size()
           && programs[finding.by.program].id == id;
}

bool VerificationModel::found_in(int id) const {
    return std::any_of(findings_.begin(), findings_.end(),
                       [&](const Finding& f) { return f.kind != Finding::Kind::excess && by(f, id); });
}

bool VerificationModel::gouges_are_cut_off() const {
    const Verification& v = verification();
    const bool nameless = std::any_of(v.gouges.begin(), v.gouges.end(),
                                      [](const DeviationExtreme& e) { return !e.by.known(); });
    return v.gouged() && (v.gouges.empty() || v.gouges.size() >= listed_gouges || nameless);
}

namespace {

Verdict shown(facetmill::Verdict verdict) {
    switch (verdict) {
    case facetmill::Verdict::verified:
        return Verdict::verified;
    case facetmill::Verdict::failed:
        return Verdict::failed;
    case facetmill::Verdict::not_judged:
        break;
    }
    return Verdict::not_judged;
}

} // namespace

QString subject_text(const VerificationOutcome& outcome) {
    const QString blocks = count_text(outcome.posted_blocks);
    if (outcome.setups.size() > 1)
        return outcome.posted_blocks == 0
                   ? VerificationModel::tr("%1 setups as one job").arg(outcome.setups.size())
                   : VerificationModel::tr("%1 setups as one job, as posted, %2 blocks")
                         .arg(outcome.setups.size())
                         .arg(blocks);
    QStringList parts;
    if (!outcome.last.isEmpty()) parts << VerificationModel::tr("up to “%1”").arg(elided(outcome.last, 24));
    if (outcome.posted_blocks != 0)
        parts << VerificationModel::tr("the posted program, %1 blocks").arg(blocks);
    return parts.join(QStringLiteral(", "));
}

namespace {

QString uncut_text(const Verification& v) {
    return VerificationModel::tr("%1 of what is to be cut is left uncut (allowed %2)")
        .arg(percent_text(v.uncut_share), percent_text(v.used.uncut_limit));
}

} // namespace

QString failure_text(const VerificationOutcome& outcome, LengthUnit unit) {
    const Verification& v = *outcome.verification;
    if (v.passed()) return {};
    if (v.verdict() == facetmill::Verdict::not_judged) return with_lengths_in(worded(v.not_judged), unit);
    QStringList parts;
    if (v.gouged())
        parts << VerificationModel::tr("gouges up to %1")
                     .arg(shown_length(std::max(v.figures.gouge_max, v.border.gouge_max), unit, 3));
    if (!v.collisions.empty())
        parts << VerificationModel::tr("%1 collisions", nullptr, int(v.collisions.size()))
                     .arg(count_text(v.collisions.size()));
    if (v.left_uncut()) parts << uncut_text(v);
    return parts.join(QStringLiteral(", "));
}

Verdict VerificationModel::verdict() const {
    if (!outcome_) return Verdict::none;
    if (!current_) return Verdict::stale;
    return shown(verification().verdict());
}

Verdict VerificationModel::verdict(std::size_t operation) const {
    if (!judged(operation)) return Verdict::none;
    if (!current_) return Verdict::stale;
    return shown(
        verification().verdict_where(found_in(document_.operation_id(operation)) || gouges_are_cut_off()));
}

QString VerificationModel::why(std::size_t operation) const {
    if (!judged(operation)) return verdict_text(Verdict::none);
    const int id = document_.operation_id(operation);
    if (!current_) return tr("Verification out of date: the project has changed since");
    if (verdict(operation) == Verdict::not_judged)
        return tr("Cannot be judged: %1")
            .arg(with_lengths_in(worded(verification().not_judged), document_.unit()));
    if (verdict(operation) == Verdict::verified) return tr("Verified: no gouge, no collision");
    double deepest = 0;
    std::size_t gouges = 0, collisions = 0;
    for (const Finding& f : findings_) {
        if (!by(f, id) || f.kind == Finding::Kind::excess) continue;
        if (f.kind == Finding::Kind::gouge) {
            ++gouges;
            deepest = std::max(deepest, f.depth);
        } else {
            ++collisions;
        }
    }
    QStringList parts;
    if (gouges > 0) parts << tr("gouges up to %1").arg(shown_length(deepest, document_.unit(), 3));
    if (collisions > 0) parts << tr("%1 collisions", nullptr, int(collisions)).arg(count_text(collisions));
    if (verification().left_uncut()) parts << uncut_text(verification());
    if (parts.isEmpty())
        return tr("Failed verification: the part is gouged at more places than are listed, "
                  "so this operation is not cleared");
    return tr("Failed verification: %1").arg(parts.join(QStringLiteral(", ")));
}

QString VerificationModel::program_name(std::size_t program) const {
    if (!outcome_ || program >= outcome_->programs.size()) return {};
    return text(outcome_->programs[program].name);
}

QString verdict_message(const VerificationOutcome& outcome, LengthUnit unit) {
    const Verification& v = *outcome.verification;
    const QString took = duration_text(v.seconds_cutting + v.seconds_probing),
                  subject = subject_text(outcome), failure = failure_text(outcome, unit);
    if (v.passed())
        return subject.isEmpty()
                   ? VerificationModel::tr("Verified in %1: no gouge, no collision.").arg(took)
                   : VerificationModel::tr("Verified in %1: %2: no gouge, no collision.").arg(took, subject);
    if (v.verdict() == facetmill::Verdict::not_judged)
        return VerificationModel::tr("Not verified (in %1), it cannot be judged: %2.").arg(took, failure);
    return VerificationModel::tr("Verification failed (in %1): %2.").arg(took, failure);
}

QString VerificationModel::subject_text() const {
    return outcome_ ? ui::subject_text(*outcome_) : QString();
}

QString VerificationModel::failure_text() const {
    return outcome_ ? ui::failure_text(*outcome_, document_.unit()) : QString();
}

} // namespace facetmill::ui
