// The headless program as a process: what it prints, what it leaves.
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace facetmill::test {

struct CliRun {
    int status = -1;     ///< exit status; -1 when it did not end by itself
    bool killed = false; ///< ended by a signal's default action, as before the program has set its own
    QByteArray out, err;
    int err_lines() const { return int(err.count('\n')); }
    /// "truncated" of "facetmill-cli: error [truncated] ...".
    QByteArray code() const;
};

/// Runs facetmill-cli to its end, at most two minutes.
CliRun run_cli(const QStringList& arguments, const QString& folder);
/// The same, and sends `signal` after `milliseconds` if it still runs then.
CliRun run_cli_and_signal(const QStringList& arguments, const QString& folder, int signal, int milliseconds);

/// A folder of its own for every test.
class Sandbox {
public:
    QString path() const { return dir_.path(); }
    /// Copies the files of a folder below tests/.
    bool copy(const std::string& relative);
    void write(const QString& name, const QByteArray& bytes) const;
    /// Names in a folder of the sandbox, hidden ones too, sorted.
    QStringList files(const QString& relative = ".") const;

private:
    QTemporaryDir dir_;
};

/// The bytes of a file; none where there is no such file.
QByteArray bytes_of(const QString& path);
/// A text as a JSON object; empty where it is none.
QJsonObject json(const QByteArray& text);

} // namespace facetmill::test
