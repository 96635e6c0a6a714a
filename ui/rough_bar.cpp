#include "ui/rough_bar.h"

#include "ui/elided_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

namespace facetmill::ui {

RoughBar::RoughBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("rough_bar"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    row->setSpacing(8);
    auto* name = new QLabel(tr("Layers"), this);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("layer_slider"));
    slider_->setMinimumWidth(80);
    slider_->setPageStep(1);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->setToolTip(tr("Left end: all layers; then one layer alone, from the top down"));
    slider_->setAccessibleName(tr("Layer"));
    name->setBuddy(slider_);
    readout_ = new ElidedLabel(this);
    readout_->setObjectName(QStringLiteral("layer_readout"));
    readout_->setMinimumWidth(40);
    row->addWidget(name);
    row->addWidget(slider_, 1);
    row->addWidget(readout_, 3);
}

} // namespace facetmill::ui
