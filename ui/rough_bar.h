// The choice of a roughing layer, below the view.
#pragma once

#include <QWidget>

class QSlider;

namespace facetmill::ui {

class ElidedLabel;

class RoughBar : public QWidget {
    Q_OBJECT
public:
    explicit RoughBar(QWidget* parent = nullptr);
    QSlider* slider() { return slider_; }
    ElidedLabel* readout() { return readout_; }

private:
    QSlider* slider_ = nullptr;
    ElidedLabel* readout_ = nullptr;
};

} // namespace facetmill::ui
