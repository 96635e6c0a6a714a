#include "ui/recent_pictures.h"

#include "core/base/file.h"
#include "ui/aside.h"
#include "ui/main_window.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

namespace facetmill::ui {

namespace {

QDir folder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent"));
}

QString name_of(const QString& path) {
    const QByteArray hash = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1);
    return QString::fromLatin1(hash.toHex()) + QStringLiteral(".png");
}

void forget_others() {
    QStringList kept;
    for (const QString& path : settings::recent_files())
        kept << name_of(path);
    for (const QString& file : folder().entryList({QStringLiteral("*.png")}, QDir::Files))
        if (!kept.contains(file)) folder().remove(file);
}

void write_picture_of(const QString& path, const QImage& view) {
    const QSize size(recent_picture_width, recent_picture_height);
    const QImage whole = view.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QImage middle = whole.copy((whole.width() - size.width()) / 2, (whole.height() - size.height()) / 2,
                                     size.width(), size.height());
    QBuffer buffer;
    if (!folder().mkpath(QStringLiteral(".")) || !buffer.open(QIODevice::WriteOnly)
        || !middle.save(&buffer, "PNG"))
        return;
    try {
        OutputFile file(path_of(folder().filePath(name_of(path))));
        file.write({buffer.data().constData(), std::size_t(buffer.data().size())});
        file.commit();
        forget_others();
    } catch (const Error&) {
        // The list shows a plain icon then.
    }
}

} // namespace

void keep_recent_picture(const QString& path, const QImage& view) {
    if (view.isNull() || !settings::recent_files().contains(path)) return;
    do_aside([path, view] { write_picture_of(path, view); });
}

QPixmap recent_picture(const QString& path) {
    return QPixmap(folder().filePath(name_of(path)));
}

RecentPictures::RecentPictures(const Document& document, Viewport& viewport, MainWindow& window)
    : QObject(&window), document_(document), viewport_(viewport) {
    // A window settles after every picture: only what is new is looked at.
    const auto changed = [this] { due_ = true; };
    connect(&document_, &Document::part_changed, this, changed);
    connect(&document_, &Document::states_changed, this, changed);
    connect(&document_, &Document::modified_changed, this, changed); // saved under another name
    connect(&window, &MainWindow::settled, this, &RecentPictures::keep);
}

void RecentPictures::keep() {
    if (!document_.part() || !viewport_.isVisible() || !std::exchange(due_, false)) return;
    const Project& project = document_.project();
    const std::filesystem::path file = project.path.empty() ? project.part_path() : project.path;
    const bool planned = document_.all_planned();
    if (std::exchange(last_, {file, planned}) == std::pair(file, planned)) return;
    keep_recent_picture(path_text(file), viewport_.picture());
}

} // namespace facetmill::ui
