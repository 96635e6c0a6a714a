#include "ui/text.h"

#include "core/base/figures.h"
#include "core/mesh/mesh_format.h"
#include "ui/worded.h"

#include <QLocale>
#include <QObject>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

QString path_text(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

std::filesystem::path path_of(const QString& text) {
    return std::filesystem::path(text.toStdString());
}

namespace {

QString patterns_of(const MeshFormat& format) {
    QStringList patterns;
    for (const std::string_view extension : format.extensions)
        patterns << QLatin1Char('*') + text(extension) << QLatin1Char('*') + text(extension).toUpper();
    return patterns.join(QLatin1Char(' '));
}

} // namespace

QString mesh_patterns() {
    QStringList patterns;
    for (const MeshFormat& format : mesh_formats())
        patterns << patterns_of(format);
    return patterns.join(QLatin1Char(' '));
}

QString mesh_filters() {
    QStringList filters{QObject::tr("Meshes (%1)").arg(mesh_patterns())};
    for (const MeshFormat& format : mesh_formats())
        filters << QStringLiteral("%1 (%2)").arg(worded(format.name), patterns_of(format));
    filters << QObject::tr("All files (*)");
    return filters.join(QStringLiteral(";;"));
}

std::optional<LengthUnit> mesh_unit_of(const QString& name) {
    for (const LengthUnit unit : mesh_units)
        if (name == text(unit_name(unit))) return unit;
    return std::nullopt;
}

QString number_text(double value, int digits) {
    return in_user_numbers(text(format_number(value, digits)));
}

QString in_user_numbers(const QString& text) {
    const QString mark = QLocale().decimalPoint();
    if (mark == QLatin1String(".")) return text;
    static const QRegularExpression point(
        QStringLiteral("(?<![\\w.])(\\d+)\\.(\\d+)(?=(?:e[-+]?\\d+)?(?![\\w.]*\\w))"));
    static const QRegularExpression between(QStringLiteral("(?<=\\d), (?=[-−]?\\d)"));
    QString own = text;
    if (mark == QLatin1String(",")) own.replace(between, QStringLiteral("; "));
    return own.replace(point, QStringLiteral("\\1%1\\2").arg(mark));
}

QString number_list(const QStringList& numbers) {
    return numbers.join(QLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ")
                                                                       : QStringLiteral(", "));
}

QString with_decimal_point(const QString& entered, const std::string& where) {
    const QString own = QLocale().decimalPoint();
    if (own == QLatin1String(".")) return entered;
    static const QRegularExpression two_marks(QStringLiteral("\\d[.,]\\d+[.,]\\d"));
    static const QRegularExpression thousands(
        QStringLiteral("(?<![\\w.,])([1-9]\\d{0,2})\\.(\\d{3})(?![\\w.,])"));
    if (two_marks.match(entered).hasMatch())
        throw Error(ErrorCode::wrong_type, where, utf8(QObject::tr("a number has two marks")),
                    utf8(QObject::tr("write it without marks between thousands")));
    if (const auto match = thousands.match(entered); match.hasMatch())
        throw Error(ErrorCode::wrong_type, where,
                    utf8(QObject::tr("%1 can be read in two ways").arg(match.captured())),
                    utf8(QObject::tr("write %1 or %2")
                             .arg(match.captured(1) + match.captured(2),
                                  match.captured(1) + own + match.captured(2))));
    static const QRegularExpression mark(QStringLiteral("(?<=\\d)%1(?=\\d)|(?<!\\w)%1(?=\\d)")
                                             .arg(QRegularExpression::escape(QStringLiteral(","))));
    return QString(entered).replace(mark, QStringLiteral("."));
}

QString shown_length(double mm, LengthUnit unit, int digits) {
    const QString length = in_user_numbers(text(length_text(mm, unit, digits)));
    const qsizetype gap = length.lastIndexOf(QChar(' '));
    return length.left(gap) + QChar(0x00A0) + length.mid(gap + 1);
}

QString shown_area(double mm2, LengthUnit unit, int digits) {
    constexpr double floor = 1e-4; // of the unit's square
    const double area = mm2 / (mm_per(unit) * mm_per(unit));
    const QString number = area > 0 && area < floor
                               ? in_user_numbers(QStringLiteral("< %1").arg(text(format_number(floor))))
                               : number_text(area, digits);
    return number + QChar(0x00A0) + text(unit_name(unit)) + QChar(0x00B2);
}

QString size_text(const double (&mm)[3], LengthUnit unit, int digits) {
    const auto number = [&](double v) { return number_text(v / mm_per(unit), digits); };
    return QStringLiteral("%1 × %2 × %3 %4")
        .arg(number(mm[0]), number(mm[1]), number(mm[2]), text(unit_name(unit)));
}

QString count_text(std::size_t n) {
    QString digits = QString::number(n);
    for (qsizetype i = digits.size() - 3; i > 0; i -= 3)
        digits.insert(i, QChar(0x202F));
    return digits;
}

QString duration_text(double seconds) {
    if (seconds > 0 && seconds < 0.05) return QObject::tr("less than %1 s").arg(number_text(0.1, 1));
    return in_user_numbers(worded(facetmill::duration_text(seconds)));
}

QString percent_text(double share) {
    return in_user_numbers(text(facetmill::percent_text(share)));
}

QString elided(const QString& text, int characters) {
    if (text.size() <= characters) return text;
    const int left = (characters - 1) / 2, right = characters - 1 - left;
    return text.left(left) + QChar(0x2026) + text.right(right);
}

QString some_of(const QStringList& names, int longest) {
    constexpr qsizetype most = 3;
    QStringList shown;
    for (const QString& name : names.mid(0, most))
        shown << elided(name, longest);
    QString last;
    if (names.size() > most)
        last = QObject::tr("%n more", nullptr, int(names.size() - most));
    else if (names.size() > 1)
        last = shown.takeLast();
    const QString list = shown.join(QStringLiteral(", "));
    return last.isEmpty() ? list : QObject::tr("%1 and %2").arg(list, last);
}

QString said_of(const QString& what, const QString& said) {
    return QObject::tr("%1: %2").arg(what, said);
}

QString with_lengths_in(const QString& message, LengthUnit unit) {
    if (unit == LengthUnit::mm) return message;
    static const QRegularExpression length(QStringLiteral(
        "(?<![\\w.,])(?:< (?=0[.,]0001 ))?(-?\\d+(?:[.,]\\d+)?(?:e[-+]?\\d+)?) mm(?![\\w/²])"));
    QString result;
    qsizetype from = 0;
    for (auto it = length.globalMatch(message); it.hasNext();) {
        const auto match = it.next();
        result += message.mid(from, match.capturedStart() - from);
        const double mm = match.captured(1).replace(QLatin1Char(','), QLatin1Char('.')).toDouble();
        // What is less than the least that is said in one unit is less than that of the other.
        const bool less = match.captured(0).startsWith(QChar('<'));
        // Ten-thousandths of an inch, as one measures; three digits at least.
        constexpr int min_digits = 3, decimals = 4;
        const double size = std::max(std::abs(mm / mm_per(unit)), 1e-9);
        const int digits = std::max(min_digits, int(std::floor(std::log10(size))) + 1 + decimals);
        result += in_user_numbers(text(length_text(less ? mm / 2 : mm, unit, digits)));
        from = match.capturedEnd();
    }
    return result + message.mid(from);
}

QString kept_together(const QString& text) {
    // Digits of a name, "G54 in", are no number.
    static const QRegularExpression gap(
        QStringLiteral("((?<![\\w.,])\\d[\\d.,]*|\\)) "
                       "(?=(?:[%°²³×]|mm|cm|m|in|ft|s|min|h|rpm|U/min|tr/min|[kMG]B)(?!\\w))"));
    return QString(text).replace(gap, QStringLiteral("\\1\u00a0"));
}

QString sentence(const QString& text) {
    if (text.isEmpty()) return text;
    return text.left(1).toUpper() + text.mid(1);
}

QString failure_text(const Error& e) {
    const QString message = sentence(worded(e.message()));
    return e.remedy().empty() ? message : said_of(message, worded(e.remedy()));
}

QString in_user_quotes(const QString& text) {
    // A quote opens behind no letter and closes before none; within it stand apostrophes between letters.
    static const QRegularExpression quoted(QStringLiteral("(?<!\\w)'((?:[^'\n]|(?<=\\w)'(?=\\w))+)'(?!\\w)"),
                                           QRegularExpression::UseUnicodePropertiesOption);
    QString result;
    qsizetype from = 0;
    for (auto it = quoted.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        result += text.mid(from, match.capturedStart() - from)
                  + QObject::tr("'%1'", "a name in a message").arg(match.captured(1));
        from = match.capturedEnd();
    }
    return result + text.mid(from);
}

QString clause_mark() {
    return QObject::tr("; ", "between clauses");
}

} // namespace facetmill::ui
