#include "ui/language.h"

#include "ui/text.h"
#include "ui/worded.h"
#include "viz/overlay_words.h"

#include <QCoreApplication>
#include <QTranslator>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

/// Outside of namespaces, as the macro asks.
static void init_language_files() {
    Q_INIT_RESOURCE(languages);
}

namespace facetmill::ui {

namespace {

constexpr std::array all_languages{Language{"en", "English"}, Language{"de", "Deutsch"},
                                   Language{"fr", "Français"}};

/// Texts of the windows stand in one context, whichever class asks for them; those of core in another.
class Catalogue : public QTranslator {
public:
    using QTranslator::QTranslator;
    QString translate(const char* context, const char* source, const char* comment, int n) const override {
        const QLatin1String asked(context ? context : "");
        if (asked == QLatin1String("core")) return QTranslator::translate("core", source, comment, n);
        // Qt's own classes; what functions of ours ask for without a class comes as QObject's.
        if (asked.startsWith(QLatin1Char('Q')) && asked != QLatin1String("QObject")
            && asked != QLatin1String("QMenu"))
            return {};
        return QTranslator::translate("facetmill", source, comment, n);
    }
};

struct Spoken {
    QString code = QStringLiteral("en");
    std::unique_ptr<QTranslator> texts, qt;
};

Spoken& spoken() {
    static auto* now = new Spoken; // outlives the application
    return *now;
}

void install(std::unique_ptr<QTranslator>& place, std::unique_ptr<QTranslator> translator) {
    if (place) QCoreApplication::removeTranslator(place.get());
    place = std::move(translator);
    if (place) QCoreApplication::installTranslator(place.get());
}

std::unique_ptr<QTranslator> loaded(std::unique_ptr<QTranslator> translator, const QString& file) {
    if (!translator->load(file)) translator.reset();
    return translator;
}

void write_numbers(QLocale locale) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    QLocale::setDefault(locale);
    set_overlay_words(said_in_view);
}

bool is_known(const QString& code) {
    return std::any_of(all_languages.begin(), all_languages.end(),
                       [&](const Language& l) { return code == QLatin1String(l.code); });
}

} // namespace

std::span<const Language> languages() {
    return all_languages;
}

QString language_for(const QString& wanted) {
    if (is_known(wanted)) return wanted;
    for (const QString& name : QLocale::system().uiLanguages())
        if (const QString code = name.section(QLatin1Char('-'), 0, 0); is_known(code)) return code;
    return QStringLiteral("en");
}

QLocale number_locale(const QString& wanted) {
    const QLocale system = QLocale::system();
    if (wanted.isEmpty() || system.name().section(QLatin1Char('_'), 0, 0) == wanted) return system;
    return wanted == QLatin1String("en") ? QLocale::c() : QLocale(wanted);
}

void speak(const QString& wanted) {
    init_language_files();
    const QString code = language_for(wanted);
    const auto file = [&](const char* name) {
        return QStringLiteral(":/languages/%1_%2.qm").arg(QLatin1String(name), code);
    };
    // The last one is asked first.
    install(spoken().qt, loaded(std::make_unique<QTranslator>(), file("qtbase")));
    install(spoken().texts, loaded(std::make_unique<Catalogue>(), file("facetmill")));
    spoken().code = code;
    write_numbers(number_locale(wanted));
}

void speak_by(std::unique_ptr<QTranslator> texts, const QLocale& numbers) {
    init_language_files();
    install(spoken().qt, nullptr);
    install(spoken().texts, std::move(texts));
    spoken().code.clear();
    write_numbers(numbers);
}

QString spoken_language() {
    return spoken().code;
}

std::string said_in_view(const std::string& english) {
    const QString whole = text(english), said = worded(whole);
    if (!whole.contains(QStringLiteral(", "))) return utf8(in_user_numbers(said));
    // "CM2, planned", "Lift, in"; of "Chosen: CM2, planned" a message takes the end as it is.
    QStringList words = said.split(QStringLiteral(", "));
    for (qsizetype i = said == whole ? 0 : 1; i < words.size(); ++i)
        words[i] = worded(words[i]);
    return utf8(in_user_numbers(words.join(QStringLiteral(", "))));
}

QString in_a_sentence(const QString& label) {
    return spoken_language() == QLatin1String("de") ? label : label.left(1).toLower() + label.mid(1);
}

} // namespace facetmill::ui
