#include "ui/place_value.h"

#include "core/base/vec.h"
#include "ui/number_box.h"
#include "ui/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QToolButton>

#include <array>

namespace facetmill::ui {

namespace {

constexpr double max_length = 1e5, max_factor = 1e6; // mm
/// What each kind of change begins with.
constexpr std::array<double, 3> first_value{15, 10, 1.02};

} // namespace

PlaceValueRow::PlaceValueRow(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    kind_ = new QComboBox(this);
    kind_->setObjectName(QStringLiteral("place_value_kind"));
    kind_->addItems({tr("Turn about X"), tr("Turn about Y"), tr("Turn about Z"), tr("Move along X"),
                     tr("Move along Y"), tr("Move along Z"), tr("Scale by")});
    kind_->setCurrentIndex(2);
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(7);
    kind_->setToolTip(
        tr("Turns are by the right hand about the middle of the part's box. Rings and "
           "arrows in the view do the same by the mouse, with Shift in round steps. Scaling keeps that "
           "and the lowest point; cutters and tolerances stay as they are."));
    value_ = new NumberBox(this);
    value_->setObjectName(QStringLiteral("place_value"));
    value_->setAccessibleName(tr("By how much"));
    value_->setKeyboardTracking(false);
    value_->setMinimumWidth(60);
    apply_ = new QToolButton(this);
    apply_->setObjectName(QStringLiteral("place_value_apply"));
    apply_->setText(tr("Apply"));
    apply_->setToolTip(tr("Enter in the field does the same"));
    apply_->setFocusPolicy(Qt::TabFocus);
    row->addWidget(kind_, 2); // words are longer than numbers
    row->addWidget(value_, 1);
    row->addWidget(apply_);
    connect(kind_, &QComboBox::activated, this, &PlaceValueRow::show_kind);
    connect(apply_, &QToolButton::clicked, this, &PlaceValueRow::apply);
    if (auto* line = value_->findChild<QLineEdit*>())
        connect(line, &QLineEdit::returnPressed, this, &PlaceValueRow::apply);
    show_kind();
}

PlaceChange PlaceValueRow::what() const {
    return kind_->currentIndex() < 3   ? PlaceChange::turn
           : kind_->currentIndex() < 6 ? PlaceChange::move
                                       : PlaceChange::scale;
}

int PlaceValueRow::axis() const {
    return kind_->currentIndex() % 3;
}

void PlaceValueRow::show_kind() {
    const double per = mm_per(unit_);
    switch (what()) {
    case PlaceChange::turn:
        value_->setDecimals(4);
        value_->setRange(-360, 360);
        value_->setSingleStep(1);
        value_->setSuffix(QStringLiteral("°"));
        break;
    case PlaceChange::move:
        value_->setDecimals(unit_ == LengthUnit::inch ? 5 : 4);
        value_->setRange(-max_length / per, max_length / per);
        value_->setSingleStep(unit_ == LengthUnit::inch ? 0.1 : 1);
        value_->setSuffix(QChar(' ') + text(unit_name(unit_)));
        break;
    case PlaceChange::scale:
        value_->setDecimals(6);
        value_->setRange(1 / max_factor, max_factor);
        value_->setSingleStep(0.01);
        value_->setSuffix(QString());
        break;
    }
    value_->setValue(first_value[std::size_t(what())]);
}

void PlaceValueRow::set_unit(LengthUnit unit) {
    if (unit == unit_) return;
    const double mm = value_->value() * mm_per(unit_);
    unit_ = unit;
    if (what() != PlaceChange::move) return;
    show_kind();
    value_->setValue(mm / mm_per(unit_));
}

void PlaceValueRow::show_value(PlaceChange what, int axis, double value) {
    kind_->setCurrentIndex(what == PlaceChange::turn ? axis : what == PlaceChange::move ? 3 + axis : 6);
    show_kind();
    value_->setValue(what == PlaceChange::turn   ? degrees(value)
                     : what == PlaceChange::move ? value / mm_per(unit_)
                                                 : value);
}

void PlaceValueRow::apply() {
    value_->interpretText();
    const double v = value_->value();
    emit wanted(what(), axis(),
                what() == PlaceChange::turn   ? radians(v)
                : what() == PlaceChange::move ? v * mm_per(unit_)
                                              : v);
}

} // namespace facetmill::ui
