#include "ui/verification_model.h"

#include "ui/text.h"

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
    outcome_ = std::move(outcome);
    findings_.clear();
    const Verification& v = *outcome_->verification;
    for (const DeviationExtreme& e : v.gouges)
        findings_.push_back({Finding::Kind::gouge, -e.deviation, e.point, e.normal, e.by});
    for (const Collision& c : v.collisions) {
        const auto kind = c.kind == Collision::Kind::shank    ? Finding::Kind::shank
                          : c.kind == Collision::Kind::holder ? Finding::Kind::holder
                          : c.kind == Collision::Kind::cutter ? Finding::Kind::cutter
                                                              : Finding::Kind::rapid;
        findings_.push_back({kind, c.depth, c.place, Vec3::Zero(), c.at, c.with_part,
                             QString::fromStdString(printable(c.fixture, 60))});
    }
    for (const DeviationExtreme& e : v.excess)
        findings_.push_back({Finding::Kind::excess, e.deviation, e.point, e.normal, e.by});
    current_ = is_current();
    emit changed();
}

void VerificationModel::clear() {
    if (!outcome_) return;
    outcome_ = nullptr;
    findings_.clear();
    current_ = false;
    emit changed();
}

bool VerificationModel::is_current() const {
    if (!outcome_ || !document_.part_is_current()
        || outcome_->part_key != Document::part_key(document_.project())
        || outcome_->limits != document_.project().limits || outcome_->program != document_.program())
        return false;
    if (outcome_->program) return true;
    if (outcome_->posting_key != Document::posting_key(document_.project())) return false;
    if (outcome_->ids.size() != document_.operation_count()) return false;
    for (std::size_t i = 0; i < outcome_->ids.size(); ++i)
        if (document_.operation_id(i) != outcome_->ids[i] || document_.state(i) != OperationState::planned
            || Document::fingerprint(document_.project(), i) != outcome_->fingerprints[i])
            return false;
    return true;
}

void VerificationModel::update() {
    if (!outcome_) return;
    const bool before = current_;
    current_ = is_current();
    if (current_ != before || !current_) emit changed(); // stale: the operations may be others, too
}

bool VerificationModel::fits_part() const {
    return outcome_ && outcome_->part_key == Document::part_key(document_.project());
}

std::optional<std::size_t> VerificationModel::judged(std::size_t operation) const {
    if (!outcome_ || operation >= document_.operation_count()) return std::nullopt;
    const auto& ids = outcome_->ids;
    const auto it = std::find(ids.begin(), ids.end(), document_.operation_id(operation));
    if (it == ids.end()) return std::nullopt;
    return std::size_t(it - ids.begin());
}

bool VerificationModel::by(const Finding& finding, std::size_t judged) const {
    const auto& operations = outcome_->program_operations;
    return finding.by.known() && finding.by.program < operations.size()
           && operations[finding.by.program] == judged;
}

bool VerificationModel::found_in(std::size_t judged) const {
    return std::any_of(findings_.begin(), findings_.end(),
                       [&](const Finding& f) { return f.kind != Finding::Kind::excess && by(f, judged); });
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

Verdict VerificationModel::verdict() const {
    if (!outcome_) return Verdict::none;
    if (!current_) return Verdict::stale;
    return shown(verification().verdict());
}

Verdict VerificationModel::verdict(std::size_t operation) const {
    const auto at = judged(operation);
    if (!at) return Verdict::none;
    if (!current_) return Verdict::stale;
    return shown(verification().verdict_where(found_in(*at) || gouges_are_cut_off()));
}

bool VerificationModel::uncut_fails() const {
    return verification().left_uncut();
}

QString VerificationModel::why(std::size_t operation) const {
    const auto at = judged(operation);
    if (!at) return verdict_text(Verdict::none);
    if (!current_) return tr("Verification out of date: the project has changed since");
    if (verdict(operation) == Verdict::not_judged)
        return tr("Cannot be judged: %1")
            .arg(with_lengths_in(text(verification().not_judged), document_.unit()));
    if (verdict(operation) == Verdict::verified) return tr("Verified: no gouge, no collision");
    double deepest = 0;
    std::size_t gouges = 0, collisions = 0;
    for (const Finding& f : findings_) {
        if (!by(f, *at) || f.kind == Finding::Kind::excess) continue;
        if (f.kind == Finding::Kind::gouge) {
            ++gouges;
            deepest = std::max(deepest, f.depth);
        } else {
            ++collisions;
        }
    }
    QStringList parts;
    if (gouges > 0) parts << tr("gouges up to %1").arg(shown_length(deepest, document_.unit(), 3));
    if (collisions > 0)
        parts << (collisions == 1 ? tr("1 collision") : tr("%1 collisions").arg(count_text(collisions)));
    if (uncut_fails()) parts << uncut_text();
    if (parts.isEmpty())
        return tr("Failed verification: the part is gouged at more places than are listed, "
                  "so this operation is not cleared");
    return tr("Failed verification: %1").arg(parts.join(QStringLiteral(", ")));
}

QString VerificationModel::program_name(std::size_t program) const {
    if (!outcome_ || program >= outcome_->plan->operations.size()) return {};
    return text(outcome_->plan->operations[program]->name);
}

QString VerificationModel::subject_text() const {
    if (!outcome_ || outcome_->posted_blocks == 0) return {};
    return tr("the posted program, %1 blocks").arg(count_text(outcome_->posted_blocks));
}

QString VerificationModel::uncut_text() const {
    const Verification& v = verification();
    return tr("%1 of what is to be cut is left uncut (allowed %2)")
        .arg(percent_text(v.uncut_share), percent_text(v.used.uncut_limit));
}

QString VerificationModel::failure_text() const {
    if (!outcome_ || verification().passed()) return {};
    const Verification& v = verification();
    if (v.verdict() == facetmill::Verdict::not_judged)
        return with_lengths_in(text(v.not_judged), document_.unit());
    QStringList parts;
    if (v.gouged())
        parts << tr("gouges up to %1")
                     .arg(shown_length(std::max(v.figures.gouge_max, v.border.gouge_max), document_.unit(),
                                       3));
    if (!v.collisions.empty())
        parts << (v.collisions.size() == 1 ? tr("1 collision")
                                           : tr("%1 collisions").arg(count_text(v.collisions.size())));
    if (uncut_fails()) parts << uncut_text();
    return parts.join(QStringLiteral(", "));
}

} // namespace facetmill::ui
