#include "ui/unrolled_panel.h"

#include "ui/icon_button.h"
#include "ui/unrolled_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace facetmill::ui {

UnrolledPanel::UnrolledPanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("unrolled"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    operation_ = new QComboBox(this);
    operation_->setObjectName(QStringLiteral("unrolled_operation"));
    operation_->setToolTip(tr("Of which operation"));
    operation_->setFocusPolicy(Qt::TabFocus);
    operation_->setMinimumContentsLength(8);
    row->addWidget(operation_);
    row->addStretch(1);
    const auto add = [&](Icon which, const QString& tip, const char* name) {
        auto* button = icon_button(this, which, tip, name);
        row->addWidget(button);
        return button;
    };
    all_ = add(Icon::fit, tr("Show all of it (double click, Home)"), "unrolled_all");
    picture_ = add(Icon::picture, tr("Export the unrolled path as a picture (PNG)"), "unrolled_picture");
    column->addLayout(row);
    view_ = new UnrolledView(this);
    column->addWidget(view_, 1);
    connect(all_, &QToolButton::clicked, view_, &UnrolledView::reset_view);
    connect(picture_, &QToolButton::clicked, this, &UnrolledPanel::picture_requested);
}

void UnrolledPanel::set_ready(bool ready) {
    for (QToolButton* button : {all_, picture_})
        button->setEnabled(ready);
}

} // namespace facetmill::ui
