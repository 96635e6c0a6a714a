#include "ui/study_story.h"

#include "ui/document.h"
#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/verification_model.h"
#include "ui/worded.h"

#include <QObject>

#include <cmath>

namespace facetmill::ui {

namespace {

/// How much more than the project's own a peak load is where it is told.
constexpr double told_load = 1.5;

/// The peak load of a candidate over that of the project as it stands; 0 where one is not known.
double peak_load_ratio(const StudyOutcome& outcome, std::size_t candidate) {
    const RungResult *of = state_of(outcome, candidate).last(), *project = state_of(outcome, 0).last();
    if (!of || !project) return 0;
    const auto load = of->measures[Measure::peak_load], usual = project->measures[Measure::peak_load];
    return load && usual && *usual > 0 ? *load / *usual : 0;
}

/// A coarse look takes this share of a fine one (core/study/evaluation.cpp).
constexpr double coarse_share = 1.0 / 3.5;

QString list_html(const QString& head, const QStringList& lines) {
    QString html = QStringLiteral("<p style=\"margin:8px 0 2px 0\"><b>%1</b></p>").arg(head.toHtmlEscaped());
    for (const QString& line : lines)
        html += QStringLiteral("<p style=\"margin:1px 0 1px 12px\">%1</p>").arg(line.toHtmlEscaped());
    return html;
}

} // namespace

QString study_outcome_words(const StudyLook& look) {
    const StudyOutcome& outcome = look.outcome;
    QString words;
    if (!outcome.decision.missing.empty())
        words = QObject::tr("The study is not at its end: Resume goes on with it.");
    else if (const auto winner = outcome.decision.winner) {
        const auto time = [&](std::size_t i) {
            const RungResult* last = state_of(outcome, i).last();
            const auto seconds = last ? last->measures[Measure::machining_time] : std::nullopt;
            return seconds ? duration_text(*seconds) : QObject::tr("unknown");
        };
        words = QObject::tr("Candidate %1 wins: %2 of machining, against %3 of the project as it stands.")
                    .arg(*winner)
                    .arg(time(*winner), time(0));
        if (const double more = peak_load_ratio(outcome, *winner); more >= told_load)
            words = QObject::tr("%1 Its peak load is %2 times the project's: nothing here knows whether "
                                "machine and tool stand that.")
                        .arg(words, number_text(more, 2));
    } else {
        try {
            check_winner(*look.folder, outcome);
        } catch (const Error& e) {
            words = sentence(worded(Error(e.code(), "", e.message(), e.remedy())));
        }
    }
    if (!outcome.lost.empty())
        words = QObject::tr("%1 Lost: %2 (%3).")
                    .arg(words)
                    .arg(outcome.lost.size())
                    .arg(worded(outcome.lost.begin()->second));
    return words;
}

QString study_estimate_words(const StudyDraft& draft, const Document& document,
                             const VerificationModel& verification) {
    const Study usual;
    const double n = draft.candidates();
    const double coarse = std::ceil(usual.coarse * n), fine = std::ceil(usual.fine * n);
    QString words =
        QObject::tr("Candidates: %1 to plan, about %2 to judge coarsely and %3 finely.")
            .arg(count_text(std::size_t(n)), count_text(std::size_t(coarse)), count_text(std::size_t(fine)));
    double planning = 0;
    bool known = document.all_planned() && verification.current();
    for (std::size_t i = 0; known && i < document.operation_count(); ++i)
        if (const auto result = document.result(i)) planning += result->seconds_planning;
    if (known) {
        const Verification& v = verification.verification();
        const double judging = v.seconds_cutting + v.seconds_probing;
        const double seconds =
            n * planning + coarse * (planning + coarse_share * judging) + fine * (planning + judging);
        words = QObject::tr("%1 About %2 on this computer, as long as the project itself took.")
                    .arg(words, duration_text(seconds));
    } else {
        words = QObject::tr("%1 How long that takes is told here once the project is planned and verified.")
                    .arg(words);
    }
    return words;
}

QString study_question_html(const StudyFolder& folder) {
    const Study& study = folder.study();
    QStringList vary, want, limits;
    for (const StudyVariation& v : study.vary) {
        QStringList labels;
        for (const StudyChoice& c : v.choices)
            labels << text(c.label);
        vary << QObject::tr("%1: %2").arg(text(v.name), labels.join(QStringLiteral("; ")));
    }
    for (const Measure m : study.want)
        want << measure_label(m);
    for (const StudyLimit& l : study.limits)
        limits << (l.project ? QObject::tr("%1: %2 times what the project comes to")
                                   .arg(measure_label(l.measure), number_text(l.most, 4))
                             : QObject::tr("%1: %2").arg(measure_head(l.measure, folder.project().unit),
                                                         measure_text(l.measure, l.most)));
    QString html =
        list_html(QObject::tr("What may vary"), vary) + list_html(QObject::tr("To be kept small"), want);
    if (!limits.isEmpty()) html += list_html(QObject::tr("At most"), limits);
    return html + list_html(QObject::tr("Folder"), {path_text(folder.path())});
}

double study_share_done(const StudyStand& stand) {
    // As much longer as a look takes than planning (core/study/evaluation.cpp).
    constexpr std::array<double, all_rungs.size()> weights = {1, 2, 5};
    double done = 0, all = 0;
    for (std::size_t r = 0; r < all_rungs.size(); ++r) {
        done += weights[r] * double(stand.done[r]);
        all += weights[r] * double(stand.expected[r]);
    }
    return all > 0 ? done / all : 0;
}

QString study_stand_words(const StudyStand& stand) {
    const QString words =
        QObject::tr("Planned %1 of %2, judged coarsely %3 of about %4, finely %5 of about %6.")
            .arg(stand.done[0])
            .arg(stand.expected[0])
            .arg(stand.done[1])
            .arg(stand.expected[1])
            .arg(stand.done[2])
            .arg(stand.expected[2]);
    if (stand.seconds_left < 0) return words;
    return QObject::tr("%1 Still about %2.").arg(words, duration_text(stand.seconds_left));
}

} // namespace facetmill::ui
