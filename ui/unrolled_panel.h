// The panel of the unrolled view: which operation, and its path rolled off the turning part.
#pragma once

#include <QWidget>

class QComboBox;
class QToolButton;

namespace facetmill::ui {

class UnrolledView;

class UnrolledPanel : public QWidget {
    Q_OBJECT
public:
    explicit UnrolledPanel(QWidget* parent = nullptr);

    UnrolledView* view() { return view_; }
    QComboBox* operation_box() { return operation_; }
    /// Enables the buttons where there is a path.
    void set_ready(bool ready);

signals:
    void picture_requested();

private:
    UnrolledView* view_ = nullptr;
    QComboBox* operation_ = nullptr;
    QToolButton *all_ = nullptr, *picture_ = nullptr;
};

} // namespace facetmill::ui
