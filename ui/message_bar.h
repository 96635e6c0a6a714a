// A line over the lower edge of the view that says what went wrong, or asks for attention, without stopping
// anybody.
#pragma once

#include <QFrame>

#include <functional>

class QLabel;
class QPushButton;
class QToolButton;

namespace facetmill::ui {

/// What a message offers to do about it, by a button.
struct MessageAction {
    QString text; ///< empty: nothing
    std::function<void()> run;
};

class MessageBar : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, warning, error };

    /// Lies over the parent, which is not pushed about by it.
    explicit MessageBar(QWidget* parent);

    void show_message(Kind kind, const QString& message);
    /// A button beside the message that is shown, until another one is.
    void offer(MessageAction action);
    /// The message that is shown, or nothing.
    const QString& message() const { return message_; }
    /// The colours of the present theme.
    void color();

public slots:
    void dismiss();

signals:
    void dismissed();

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    /// As wide as the parent, as high as the words need; below, where neither title nor legend is.
    void place();

    Kind kind_ = Kind::information;
    QString message_;
    MessageAction action_;
    QLabel* icon_ = nullptr;
    QLabel* text_ = nullptr;
    QPushButton* button_ = nullptr;
    QToolButton* close_ = nullptr;
};

} // namespace facetmill::ui
