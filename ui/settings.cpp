#include "ui/settings.h"

#include "ui/text.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace facetmill::ui::settings {

namespace {

constexpr int max_recent_files = 10;
constexpr int max_remembered_units = 200;
constexpr int usual_autosave = 30;
constexpr const char* trackball = "trackball";

/// Paths hold characters that separate groups in setting keys.
QString key_of(const QString& path) {
    return QString::fromLatin1(QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex());
}

} // namespace

QStringList recent_files() {
    return QSettings().value(QStringLiteral("recent_files")).toStringList();
}

void add_recent_file(const QString& path) {
    QStringList all = recent_files();
    all.removeAll(path);
    all.prepend(path);
    while (all.size() > max_recent_files)
        all.removeLast();
    QSettings().setValue(QStringLiteral("recent_files"), all);
}

void remove_recent_file(const QString& path) {
    QStringList all = recent_files();
    all.removeAll(path);
    QSettings().setValue(QStringLiteral("recent_files"), all);
}

std::optional<LengthUnit> remembered_unit(const QString& path) {
    QSettings s;
    s.beginGroup(QStringLiteral("units"));
    return mesh_unit_of(s.value(key_of(path)).toString());
}

void remember_unit(const QString& path, LengthUnit unit) {
    QSettings s;
    s.beginGroup(QStringLiteral("units"));
    if (s.childKeys().size() >= max_remembered_units) s.remove(QString());
    const std::string_view name = unit_name(unit);
    s.setValue(key_of(path), QString::fromLatin1(name.data(), qsizetype(name.size())));
}

UsualProject usual_project() {
    QSettings s;
    s.beginGroup(QStringLiteral("new_project"));
    UsualProject usual{utf8(s.value(QStringLiteral("machine")).toString()),
                       utf8(s.value(QStringLiteral("post")).toString()),
                       mesh_unit_of(s.value(QStringLiteral("unit")).toString())};
    return usual;
}

void set_usual_project(const UsualProject& usual) {
    QSettings s;
    s.beginGroup(QStringLiteral("new_project"));
    s.setValue(QStringLiteral("machine"), text(usual.machine));
    s.setValue(QStringLiteral("post"), text(usual.post));
    s.setValue(QStringLiteral("unit"), usual.unit ? text(unit_name(*usual.unit)) : QString());
}

Navigation navigation() {
    QSettings s;
    s.beginGroup(QStringLiteral("navigation"));
    Navigation n;
    const QString style = s.value(QStringLiteral("style")).toString();
    for (std::size_t i = 0; i < navigation_styles.size(); ++i)
        if (style == QLatin1String(navigation_styles[i])) n.style = NavigationStyle(i);
    if (s.value(QStringLiteral("orbit")).toString() == QLatin1String(trackball)) n.orbit = Orbit::trackball;
    return n;
}

void set_navigation(const Navigation& navigation) {
    QSettings s;
    s.beginGroup(QStringLiteral("navigation"));
    s.setValue(QStringLiteral("style"), QLatin1String(navigation_styles[std::size_t(navigation.style)]));
    s.setValue(QStringLiteral("orbit"),
               navigation.orbit == Orbit::trackball ? QLatin1String(trackball) : QLatin1String("turntable"));
}

bool take_first_start() {
    QSettings s;
    const bool first = !s.value(QStringLiteral("started_before"), false).toBool();
    s.setValue(QStringLiteral("started_before"), true);
    return first;
}

bool perspective() {
    return QSettings().value(QStringLiteral("perspective"), false).toBool();
}

void set_perspective(bool on) {
    QSettings().setValue(QStringLiteral("perspective"), on);
}

std::chrono::seconds autosave_interval() {
    const std::chrono::seconds kept{
        QSettings().value(QStringLiteral("autosave_seconds"), usual_autosave).toInt()};
    return std::clamp(kept, shortest_autosave, longest_autosave);
}

void set_autosave_interval(std::chrono::seconds interval) {
    QSettings().setValue(QStringLiteral("autosave_seconds"), int(interval.count()));
}

int threads() {
    return std::clamp(QSettings().value(QStringLiteral("threads"), 0).toInt(), 0, max_threads);
}

void set_threads(int threads) {
    QSettings().setValue(QStringLiteral("threads"), threads);
}

QString own_folder() {
    return QSettings().value(QStringLiteral("own_folder")).toString();
}

void set_own_folder(const QString& folder) {
    QSettings().setValue(QStringLiteral("own_folder"), folder);
}

QString language() {
    return QSettings().value(QStringLiteral("language")).toString();
}

void set_language(const QString& code) {
    QSettings().setValue(QStringLiteral("language"), code);
}

Theme theme() {
    return theme_from_name(QSettings().value(QStringLiteral("theme")).toString());
}

void set_theme(Theme theme) {
    QSettings().setValue(QStringLiteral("theme"), theme_name(theme));
}

QString last_folder() {
    const QString folder = QSettings().value(QStringLiteral("last_folder")).toString();
    if (!folder.isEmpty() && QDir(folder).exists()) return folder;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void set_last_folder(const QString& folder) {
    QSettings().setValue(QStringLiteral("last_folder"), folder);
}

std::optional<QStringList> shown_layers(const QString& workspace) {
    const QVariant value = QSettings().value(QStringLiteral("layers/") + workspace);
    return value.isValid() ? std::optional(value.toStringList()) : std::nullopt;
}

void set_shown_layers(const QString& workspace, const QStringList& names) {
    QSettings().setValue(QStringLiteral("layers/") + workspace, names);
}

QStringList known_layers() {
    const QVariant value = QSettings().value(QStringLiteral("known_layers"));
    return value.isValid()
               ? value.toStringList()
               : QStringList{QStringLiteral("part"),      QStringLiteral("edges"),   QStringLiteral("stock"),
                             QStringLiteral("deviation"), QStringLiteral("regions"), QStringLiteral("cc"),
                             QStringLiteral("cuts"),      QStringLiteral("links"),   QStringLiteral("rapids"),
                             QStringLiteral("tool"),      QStringLiteral("others")};
}

void set_known_layers(const QStringList& names) {
    QSettings().setValue(QStringLiteral("known_layers"), names);
}

QByteArray window_geometry() {
    return QSettings().value(QStringLiteral("window/geometry")).toByteArray();
}

QByteArray window_state() {
    return QSettings().value(QStringLiteral("window/state")).toByteArray();
}

void set_window(const QByteArray& geometry, const QByteArray& state) {
    QSettings s;
    s.setValue(QStringLiteral("window/geometry"), geometry);
    s.setValue(QStringLiteral("window/state"), state);
}

} // namespace facetmill::ui::settings
