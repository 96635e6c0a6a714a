#include "ui/suggest_dialog.h"

#include "ui/text.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr QSize card_picture(120, 65);

QLabel* wrapped(const QString& text, QWidget* parent) {
    auto* label = new QLabel(kept_together(text), parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

SuggestDialog::SuggestDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("suggest_dialog"));
    setWindowTitle(tr("Suggest an operation"));
    status_ = wrapped({}, this);
    status_->setObjectName(QStringLiteral("suggest_status"));
    progress_ = new QProgressBar(this);
    progress_->setAccessibleName(tr("Progress"));
    progress_->setRange(0, 1000);
    auto* area = new QScrollArea(this);
    area->setAccessibleName(tr("Suggestions"));
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_ = new QWidget(area);
    column_ = new QVBoxLayout(list_);
    column_->setSpacing(14);
    area->setWidget(list_);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    again_ = buttons->addButton(tr("Look &again"), QDialogButtonBox::ActionRole);
    again_->setToolTip(tr("Look for suggestions once more, for the project as it is now"));
    stop_ = buttons->addButton(tr("&Stop"), QDialogButtonBox::ActionRole);
    for (QAbstractButton* b : buttons->buttons())
        static_cast<QPushButton*>(b)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(again_, &QPushButton::clicked, this, &SuggestDialog::again_wanted);
    connect(stop_, &QPushButton::clicked, this, &SuggestDialog::stop_wanted);

    auto* rows = new QVBoxLayout(this);
    rows->addWidget(status_);
    rows->addWidget(progress_);
    rows->addWidget(area, 1);
    rows->addWidget(buttons);
    show_progress(-1);
}

void SuggestDialog::show_status(const QString& words) {
    status_->setText(kept_together(words));
}

QString SuggestDialog::status() const {
    return status_->text();
}

void SuggestDialog::show_progress(double share) {
    const bool runs = share >= 0;
    progress_->setVisible(runs);
    if (runs) progress_->setValue(int(std::lround(1000 * share)));
    stop_->setEnabled(runs);
    again_->setEnabled(!runs);
}

void SuggestDialog::show_cards(const std::vector<Card>& cards) {
    adds_.clear();
    while (QLayoutItem* item = column_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t i = 0; i < cards.size(); ++i) {
        const Card& card = cards[i];
        auto* box = new QWidget(list_);
        auto* grid = new QGridLayout(box);
        grid->setContentsMargins(0, 0, 0, 0);
        auto* picture = new QLabel(box);
        picture->setPixmap(card.picture.pixmap(card_picture));
        grid->addWidget(picture, 0, 0, 3, 1, Qt::AlignTop);
        QLabel* title = wrapped(card.title, box);
        QFont bold = title->font();
        bold.setBold(true);
        title->setFont(bold);
        grid->addWidget(title, 0, 1);
        grid->addWidget(wrapped(card.figures, box), 1, 1);
        QString reasons;
        for (const QString& reason : card.reasons)
            reasons += (reasons.isEmpty() ? QString() : QStringLiteral("\n")) + QStringLiteral("• ") + reason;
        grid->addWidget(wrapped(reasons, box), 2, 1);
        auto* add = new QPushButton(i < 9 ? tr("Add &%1").arg(i + 1) : tr("Add"), box);
        add->setObjectName(QStringLiteral("suggest_add_%1").arg(i));
        add->setAccessibleName(tr("Add %1").arg(card.title));
        add->setToolTip(tr("Add this operation to the project; undo takes it away again"));
        add->setAutoDefault(false);
        connect(add, &QPushButton::clicked, this, [this, i] { emit add_wanted(i); });
        grid->addWidget(add, 0, 2, Qt::AlignTop);
        grid->setColumnStretch(1, 1);
        column_->addWidget(box);
        adds_.push_back(add);
    }
    column_->addStretch(1);
}

} // namespace facetmill::ui
