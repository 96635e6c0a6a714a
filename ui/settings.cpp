#include "ui/settings.h"

#include "ui/text.h"

#include <QCryptographicHash>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>

namespace facetmill::ui::settings {

namespace {

constexpr int max_recent_files = 10;
constexpr int max_remembered_units = 200;

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
    const QString name = s.value(key_of(path)).toString();
    for (const LengthUnit unit : mesh_units)
        if (name == text(unit_name(unit))) return unit;
    return std::nullopt;
}

void remember_unit(const QString& path, LengthUnit unit) {
    QSettings s;
    s.beginGroup(QStringLiteral("units"));
    if (s.childKeys().size() >= max_remembered_units) s.remove(QString());
    const std::string_view name = unit_name(unit);
    s.setValue(key_of(path), QString::fromLatin1(name.data(), qsizetype(name.size())));
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

std::optional<QStringList> shown_layers() {
    const QVariant value = QSettings().value(QStringLiteral("layers"));
    return value.isValid() ? std::optional(value.toStringList()) : std::nullopt;
}

void set_shown_layers(const QStringList& names) {
    QSettings().setValue(QStringLiteral("layers"), names);
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
