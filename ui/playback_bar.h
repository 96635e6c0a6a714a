// Buttons, slider and fields of playback, below the view; in two rows where the window is narrow.
#pragma once

#include "ui/playback_controller.h"

#include <QWidget>

class QAction;
class QBoxLayout;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;
class QToolButton;

namespace facetmill::ui {

class PlaybackBar : public QWidget {
    Q_OBJECT
public:
    explicit PlaybackBar(PlaybackController& playback, QWidget* parent = nullptr);

    QToolButton* button(const char* name) const;
    QSlider* slider() { return slider_; }
    QSpinBox* goto_box() { return goto_; }
    QComboBox* operation_box() { return operation_; }
    QComboBox* speed_box() { return speed_; }
    QString time_text() const;
    /// The part is to be seen turning, where one turns.
    bool turns_part() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// The buttons that move it, and the slider.
    void add_drive(QBoxLayout& row);
    /// Where it is, by operation, number and time, and how fast.
    void add_fields(QBoxLayout& row);
    void reload();
    void show_position();
    void take_speed();

    PlaybackController& playback_;
    QBoxLayout* rows_ = nullptr;
    QToolButton *play_ = nullptr, *turn_ = nullptr;
    QSlider* slider_ = nullptr;
    QComboBox *operation_ = nullptr, *speed_ = nullptr;
    QSpinBox* goto_ = nullptr;
    QLabel *of_ = nullptr, *time_ = nullptr;
};

} // namespace facetmill::ui
