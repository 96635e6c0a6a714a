#include "ui/export_dialog.h"

#include "ui/text.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace facetmill::ui {

ExportDialog::ExportDialog(const QString& start, QStringList files, const QStringList& endings,
                           QWidget* parent)
    : FolderDialog(QStringLiteral("export"), parent), files_(std::move(files)) {
    for (const QString& ending : endings)
        patterns_ << QLatin1Char('*') + ending;
    setWindowTitle(tr("Export programs"));
    build({tr("The programs and their report are written into a folder: %1.")
               .arg(some_of(files_).toHtmlEscaped()),
           files_.join(QLatin1Char('\n')), tr("Choose a folder that is there"), tr("&Export")},
          start);
}

QString ExportDialog::browsed() {
    return QFileDialog::getExistingDirectory(this, tr("Export programs into"), folder());
}

QString ExportDialog::trouble() const {
    const QFileInfo info(typed());
    return info.isDir() && !info.isWritable()
               ? tr("Nothing can be written into this folder: choose another one.")
               : QString();
}

QString ExportDialog::note() const {
    if (!QFileInfo::exists(typed())) return tr("The folder is made.");
    QStringList replaced, others;
    for (const QString& name : QDir(typed()).entryList(patterns_ + files_, QDir::Files))
        (files_.contains(name) ? replaced : others) << name;
    QStringList notes;
    if (!replaced.isEmpty()) notes << tr("Replaced there: %1.").arg(some_of(replaced));
    if (!others.isEmpty()) notes << tr("Of earlier jobs there: %1.").arg(some_of(others));
    return notes.join(QLatin1Char(' '));
}

} // namespace facetmill::ui
