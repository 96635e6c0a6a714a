#include "ui/folder_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace facetmill::ui {

FolderDialog::FolderDialog(const QString& name, QWidget* parent) : QDialog(parent), name_(name) {
    setObjectName(name + QStringLiteral("_dialog"));
}

void FolderDialog::build(const Words& words, const QString& start) {
    auto* question = new QLabel(words.question, this);
    question->setWordWrap(true);
    question->setToolTip(words.question_tip);
    auto* label = new QLabel(tr("&Folder"), this);
    folder_ = new QLineEdit(QDir::toNativeSeparators(start), this);
    folder_->setObjectName(name_ + QStringLiteral("_folder"));
    label->setBuddy(folder_);
    auto* browse_button = new QPushButton(tr("&Browse…"), this);
    browse_button->setToolTip(words.browse_tip);
    browse_button->setAutoDefault(false);
    said_ = new QLabel(this);
    said_->setObjectName(name_ + QStringLiteral("_trouble"));
    said_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    accept_ = buttons->addButton(words.accept, QDialogButtonBox::AcceptRole);
    accept_->setObjectName(name_);
    accept_->setDefault(true);
    connect(browse_button, &QPushButton::clicked, this, &FolderDialog::browse);
    connect(folder_, &QLineEdit::textChanged, this, &FolderDialog::judge);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(folder_, 1);
    line->addWidget(browse_button);
    auto* column = new QVBoxLayout(this);
    column->addWidget(question);
    column->addLayout(line);
    column->addWidget(said_);
    column->addSpacing(6);
    column->addWidget(buttons);
    setMinimumWidth(560);
    judge();
}

QString FolderDialog::typed() const {
    return QDir::fromNativeSeparators(folder_->text().trimmed());
}

QString FolderDialog::folder() const {
    return QFileInfo(typed()).absoluteFilePath();
}

void FolderDialog::browse() {
    if (const QString found = browsed(); !found.isEmpty()) folder_->setText(QDir::toNativeSeparators(found));
}

void FolderDialog::judge() {
    const QFileInfo info(typed());
    QString wrong;
    if (typed().isEmpty() || info.isRelative())
        wrong = tr("Write the whole path of a folder.");
    else if ((info.exists() || info.isSymLink()) && !info.isDir())
        wrong = tr("There is a file of this name: write another one.");
    else
        wrong = trouble();
    const QString said = wrong.isEmpty() ? note() : wrong;
    said_->setText(said);
    said_->setVisible(!said.isEmpty());
    accept_->setEnabled(wrong.isEmpty());
}

} // namespace facetmill::ui
