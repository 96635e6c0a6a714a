#include "ui/html_label.h"

#include <QEvent>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr std::size_t max_widths = 16; // while a border is dragged there is always another one

} // namespace

HtmlLabel::HtmlLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::RichText);
    setWordWrap(true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

int HtmlLabel::heightForWidth(int width) const {
    if (measured_ != text()) {
        measured_ = text();
        heights_.clear();
    }
    const auto known = std::find_if(heights_.begin(), heights_.end(),
                                    [width](const auto& entry) { return entry.first == width; });
    if (known != heights_.end()) return known->second;
    ++times_measured_;
    if (heights_.size() == max_widths) heights_.erase(heights_.begin());
    heights_.emplace_back(width, QLabel::heightForWidth(width));
    return heights_.back().second;
}

QSize HtmlLabel::sizeHint() const {
    return {0, heightForWidth(QWIDGETSIZE_MAX)};
}

void HtmlLabel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) heights_.clear();
    QLabel::changeEvent(event);
}

} // namespace facetmill::ui
