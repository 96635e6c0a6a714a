// Files that the user asked for, written aside from the window: a disk that does not answer holds up nobody.
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <string>

class QImage;

namespace facetmill::ui {

class Document;

class FileWriting : public QObject {
    Q_OBJECT
public:
    using Work = std::function<void()>;
    /// `wrong`: why it was not written, for the user; empty: it was.
    using Then = std::function<void(const QString& wrong)>;

    /// That of the program.
    static FileWriting& own();
    /// Runs `work` in a thread aside, in the order in which it is handed over, and then, in the window's,
    /// `then` unless `owner` has gone. `work` throws where it fails.
    void start(QObject& owner, Work work, Then then);
    /// Until all that was begun is told.
    bool busy() const { return begun_ > 0; }

signals:
    /// One of them is told.
    void settled();

private:
    int begun_ = 0;
};

/// Writes what `bytes` returns, which is called aside as well: whole or not at all, and never over what the
/// document was read from (keep_files).
void write_file(QObject& owner, const Document& document, const QString& path,
                std::function<std::string()> bytes, FileWriting::Then then);
/// The bytes of a picture's file. Throws Error(empty_result) where there is no picture.
std::string png_bytes(const QImage& picture);

} // namespace facetmill::ui
