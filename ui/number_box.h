// A box for a number with up and down: takes a point for a decimal mark also where the user's is a comma, and
// shows no zeros at the end.
#pragma once

#include <QDoubleSpinBox>

namespace facetmill::ui {

class NumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QString textFromValue(double value) const override {
        QString text = QDoubleSpinBox::textFromValue(value);
        const qsizetype mark = text.indexOf(locale().decimalPoint());
        if (mark < 0) return text;
        while (text.endsWith(QLatin1Char('0')))
            text.chop(1);
        return text.size() == mark + 1 ? text.left(mark) : text;
    }

protected:
    QValidator::State validate(QString& text, int& cursor) const override {
        const QString mark = locale().decimalPoint();
        if (mark != QLatin1String(".") && !text.contains(mark)) text.replace(QLatin1Char('.'), mark);
        return QDoubleSpinBox::validate(text, cursor);
    }
};

} // namespace facetmill::ui
