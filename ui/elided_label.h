// A label of one line that is shortened to the width it has, in the middle if not told otherwise; the whole
// text is its tool tip. What can be said in fewer words is: that loses no word by chance.
#pragma once

#include <QLabel>
#include <QStringList>

namespace facetmill::ui {

class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    /// `shorter`: the same in fewer and fewer words; the first that there is room for is shown.
    void set_text(const QString& text, const QStringList& shorter = {});
    /// What can be read of it at its present width.
    QString shown_text() const;
    /// Where the text is shortened.
    void set_elide_mode(Qt::TextElideMode mode);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect text_area() const;

    QStringList shorter_;
    Qt::TextElideMode mode_ = Qt::ElideMiddle;
};

} // namespace facetmill::ui
