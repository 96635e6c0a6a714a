#include "tests/golden/run_cli.h"

#include "tests/support/test_runner.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>

#include <csignal>

namespace facetmill::test {

namespace {

constexpr int longest_run = 120'000; // milliseconds

CliRun finish(QProcess& process) {
    CliRun run;
    if (!process.waitForFinished(longest_run)) {
        process.kill();
        process.waitForFinished();
    } else if (process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    } else {
        run.killed = process.exitCode() == SIGINT || process.exitCode() == SIGTERM; // not a crash
    }
    run.out = process.readAllStandardOutput();
    run.err = process.readAllStandardError();
    return run;
}

void start(QProcess& process, const QStringList& arguments, const QString& folder) {
    process.setWorkingDirectory(folder);
    process.start(FACETMILL_CLI, arguments);
    if (!process.waitForStarted()) qFatal("facetmill-cli does not start");
}

} // namespace

QByteArray CliRun::code() const {
    const QByteArray head = "facetmill-cli: error [";
    return err.startsWith(head) ? err.mid(head.size(), err.indexOf(']') - head.size()) : QByteArray();
}

CliRun run_cli(const QStringList& arguments, const QString& folder) {
    QProcess process;
    start(process, arguments, folder);
    return finish(process);
}

CliRun run_cli_and_signal(const QStringList& arguments, const QString& folder, int signal, int milliseconds) {
    QProcess process;
    start(process, arguments, folder);
    if (!process.waitForFinished(milliseconds)) ::kill(pid_t(process.processId()), signal);
    return finish(process);
}

QByteArray bytes_of(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject json(const QByteArray& text) {
    return QJsonDocument::fromJson(text).object();
}

bool Sandbox::copy(const std::string& relative) {
    const QDir from(QString::fromStdString(data_path(relative)));
    bool copied = !from.isEmpty();
    for (const QString& name : from.entryList(QDir::Files))
        copied = copied && QFile::copy(from.filePath(name), path() + "/" + name);
    return copied;
}

void Sandbox::write(const QString& name, const QByteArray& bytes) const {
    QFile file(path() + "/" + name);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("the sandbox cannot be written");
}

QStringList Sandbox::files(const QString& relative) const {
    return QDir(path() + "/" + relative)
        .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot, QDir::Name);
}

} // namespace facetmill::test
