#include "ui/divide_bar.h"

#include "ui/elided_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

namespace facetmill::ui {

DivideBar::DivideBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("divide_bar"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    row->setSpacing(8);
    auto* name = new QLabel(tr("Divide"), this);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("divide_slider"));
    slider_->setRange(10, 90);
    slider_->setPageStep(5);
    slider_->setMinimumWidth(80);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->setToolTip(
        tr("Slope from level at which the part is divided: what is steeper is cut by levels"));
    slider_->setAccessibleName(tr("Divide between steep and shallow"));
    name->setBuddy(slider_);
    readout_ = new ElidedLabel(this);
    readout_->setObjectName(QStringLiteral("divide_readout"));
    readout_->setMinimumWidth(40);
    row->addWidget(name);
    row->addWidget(slider_, 2);
    row->addWidget(readout_, 3);
}

} // namespace facetmill::ui
