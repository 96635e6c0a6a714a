#include "ui/study_words.h"

#include "ui/text.h"

#include <QObject>

namespace facetmill::ui {

QString measure_label(Measure measure) {
    switch (measure) {
    case Measure::machining_time:
        return QObject::tr("Machining time");
    case Measure::cut_length:
        return QObject::tr("Cut length");
    case Measure::rapid_length:
        return QObject::tr("Rapid length");
    case Measure::tool_changes:
        return QObject::tr("Tool changes");
    case Measure::cusp_max:
        return QObject::tr("Largest cusp");
    case Measure::gouge_max:
        return QObject::tr("Deepest gouge");
    case Measure::excess_max:
        return QObject::tr("Largest excess");
    case Measure::excess_p99:
        return QObject::tr("Excess of 99 %");
    case Measure::excess_p95:
        return QObject::tr("Excess of 95 %");
    case Measure::uncut_share:
        return QObject::tr("Uncut");
    case Measure::peak_load:
        return QObject::tr("Peak load");
    case Measure::wear:
        return QObject::tr("Wear");
    default:
        return text(measure_name(measure)).replace(QChar('_'), QChar(' '));
    }
}

QString measure_head(Measure measure, LengthUnit unit) {
    if (measure == Measure::peak_load)
        return QStringLiteral("%1 (%2³/min)").arg(measure_label(measure), text(unit_name(unit)));
    if (!is_length(measure)) return measure_label(measure);
    return QStringLiteral("%1 (%2)").arg(measure_label(measure), text(unit_name(unit)));
}

QString measure_text(Measure measure, double value) {
    if (measure == Measure::machining_time) return duration_text(value);
    if (measure == Measure::uncut_share) return percent_text(value);
    return number_text(value, 4);
}

double measure_typed(Measure measure) {
    constexpr double seconds_per_minute = 60, per_cent = 0.01;
    if (measure == Measure::machining_time) return seconds_per_minute;
    return measure == Measure::uncut_share ? per_cent : 1;
}

QString rung_label(Rung rung) {
    switch (rung) {
    case Rung::estimate:
        return QObject::tr("planned");
    case Rung::coarse:
        return QObject::tr("judged coarsely");
    default:
        return QObject::tr("judged finely");
    }
}

QString standing_label(CandidateStanding standing) {
    switch (standing) {
    case CandidateStanding::winner:
        return QObject::tr("winner");
    case CandidateStanding::front:
        return QObject::tr("front");
    case CandidateStanding::verified:
        return QObject::tr("verified");
    case CandidateStanding::behind:
        return QObject::tr("behind");
    default:
        return QObject::tr("out");
    }
}

} // namespace facetmill::ui
