#include "ui/file_writing.h"

#include "core/base/file.h"
#include "ui/aside.h"
#include "ui/document.h"
#include "ui/export.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QBuffer>
#include <QImage>
#include <QPointer>

#include <exception>
#include <memory>
#include <utility>

namespace facetmill::ui {

FileWriting& FileWriting::own() {
    // Never destroyed: its thread may tell it something until the program has ended.
    static auto& own = *new FileWriting;
    return own;
}

void FileWriting::start(QObject& owner, Work work, Then then) {
    ++begun_;
    const auto wrong = std::make_shared<QString>();
    // Called, and freed, in the window's thread, where the owner may go.
    const auto tell = std::make_shared<std::function<void()>>(
        [this, wrong, then = std::move(then), guard = QPointer<QObject>(&owner)] {
            --begun_;
            if (guard) then(*wrong);
            emit settled();
        });
    do_aside([this, wrong, tell, work = std::move(work)]() mutable {
        try {
            work();
        } catch (const std::exception& e) {
            *wrong = worded(std::string_view(e.what()));
        }
        work = nullptr;
        QMetaObject::invokeMethod(
            this, [told = std::move(tell)] { (*told)(); }, Qt::QueuedConnection);
    });
}

void write_file(QObject& owner, const Document& document, const QString& path,
                std::function<std::string()> bytes, FileWriting::Then then) {
    FileWriting::own().start(
        owner,
        [project = std::make_shared<const Project>(document.project()), program = document.program(),
         target = path_of(path), bytes = std::move(bytes)] {
            const std::string content = bytes();
            keep_files(*project, program.get(), target);
            OutputFile file(target);
            file.write(content);
            file.commit();
        },
        std::move(then));
}

std::string png_bytes(const QImage& picture) {
    // In memory first: Qt's writer of pictures does not say that the disk was full.
    QByteArray png;
    QBuffer buffer(&png);
    if (picture.isNull() || !buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
        throw Error(ErrorCode::empty_result, "picture", "there is no picture to write", "");
    return png.toStdString();
}

} // namespace facetmill::ui
