#include "ui/unpack_dialog.h"

#include "ui/text.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

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
    return QDir::toNativeSeparators(QDir::cleanPath(folder));
}

} // namespace

UnpackDialog::UnpackDialog(const std::filesystem::path& packed, QWidget* parent)
    : QDialog(parent), packed_(packed) {
    setObjectName(QStringLiteral("unpack_dialog"));
    setWindowTitle(tr("Unpack project"));
    const QString file = path_text(packed.filename());
    auto* question =
        new QLabel(tr("<b>%1</b> is a packed project. It is unpacked into a folder of its own and "
                      "opened from there; the packed file stays as it is.")
                       .arg(elided(file, 48).toHtmlEscaped()),
                   this);
    question->setWordWrap(true);
    question->setToolTip(path_text(packed));
    auto* label = new QLabel(tr("&Folder"), this);
    folder_ = new QLineEdit(new_folder_in(path_text(packed.parent_path()), packed), this);
    folder_->setObjectName(QStringLiteral("unpack_folder"));
    label->setBuddy(folder_);
    auto* browse_button = new QPushButton(tr("&Browse…"), this);
    browse_button->setToolTip(tr("Choose the folder in which the new one is made"));
    browse_button->setAutoDefault(false);
    trouble_ = new QLabel(this);
    trouble_->setObjectName(QStringLiteral("unpack_trouble"));
    trouble_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    unpack_ = buttons->addButton(tr("&Unpack"), QDialogButtonBox::AcceptRole);
    unpack_->setObjectName(QStringLiteral("unpack"));
    unpack_->setDefault(true);
    connect(browse_button, &QPushButton::clicked, this, &UnpackDialog::browse);
    connect(folder_, &QLineEdit::textChanged, this, &UnpackDialog::judge);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(folder_, 1);
    line->addWidget(browse_button);
    auto* column = new QVBoxLayout(this);
    column->addWidget(question);
    column->addLayout(line);
    column->addWidget(trouble_);
    column->addSpacing(6);
    column->addWidget(buttons);
    setMinimumWidth(560);
    judge();
}

QString UnpackDialog::folder() const {
    return QFileInfo(QDir::fromNativeSeparators(folder_->text().trimmed())).absoluteFilePath();
}

void UnpackDialog::browse() {
    const QString place =
        QFileDialog::getExistingDirectory(this, tr("Unpack in"), path_text(packed_.parent_path()));
    if (!place.isEmpty()) folder_->setText(new_folder_in(place, packed_));
}

void UnpackDialog::judge() {
    const QString text = QDir::fromNativeSeparators(folder_->text().trimmed());
    const QFileInfo info(text);
    QString trouble;
    if (text.isEmpty() || info.isRelative())
        trouble = tr("Write the whole path of a folder.");
    else if ((info.exists() || info.isSymLink()) && !info.isDir())
        trouble = tr("There is a file of this name: write another one.");
    else if (info.isDir()
             && !QDir(text).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot))
        trouble = tr("The folder is not empty: write the name of a new one.");
    trouble_->setText(trouble);
    unpack_->setEnabled(trouble.isEmpty());
}

} // namespace facetmill::ui
