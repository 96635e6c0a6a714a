// A label of long HTML, wrapped to the width that it gets.
#pragma once

#include <QLabel>

#include <utility>
#include <vector>

namespace facetmill::ui {

/// Layouts ask a label again and again how high it is at a width, and what it would like to be. QLabel lays
/// its text out twice each time, which takes 3 ms for a table of verification: here each is worked out once
/// for a text.
class HtmlLabel : public QLabel {
    Q_OBJECT
public:
    explicit HtmlLabel(QWidget* parent = nullptr);

    int heightForWidth(int width) const override;
    /// No width of its own.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    /// How often it was laid out for that.
    int times_measured() const { return times_measured_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    mutable QString measured_;                         ///< the text that is
    mutable std::vector<std::pair<int, int>> heights_; ///< by width
    mutable int times_measured_ = 0;
};

} // namespace facetmill::ui
