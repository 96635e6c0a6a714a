// A box for a number with up and down: takes a point for a decimal mark also where the user's is a comma.
#pragma once

#include <QDoubleSpinBox>

namespace facetmill::ui {

class NumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

protected:
    QValidator::State validate(QString& text, int& cursor) const override {
        const QString mark = locale().decimalPoint();
        if (mark != QLatin1String(".") && !text.contains(mark)) text.replace(QLatin1Char('.'), mark);
        return QDoubleSpinBox::validate(text, cursor);
    }
};

} // namespace facetmill::ui
