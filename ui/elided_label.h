// A label of one line that is shortened in the middle to the width it has; the whole text is its tool tip.
#pragma once

#include <QLabel>

namespace facetmill::ui {

class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    void set_text(const QString& text);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace facetmill::ui
