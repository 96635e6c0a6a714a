// The last verification and what it is worth now: it judged certain operations as they were planned then, and
// any change to one of them, or to part and stock, makes all its verdicts stale. An earlier operation can
// have hidden behind a later one that cut deeper, so no verdict outlives the plan as a whole.
#pragma once

#include "core/verify/verify.h"
#include "ui/document.h"
#include "viz/deviation_display.h"

#include <QObject>

namespace facetmill::ui {

enum class Verdict { none, verified, failed, not_judged, stale };
/// "Verified", "Failed verification", ...
QString verdict_text(Verdict verdict);

/// A verification with what it judged.
struct VerificationOutcome {
    std::shared_ptr<const PlanResult> plan;
    /// The program that was judged, where that was not the plan; `ids` is empty then.
    std::shared_ptr<const OpenedProgram> program;
    std::vector<int> ids;                  ///< ids of the operations in the document
    std::vector<std::string> fingerprints; ///< Document::fingerprint of each
    /// For each of the plan's programs, the place of its operation in `ids`.
    std::vector<std::size_t> program_operations;
    std::string part_key;
    VerifyLimits limits;
    std::string posting_key;       ///< Document::posting_key, where the plan was judged as it is posted
    std::size_t posted_blocks = 0; ///< of the posted program; 0: the plan itself was judged
    std::shared_ptr<const Verification> verification;
    DeviationDisplayPtr display;
};

/// One line of the list of findings.
struct Finding {
    enum class Kind { gouge, shank, holder, rapid, cutter, excess };
    Kind kind = Kind::gouge;
    double depth = 0;                                 ///< mm, positive
    Vec3 place = Vec3::Zero(), normal = Vec3::Zero(); ///< normal: zero where there is none
    MotionPlace by;
    bool with_part = false; ///< a collision that reaches into the part
    QString fixture;        ///< that is touched; empty: part or stock
};
QString finding_text(Finding::Kind kind);

class VerificationModel : public QObject {
    Q_OBJECT
public:
    explicit VerificationModel(Document& document, QObject* parent = nullptr);

    void take(std::shared_ptr<const VerificationOutcome> outcome);
    void clear();
    bool any() const { return outcome_ != nullptr; }
    /// The project is still as it was judged.
    bool current() const { return outcome_ && current_; }
    /// Where the part itself is another one, nothing of the verification can be shown on it.
    bool fits_part() const;
    const VerificationOutcome& outcome() const { return *outcome_; }
    const Verification& verification() const { return *outcome_->verification; }

    /// Verdict on the whole plan. Never `verified` when an operation is not.
    Verdict verdict() const;
    /// Verdict on an operation of the document, with the reason.
    Verdict verdict(std::size_t operation) const;
    QString why(std::size_t operation) const;
    /// Gouges first, then collisions, then the largest excess.
    const std::vector<Finding>& findings() const { return findings_; }
    QString program_name(std::size_t program) const;
    /// "the posted program, 59 414 blocks"; empty where the plan itself was judged.
    QString subject_text() const;
    /// "2 gouges up to 0.12 mm, 3 collisions"; empty when it passed.
    QString failure_text() const;

signals:
    /// Another verification, or its worth.
    void changed();

private:
    void update();
    bool is_current() const;
    /// Place of the operation among those judged.
    std::optional<std::size_t> judged(std::size_t operation) const;
    /// By a program of the operation judged at this place.
    bool by(const Finding& finding, std::size_t judged) const;
    bool found_in(std::size_t judged) const;
    /// More stays uncut than may; and that as a text.
    bool uncut_fails() const;
    QString uncut_text() const;
    /// The list of gouges is full: there may be more, of any operation.
    bool gouges_are_cut_off() const;

    Document& document_;
    std::shared_ptr<const VerificationOutcome> outcome_;
    std::vector<Finding> findings_;
    bool current_ = false;
};

} // namespace facetmill::ui
