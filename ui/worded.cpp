#include "ui/worded.h"

#include "ui/text.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <utility>
#include <vector>

namespace facetmill::ui {

namespace {

constexpr int deepest = 4; ///< messages in the places of messages
/// A template of so few letters says little: what fills its places is a value or a few words.
constexpr qsizetype few_letters = 7, longest_value = 28;

struct MessageTemplate {
    QString id;
    QStringList between; ///< what stands before, between and behind the places
    qsizetype letters = 0;
};

QStringList between_places(const QString& id) {
    static const QRegularExpression place(QStringLiteral("\\{\\d+\\}"));
    return id.split(place);
}

std::vector<MessageTemplate> read_templates() {
    std::vector<MessageTemplate> all;
    QFile file(QStringLiteral(":/languages/messages.txt"));
    if (!file.open(QIODevice::ReadOnly)) return all;
    const QStringList rows = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    for (QString id : rows) {
        id.replace(QStringLiteral("\\n"), QStringLiteral("\n"));
        id.replace(QStringLiteral("\\\\"), QStringLiteral("\\"));
        MessageTemplate one{id, between_places(id), 0};
        for (const QString& part : one.between)
            one.letters += std::count_if(part.begin(), part.end(), [](QChar c) { return c.isLetter(); });
        all.push_back(std::move(one));
    }
    const auto says = [](const MessageTemplate& m) { return std::pair(m.letters, m.id.size()); };
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return says(a) > says(b); });
    return all;
}

const std::vector<MessageTemplate>& templates() {
    static const std::vector<MessageTemplate> all = read_templates();
    return all;
}

std::optional<QStringList> places_of(const QString& message, const QStringList& between) {
    if (!message.startsWith(between.front()) || !message.endsWith(between.back())) return std::nullopt;
    qsizetype at = between.front().size();
    const qsizetype end = message.size() - between.back().size();
    QStringList filled;
    for (qsizetype i = 1; i + 1 < between.size(); ++i) {
        const qsizetype next = message.indexOf(between[i], at);
        if (next < 0 || next + between[i].size() > end) return std::nullopt;
        filled << message.mid(at, next - at);
        at = next + between[i].size();
    }
    if (at > end) return std::nullopt;
    filled << message.mid(at, end - at);
    return filled;
}

bool says_too_little(const MessageTemplate& one, const QStringList& filled) {
    return one.letters < few_letters && std::any_of(filled.begin(), filled.end(), [](const QString& value) {
               return value.size() > longest_value;
           });
}

/// The template that says most of the text.
const MessageTemplate* template_of(const QString& message, QStringList& filled) {
    for (const MessageTemplate& one : templates())
        if (auto found = places_of(message, one.between); found && !says_too_little(one, *found)) {
            filled = std::move(*found);
            return &one;
        }
    return nullptr;
}

QString in_catalogue(const QString& id) {
    return QCoreApplication::translate("core", utf8(id).c_str());
}

QString with_places(const QString& translation, const QStringList& filled) {
    QString result;
    for (qsizetype i = 0; i < translation.size(); ++i) {
        const qsizetype end =
            translation[i] == QLatin1Char('{') ? translation.indexOf(QLatin1Char('}'), i) : -1;
        bool number = false;
        const int place = end < 0 ? 0 : translation.mid(i + 1, end - i - 1).toInt(&number);
        if (number && place >= 1 && place <= filled.size()) {
            result += filled[place - 1];
            i = end;
        } else {
            result += translation[i];
        }
    }
    return result;
}

/// Whole numbers of so many digits are hard to read without gaps.
constexpr qsizetype long_count = 5;

/// What fills a place, where that is a large count: with gaps.
QString count_said(const QString& filled) {
    bool whole = false;
    const qulonglong n = filled.toULongLong(&whole);
    return whole && filled.size() >= long_count && filled == QString::number(n) ? count_text(n) : filled;
}

bool has_long_count(const QString& message) {
    qsizetype digits = 0;
    return std::any_of(message.begin(), message.end(), [&](QChar c) {
        digits = c.isDigit() ? digits + 1 : 0;
        return digits >= long_count;
    });
}

std::optional<QString> sentence_of(const QString& message, int depth);
QString place_names(const QString& where);

/// Letters of a message that are the catalogue's; 0 where it does not know it.
qsizetype known_letters(const QString& message) {
    if (in_catalogue(message) != message)
        return std::count_if(message.begin(), message.end(), [](QChar c) { return c.isLetter(); });
    QStringList filled;
    const MessageTemplate* found = template_of(message, filled);
    return found ? found->letters : 0;
}

