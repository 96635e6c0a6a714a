#include "ui/kept_work.h"

#include "core/base/file.h"
#include "ui/text.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QStandardPaths>

#include <algorithm>

namespace facetmill::ui {

namespace fs = std::filesystem;
using detail::FileLock;

namespace {

constexpr const char* record_ending = ".json";
constexpr const char* lock_ending = ".lock";
constexpr const char* project_ending = ".facetmill";

QString data_folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/autosave");
}

fs::path data_file(const QString& id, const char* ending) {
    return path_of(data_folder() + QChar('/') + id + QLatin1String(ending));
}

/// Names without ending of the files in the data folder that end so.
QStringList ids_with(const char* ending) {
    QStringList ids;
    const QFileInfoList files =
        QDir(data_folder()).entryInfoList({QLatin1Char('*') + QLatin1String(ending)}, QDir::Files);
    for (const QFileInfo& file : files)
        ids << file.completeBaseName();
    return ids;
}

void write_file(const fs::path& path, std::string_view bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

void make_data_folder() {
    const fs::path folder = path_of(data_folder());
    std::error_code ec;
    if (!fs::create_directories(folder, ec) && ec)
        throw Error(ErrorCode::unwritable, folder.string(), "the folder cannot be made: " + ec.message(),
                    "make room or give the right to write there");
    // What is not saved is nobody else's business.
    fs::permissions(folder, fs::perms::owner_all, ec);
}

} // namespace

std::unique_ptr<KeptWork> KeptWork::make() {
    make_data_folder();
    constexpr int attempts = 4; // a number is taken once in a lifetime; more fail where nothing can be locked
    for (int i = 0; i < attempts; ++i) {
        const QString id =
            QStringLiteral("%1").arg(QRandomGenerator::system()->generate(), 8, 16, QChar('0'));
        if (fs::exists(data_file(id, record_ending))) continue;
        if (FileLock lock(data_file(id, lock_ending), FileLock::Open::or_make); lock)
            return std::unique_ptr<KeptWork>(new KeptWork(id, std::move(lock)));
    }
    throw Error(ErrorCode::unwritable, utf8(data_folder()), "no file can be locked there",
                "give the right to write there");
}

std::vector<std::unique_ptr<KeptWork>> KeptWork::abandoned() {
    std::vector<std::unique_ptr<KeptWork>> all;
    const QStringList records = ids_with(record_ending);
    for (const QString& id : records) {
        FileLock lock(data_file(id, lock_ending), FileLock::Open::or_make);
        if (!lock) continue;
        std::unique_ptr<KeptWork> work(new KeptWork(id, std::move(lock)));
        if (!work->read_record()) continue; // its project is nevertheless there for whoever looks
        if (work->file().empty())
            work->remove();
        else
            all.push_back(std::move(work));
    }
    // Of windows that were killed before they kept anything.
    const QStringList locks = ids_with(lock_ending);
    for (const QString& id : locks)
        if (!fs::exists(data_file(id, record_ending)))
            if (const FileLock lock(data_file(id, lock_ending)); lock) {
                std::error_code ec;
                fs::remove(data_file(id, lock_ending), ec);
            }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a->when() > b->when(); });
    return all;
}

KeptWork::~KeptWork() {
    if (recorded_) return; // for whoever looks next
    std::error_code ec;
    fs::remove(in_data_folder(lock_ending), ec); // while it is locked: nobody else can hold it
}

fs::path KeptWork::in_data_folder(const char* ending) const {
    return data_file(id_, ending);
}

fs::path KeptWork::beside_project() const {
    if (project_.empty()) return {};
    fs::path path = project_;
    return path.replace_filename(project_.stem().string() + ".autosave-" + utf8(id_) + project_ending);
}

void KeptWork::write(const Project& project, const QString& name) {
    if (recorded_ && project.path != project_) remove();
    if (!recorded_ || name != name_) {
        project_ = project.path;
        name_ = name;
        make_data_folder();
        // Before the project: a record that leads to nothing is recognized, a project without one is not.
        write_record();
        recorded_ = true;
    }
    const std::string bytes = project_to_json(project);
    std::error_code ec;
    if (const fs::path beside = beside_project(); !beside.empty()) {
        try {
            write_file(beside, bytes);
            if (const fs::file_status status = fs::status(project_, ec); fs::exists(status))
                fs::permissions(beside, status.permissions() | fs::perms::owner_write, ec);
            fs::remove(in_data_folder(project_ending), ec); // of a time when there was no place for it here
            return;
        } catch (const Error&) {
            // The user's own folder may take it.
        }
    }
    write_file(in_data_folder(project_ending), bytes);
}

Project KeptWork::read() const {
    Project project = load_project(file());
    project.path = project_;
    return project;
}

void KeptWork::remove() noexcept {
    try {
        std::error_code ec;
        if (!project_.empty()) fs::remove(beside_project(), ec);
        // The record goes behind what it leads to.
        for (const char* ending : {project_ending, record_ending})
            fs::remove(in_data_folder(ending), ec);
    } catch (const std::exception&) {
        return; // it is offered once more
    }
    recorded_ = false;
}

fs::path KeptWork::file() const {
    fs::path newest;
    fs::file_time_type time;
    for (const fs::path& path : {beside_project(), in_data_folder(project_ending)}) {
        std::error_code ec;
        const fs::file_time_type written = fs::last_write_time(path, ec);
        if (ec || (!newest.empty() && written <= time)) continue;
        newest = path;
        time = written;
    }
    return newest;
}

QDateTime KeptWork::when() const {
    return QFileInfo(path_text(file())).lastModified();
}

bool KeptWork::read_record() {
    try {
        const InputFile file(in_data_folder(record_ending));
        const QByteArray bytes(file.bytes().data(), qsizetype(file.bytes().size()));
        const QJsonObject record = QJsonDocument::fromJson(bytes).object();
        if (!record.contains(QStringLiteral("project"))) return false;
        project_ = path_of(record.value(QStringLiteral("project")).toString());
        name_ = record.value(QStringLiteral("name")).toString();
    } catch (const Error&) {
        return false;
    }
    recorded_ = true;
    return true;
}

void KeptWork::write_record() const {
    const QJsonObject record{{QStringLiteral("project"), path_text(project_)},
                             {QStringLiteral("name"), name_}};
    const QByteArray bytes = QJsonDocument(record).toJson();
    write_file(in_data_folder(record_ending), {bytes.constData(), std::size_t(bytes.size())});
}

} // namespace facetmill::ui
