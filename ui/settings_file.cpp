#include "ui/settings_file.h"

#include "ui/aside.h"

#include <QSettings>

#include <utility>

namespace facetmill::ui {

namespace {

QMap<QString, QVariant> all_of(const QSettings& file) {
    QMap<QString, QVariant> all;
    for (const QString& key : file.allKeys())
        all.insert(key, file.value(key));
    return all;
}

} // namespace

SettingsFile& SettingsFile::own() {
    // Never destroyed: the thread that writes it may still run when the program ends.
    static auto& file = *new SettingsFile;
    return file;
}

SettingsFile::SettingsFile() {
    QSettings file;
    file.setFallbacksEnabled(false);
    values_ = all_of(file);
}

QVariant SettingsFile::value(const QString& key, const QVariant& otherwise) const {
    const std::lock_guard lock(mutex_);
    return values_.value(key, otherwise);
}

void SettingsFile::set_value(const QString& key, const QVariant& value) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto it = values_.constFind(key); it != values_.constEnd() && *it == value) return;
        values_.insert(key, value);
        changed_.insert(key, value);
    }
    write_aside();
}

QStringList SettingsFile::keys(const QString& beginning) const {
    const std::lock_guard lock(mutex_);
    QStringList found;
    for (auto it = values_.lowerBound(beginning); it != values_.end() && it.key().startsWith(beginning); ++it)
        found << it.key();
    return found;
}

void SettingsFile::remove(const QStringList& keys) {
    {
        const std::lock_guard lock(mutex_);
        for (const QString& key : keys) {
            values_.remove(key);
            changed_.insert(key, QVariant());
        }
    }
    write_aside();
}

void SettingsFile::clear() {
    {
        const std::lock_guard lock(mutex_);
        values_.clear();
        changed_.clear();
        cleared_ = true;
    }
    write_aside();
}

void SettingsFile::read_again() {
    write_aside();
}

void SettingsFile::write_aside() {
    {
        const std::lock_guard lock(mutex_);
        if (std::exchange(writing_, true)) return;
    }
    do_aside([this] { write(); });
}

void SettingsFile::write() {
    QMap<QString, QVariant> changed;
    bool cleared = false;
    {
        const std::lock_guard lock(mutex_);
        writing_ = false;
        changed.swap(changed_);
        cleared = std::exchange(cleared_, false);
    }
    QSettings file;
    file.setFallbacksEnabled(false);
    if (cleared) file.clear();
    for (auto it = changed.constBegin(); it != changed.constEnd(); ++it) {
        if (it->isValid())
            file.setValue(it.key(), *it);
        else
            file.remove(it.key());
    }
    file.sync();
    QMap<QString, QVariant> all = all_of(file);
    const std::lock_guard lock(mutex_);
    if (cleared_) return; // meanwhile
    for (auto it = changed_.constBegin(); it != changed_.constEnd(); ++it) {
        if (it->isValid())
            all.insert(it.key(), *it);
        else
            all.remove(it.key());
    }
    values_.swap(all);
}

} // namespace facetmill::ui
