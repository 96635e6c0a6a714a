// Verifications and what they are worth now: each judged certain operations, of one setup or of several as
// one job, as they were planned then, and any change to one of them, or to part and stock, makes all its
// verdicts stale. An earlier operation can have hidden behind a later one that cut deeper, so no verdict
// outlives the plan as a whole. What is told is the newest verification of the setup that the document shows.
#pragma once

#include "core/job/setup_plan.h"
#include "core/verify/verify.h"
#include "ui/document.h"
#include "viz/deviation_display.h"

#include <QObject>

namespace facetmill::ui {

enum class Verdict { none, verified, failed, not_judged, stale };
/// "Verified", "Failed verification", ...
QString verdict_text(Verdict verdict);

/// A setup as it was judged.
struct JudgedSetup {
    std::size_t place = 0;                 ///< among the document's setups
    std::vector<int> ids;                  ///< ids of its operations in the document
    std::vector<std::string> fingerprints; ///< Document::fingerprint of each
    std::string part_key;
    std::string posting_key; ///< Document::posting_key, where the plan was judged as it is posted
    SetupFrame frame;        ///< from the coordinates of the verification to its own
    DeviationDisplayPtr display;
};

/// A program as it was judged.
struct JudgedProgram {
    std::string name;
    std::size_t setup = 0; ///< place in VerificationOutcome::setups
    int id = 0;            ///< of its operation in the document
    std::size_t index = 0; ///< among the programs of its setup
};

/// A verification with what it judged.
struct VerificationOutcome {
    std::vector<JudgedSetup> setups; ///< one, or several that cut one stock
    /// The program that was judged, where that was not the plan; no `ids` then.
    std::shared_ptr<const OpenedProgram> program;
    std::vector<JudgedProgram> programs; ///< in the order of the verification's
    QString last; ///< name of the last operation that was judged, of one setup; empty: all were
    std::vector<SetupPlan> chain; ///< of several setups, as they were planned
    double across = 0;            ///< diagonal of the part's box, mm
    VerifyLimits limits;
    std::size_t posted_blocks = 0; ///< of the posted program; 0: the plan itself was judged
    std::shared_ptr<const Verification> verification;
    /// Why nothing could have been verified, so that nothing was cut; no `verification` then.
    std::string not_begun;
};

/// "the posted program, 59 414 blocks", "3 setups as one job", "up to “Rough”"; empty where the plan of one
/// setup was judged.
QString subject_text(const VerificationOutcome& outcome);
/// "2 gouges up to 0.12 mm, 3 collisions"; empty when it passed.
QString failure_text(const VerificationOutcome& outcome, LengthUnit unit);

/// A sentence with the verdict and how long it took.
QString verdict_message(const VerificationOutcome& outcome, LengthUnit unit);

/// One line of the list of findings; places are those of the setup that is shown.
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
    /// The shown setup as it was judged; null where it is none of the outcome's.
    const JudgedSetup* shown_setup() const;
    /// The whole job was judged, as far as it cuts the stock of the shown setup.
    bool covers_all() const;
    /// The name of the last operation that was judged, where not all of the setup's were; else empty.
    QString last_judged() const { return outcome_ ? outcome_->last : QString(); }
    const VerificationOutcome& outcome() const { return *outcome_; }
    const std::shared_ptr<const VerificationOutcome>& outcome_shared() const { return outcome_; }
    const Verification& verification() const { return *outcome_->verification; }

    /// Verdict on the whole plan. Never `verified` when an operation is not.
    Verdict verdict() const;
    /// Verdict on an operation of the document, with the reason.
    Verdict verdict(std::size_t operation) const;
    QString why(std::size_t operation) const;
    /// Gouges first, then collisions, then the largest excess.
    const std::vector<Finding>& findings() const { return findings_; }
    QString program_name(std::size_t program) const;
    QString subject_text() const;
    QString failure_text() const;

signals:
    /// Another verification, or its worth.
    void changed();

private:
    void update();
    /// Makes the newest outcome that covers the shown setup the one that is told.
    void choose_outcome();
    void list_findings();
    bool covers(const VerificationOutcome& outcome) const;
    bool is_current() const;
    /// The operation is among those judged.
    bool judged(std::size_t operation) const;
    /// By a program of an operation with this id.
    bool by(const Finding& finding, int id) const;
    bool found_in(int id) const;
    /// The list of gouges is full: there may be more, of any operation.
    bool gouges_are_cut_off() const;

    Document& document_;
    std::vector<std::shared_ptr<const VerificationOutcome>> outcomes_; ///< newest first
    std::shared_ptr<const VerificationOutcome> outcome_;               ///< that of the shown setup
    std::vector<Finding> findings_;
    std::size_t listed_setup_ = 0; ///< in whose coordinates `findings_` are
    bool current_ = false;
};

} // namespace facetmill::ui
