#include "ui/settings.h"

#include "ui/settings_file.h"
#include "ui/text.h"

#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

#include <algorithm>

namespace facetmill::ui::settings {

namespace {

constexpr int max_recent_files = 10;
constexpr int max_remembered_units = 200;
constexpr int usual_autosave = 30;
const QLatin1String units_group("units/");
constexpr const char* trackball = "trackball";

/// Paths hold characters that separate groups in setting keys.
QString key_of(const QString& path) {
    return QString::fromLatin1(QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex());
}

SettingsFile& kept() {
    return SettingsFile::own();
}

} // namespace

QStringList recent_files() {
    return kept().value(QStringLiteral("recent_files")).toStringList();
}

void add_recent_file(const QString& path) {
    QStringList all = recent_files();
    all.removeAll(path);
    all.prepend(path);
    while (all.size() > max_recent_files)
        all.removeLast();
    kept().set_value(QStringLiteral("recent_files"), all);
}

void remove_recent_file(const QString& path) {
    QStringList all = recent_files();
    all.removeAll(path);
    kept().set_value(QStringLiteral("recent_files"), all);
}

std::optional<LengthUnit> remembered_unit(const QString& path) {
    return mesh_unit_of(kept().value(units_group + key_of(path)).toString());
}

void remember_unit(const QString& path, LengthUnit unit) {
    if (const QStringList known = kept().keys(units_group); known.size() >= max_remembered_units)
        kept().remove(known);
    const std::string_view name = unit_name(unit);
    kept().set_value(units_group + key_of(path), QString::fromLatin1(name.data(), qsizetype(name.size())));
}

UsualProject usual_project() {
    UsualProject usual{utf8(kept().value(QStringLiteral("new_project/machine")).toString()),
                       utf8(kept().value(QStringLiteral("new_project/post")).toString()),
                       mesh_unit_of(kept().value(QStringLiteral("new_project/unit")).toString())};
    return usual;
}

void set_usual_project(const UsualProject& usual) {
    kept().set_value(QStringLiteral("new_project/machine"), text(usual.machine));
    kept().set_value(QStringLiteral("new_project/post"), text(usual.post));
    kept().set_value(QStringLiteral("new_project/unit"),
                     usual.unit ? text(unit_name(*usual.unit)) : QString());
}

Navigation navigation() {
    Navigation n;
    const QString style = kept().value(QStringLiteral("navigation/style")).toString();
    for (std::size_t i = 0; i < navigation_styles.size(); ++i)
        if (style == QLatin1String(navigation_styles[i])) n.style = NavigationStyle(i);
    if (kept().value(QStringLiteral("navigation/orbit")).toString() == QLatin1String(trackball))
        n.orbit = Orbit::trackball;
    return n;
}

void set_navigation(const Navigation& navigation) {
    kept().set_value(QStringLiteral("navigation/style"),
                     QLatin1String(navigation_styles[std::size_t(navigation.style)]));
    kept().set_value(QStringLiteral("navigation/orbit"), navigation.orbit == Orbit::trackball
                                                             ? QLatin1String(trackball)
                                                             : QLatin1String("turntable"));
}

bool take_first_start() {
    const bool first = !kept().value(QStringLiteral("started_before"), false).toBool();
    kept().set_value(QStringLiteral("started_before"), true);
    return first;
}

bool perspective() {
    return kept().value(QStringLiteral("perspective"), false).toBool();
}

void set_perspective(bool on) {
    kept().set_value(QStringLiteral("perspective"), on);
}

std::chrono::seconds autosave_interval() {
    const std::chrono::seconds seconds{
        kept().value(QStringLiteral("autosave_seconds"), usual_autosave).toInt()};
    return std::clamp(seconds, shortest_autosave, longest_autosave);
}

void set_autosave_interval(std::chrono::seconds interval) {
    kept().set_value(QStringLiteral("autosave_seconds"), int(interval.count()));
}

int threads() {
    return std::clamp(kept().value(QStringLiteral("threads"), 0).toInt(), 0, max_threads);
}

void set_threads(int threads) {
    kept().set_value(QStringLiteral("threads"), threads);
}

QString own_folder() {
    return kept().value(QStringLiteral("own_folder")).toString();
}

void set_own_folder(const QString& folder) {
    kept().set_value(QStringLiteral("own_folder"), folder);
}

QString language() {
    return kept().value(QStringLiteral("language")).toString();
}

void set_language(const QString& code) {
    kept().set_value(QStringLiteral("language"), code);
}

Theme theme() {
    return theme_from_name(kept().value(QStringLiteral("theme")).toString());
}

void set_theme(Theme theme) {
    kept().set_value(QStringLiteral("theme"), theme_name(theme));
}

QString last_folder() {
    const QString folder = kept().value(QStringLiteral("last_folder")).toString();
    if (!folder.isEmpty() && QDir(folder).exists()) return folder;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void set_last_folder(const QString& folder) {
    kept().set_value(QStringLiteral("last_folder"), folder);
}

std::optional<QStringList> shown_layers(const QString& workspace) {
    const QVariant value = kept().value(QStringLiteral("layers/") + workspace);
    return value.isValid() ? std::optional(value.toStringList()) : std::nullopt;
}

void set_shown_layers(const QString& workspace, const QStringList& names) {
    kept().set_value(QStringLiteral("layers/") + workspace, names);
}

QStringList known_layers() {
    const QVariant value = kept().value(QStringLiteral("known_layers"));
    return value.isValid()
               ? value.toStringList()
               : QStringList{QStringLiteral("part"),      QStringLiteral("edges"),   QStringLiteral("stock"),
                             QStringLiteral("deviation"), QStringLiteral("regions"), QStringLiteral("cc"),
                             QStringLiteral("cuts"),      QStringLiteral("links"),   QStringLiteral("rapids"),
                             QStringLiteral("tool"),      QStringLiteral("others")};
}

void set_known_layers(const QStringList& names) {
    kept().set_value(QStringLiteral("known_layers"), names);
}

QByteArray window_geometry() {
    return kept().value(QStringLiteral("window/geometry")).toByteArray();
}

QByteArray window_state() {
    return kept().value(QStringLiteral("window/state")).toByteArray();
}

void set_window(const QByteArray& geometry, const QByteArray& state) {
    kept().set_value(QStringLiteral("window/geometry"), geometry);
    kept().set_value(QStringLiteral("window/state"), state);
}

} // namespace facetmill::ui::settings