/// What fills a place: a message itself, some of them, or a value.
QString place_said(const QString& filled, int depth) {
    static const QString mark = QStringLiteral("; ");
    QStringList parts = filled.split(mark);
    // A list of messages says more by its items than as the one that its end alone would fit.
    qsizetype known = 0;
    for (const QString& part : parts)
        known += known_letters(part);
    if (parts.size() < 2 || known <= known_letters(filled)) {
        if (auto message = sentence_of(filled, depth)) return *message;
        if (parts.size() < 2) return in_user_numbers(place_names(filled)); // "Rough (1 of 2): Valley 3"
    }
    for (QString& part : parts)
        part = place_said(part, depth + 1);
    return parts.join(clause_mark());
}

std::optional<QString> sentence_of(const QString& message, int depth) {
    if (message.isEmpty() || depth > deepest) return std::nullopt;
    if (QString whole = in_catalogue(message); whole != message) return whole;
    QStringList filled;
    const MessageTemplate* found = template_of(message, filled);
    if (!found) return std::nullopt;
    for (qsizetype i = 0; i < filled.size(); ++i) {
        const bool name = found->between[i].endsWith(QLatin1Char('\''))
                          && found->between[i + 1].startsWith(QLatin1Char('\''));
        if (!name) filled[i] = place_said(filled[i], depth + 1);
        // Lengths stay as they are: they are told in other units after this.
        if (!name && !found->between[i + 1].startsWith(QLatin1String(" mm")))
            filled[i] = count_said(filled[i]);
    }
    return in_user_numbers(with_places(in_catalogue(found->id), filled));
}

QString place_names(const QString& where) {
    QString all;
    for (const QString& part : where.split(QStringLiteral(": "))) {
        const QString said = sentence_of(part, 0).value_or(part);
        all = all.isEmpty() ? said : said_of(all, said);
    }
    return all;
}

/// Where the bracket at the end of a line opens; -1 where none does.
qsizetype last_bracket(const QString& line) {
    if (!line.endsWith(QLatin1Char(')'))) return -1;
    int open = 0;
    for (qsizetype i = line.size() - 1; i > 0; --i) {
        if (line[i] == QLatin1Char(')')) ++open;
        if (line[i] == QLatin1Char('(') && --open == 0) return line[i - 1] == QLatin1Char(' ') ? i : -1;
    }
    return -1;
}

/// Between the places of a line, and what is wrong there.
const QString& place_mark() {
    static const QString mark = QStringLiteral(": ");
    return mark;
}

/// Where the message begins that the catalogue knows most of; behind as many places as can be. -1 where it
/// knows none.
qsizetype message_begin(const QString& head, qsizetype& most) {
    qsizetype begin = -1;
    most = 0;
    for (qsizetype at = 0; at >= 0;) {
        if (const qsizetype known = known_letters(head.mid(at)); known >= most && known > 0) {
            most = known;
            begin = at;
        }
        at = head.indexOf(place_mark(), at);
        if (at >= 0) at += place_mark().size();
    }
    return begin;
}

/// "where: what (what to do)".
QString line_said(const QString& line) {
    const qsizetype bracket = last_bracket(line);
    const QString head = bracket < 0 ? line : line.left(bracket - 1);
    QString tail;
    if (bracket >= 0) {
        const QString inside = line.mid(bracket + 1, line.size() - bracket - 2);
        tail = QStringLiteral(" (%1)").arg(sentence_of(inside, 0).value_or(inside));
    }
    qsizetype most = 0;
    const qsizetype begin = message_begin(head, most);
    if (begin < 0) return head + tail;
    const QString what = sentence_of(head.mid(begin), 0).value_or(head.mid(begin));
    return (begin > 0 ? said_of(place_names(head.left(begin - place_mark().size())), what) : what) + tail;
}

/// Where English is spoken and numbers have a point, all is as core says it.
bool as_core_says() {
    return QLocale().decimalPoint() == QLatin1String(".")
           && in_catalogue(QStringLiteral("the file is empty")) == QLatin1String("the file is empty");
}

} // namespace

std::optional<QStringList> filled_places(const QString& message, const QString& id) {
    return places_of(message, between_places(id));
}

QString message_id(const QString& message) {
    QStringList filled;
    const MessageTemplate* found = template_of(message, filled);
    return found ? found->id : QString();
}

QString worded(const QString& english) {
    if (as_core_says() && !has_long_count(english)) return english;
    const auto sentence = sentence_of(english, 0);
    return in_user_quotes(sentence ? *sentence : line_said(english));
}

QString worded(std::string_view english) {
    return worded(text(english));
}

QString worded(const char* english) {
    return worded(std::string_view(english));
}

QString worded(const Error& e) {
    if (const QString line = text(e.what()); as_core_says() && !has_long_count(line)) return line;
    QString line = worded(printable(e.message(), 4000));
    if (!e.where().empty())
        line = said_of(in_user_quotes(place_names(text(printable(e.where(), 400)))), line);
    if (!e.remedy().empty()) line += QStringLiteral(" (%1)").arg(worded(printable(e.remedy(), 4000)));
    return line;
}

} // namespace facetmill::ui
