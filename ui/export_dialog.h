// Programs leave as several files: asks into which folder, and says what will be written and replaced there.
#pragma once

#include "ui/folder_dialog.h"

#include <QStringList>

namespace facetmill::ui {

/// The folder may be one that is not there yet.
class ExportDialog : public FolderDialog {
    Q_OBJECT
public:
    /// `files`: the names of what is written for certain; `endings`: of programs, with the dot.
    ExportDialog(const QString& start, QStringList files, const QStringList& endings,
                 QWidget* parent = nullptr);

private:
    QString trouble() const override;
    QString note() const override;
    QString browsed() override;

    QStringList files_, patterns_;
};

} // namespace facetmill::ui
