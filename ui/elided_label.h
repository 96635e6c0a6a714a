// A label of one line that is shortened to the width it has, in the middle if not told otherwise; the whole
// text is its tool tip.
#pragma once

#include <QLabel>

namespace facetmill::ui {

class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    void set_text(const QString& text);
    /// Where the text is shortened.
    void set_elide_mode(Qt::TextElideMode mode);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Qt::TextElideMode mode_ = Qt::ElideMiddle;
};

} // namespace facetmill::ui
