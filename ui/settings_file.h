// The user's settings as the window has them: in memory. The file is written aside, because writing one waits
// for the disk.
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
#include <QVariant>

#include <mutex>

namespace facetmill::ui {

/// May be used by all threads.
class SettingsFile {
public:
    /// That of the application's names (QCoreApplication), read at the first call.
    static SettingsFile& own();

    QVariant value(const QString& key, const QVariant& otherwise = {}) const;
    void set_value(const QString& key, const QVariant& value);
    /// Keys that begin so.
    QStringList keys(const QString& beginning) const;
    void remove(const QStringList& keys);
    /// As in a program that was never started.
    void clear();
    /// Takes up what other windows have written since, aside.
    void read_again();

private:
    SettingsFile();
    void write_aside();
    void write();

    mutable std::mutex mutex_;
    QMap<QString, QVariant> values_, changed_; ///< changed: still to be written; invalid: removed
    bool cleared_ = false;                     ///< all that the file has goes before that
    bool writing_ = false;                     ///< is asked for
};

} // namespace facetmill::ui
