// A line across the top of the view that says what went wrong, or asks for attention, without stopping
// anybody.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace facetmill::ui {

class MessageBar : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, warning, error };

    explicit MessageBar(QWidget* parent = nullptr);

    void show_message(Kind kind, const QString& message);
    /// The message that is shown, or nothing.
    QString message() const;
    /// The colours of the present theme.
    void color();

public slots:
    void dismiss();

private:
    Kind kind_ = Kind::information;
    QLabel* icon_ = nullptr;
    QLabel* text_ = nullptr;
    QToolButton* close_ = nullptr;
};

} // namespace facetmill::ui
