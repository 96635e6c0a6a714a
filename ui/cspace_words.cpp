#include "ui/cspace_words.h"

#include "ui/language.h"
#include "ui/text.h"
#include "ui/worded.h"
#include "viz/cspace_display.h"

#include <QObject>

#include <cmath>

namespace facetmill::ui {

QString posture_angle_text(double radians) {
    return in_user_numbers(QString::number(degrees(radians), 'f', 1)).replace(QChar('-'), QChar(0x2212))
           + QChar(0x00B0);
}

QString lift_text(double mm, LengthUnit unit) {
    return QStringLiteral("%1 %2").arg(
        in_user_numbers(QString::number(mm / mm_per(unit), 'f', unit == LengthUnit::inch ? 4 : 3)),
        text(unit_name(unit)));
}

QString posture_reason_text(const FiveAxisStudy& study, const FiveAxisStudy::Point& point,
                            const PostureValue& posture, bool with_lift, LengthUnit unit) {
    const auto reason = study.reason(point, posture.lead, posture.yaw);
    QString line =
        QObject::tr("lead %1, yaw %2").arg(posture_angle_text(posture.lead), posture_angle_text(posture.yaw));
    if (with_lift) line += QObject::tr(", lift %1").arg(lift_text(posture.delta, unit));
    line = said_of(line, in_a_sentence(worded(posture_block_label(reason.block))));
    if (reason.block != PostureBlock::free && reason.contact.body != ToolBody::none
        && reason.contact.facet != no_index)
        line += QObject::tr(", facet %1").arg(count_text(reason.contact.facet));
    const auto limit = [&](double v) {
        return std::isfinite(v) ? lift_text(v, unit) : QString(v > 0 ? QChar(0x221E) : QChar(0x2013));
    };
    line += QObject::tr("; lowest lift %1, highest %2").arg(limit(reason.bottom), limit(reason.top));
    return line;
}

} // namespace facetmill::ui
