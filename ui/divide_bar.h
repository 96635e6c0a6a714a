// The divide between steep and shallow, below the view: a handle to drag, and how much lies on either side.
#pragma once

#include <QWidget>

class QSlider;

namespace facetmill::ui {

class ElidedLabel;

class DivideBar : public QWidget {
    Q_OBJECT
public:
    explicit DivideBar(QWidget* parent = nullptr);
    QSlider* slider() { return slider_; } ///< degrees from level
    ElidedLabel* readout() { return readout_; }

private:
    QSlider* slider_ = nullptr;
    ElidedLabel* readout_ = nullptr;
};

} // namespace facetmill::ui
