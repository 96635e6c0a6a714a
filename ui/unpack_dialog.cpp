#include "ui/unpack_dialog.h"

#include "ui/text.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace facetmill::ui {

namespace {

/// A folder in `place` that is not there yet.
QString new_folder_in(const QString& place, const std::filesystem::path& packed) {
    const QString start = place + QChar('/') + path_text(packed.stem());
    QString folder = start;
    // A link that leads nowhere is there as well.
    const auto is_there = [](const QString& path) {
        return QFileInfo::exists(path) || QFileInfo(path).isSymLink();
    };
    for (int n = 2; is_there(folder); ++n)
        folder = start + QStringLiteral("-%1").arg(n);
    return QDir::cleanPath(folder);
}

} // namespace

UnpackDialog::UnpackDialog(const std::filesystem::path& packed, QWidget* parent)
    : FolderDialog(QStringLiteral("unpack"), parent), packed_(packed) {
    setWindowTitle(tr("Unpack project"));
    build({tr("<b>%1</b> is a packed project. It is unpacked into a folder of its own and "
              "opened from there; the packed file stays as it is.")
               .arg(elided(path_text(packed.filename()), 48).toHtmlEscaped()),
           path_text(packed), tr("Choose the folder in which the new one is made"), tr("&Unpack")},
          new_folder_in(path_text(packed.parent_path()), packed));
}

QString UnpackDialog::browsed() {
    const QString place =
        QFileDialog::getExistingDirectory(this, tr("Unpack in"), path_text(packed_.parent_path()));
    return place.isEmpty() ? place : new_folder_in(place, packed_);
}

QString UnpackDialog::trouble() const {
    const bool full =
        QFileInfo(typed()).isDir()
        && !QDir(typed()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    return full ? tr("The folder is not empty: write the name of a new one.") : QString();
}

} // namespace facetmill::ui
