// F1: the manual at the place of what has the focus, from the window and from its dialogs.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

class QWidget;

namespace facetmill::ui {

class HelpWindow;

/// Widgets say by these properties what they are about: a chapter of the manual ("tools.html"), a parameter's
/// key, and the sections of the reference that hold the keys of the fields within ("setups place").
inline constexpr char help_topic_property[] = "help_topic";
inline constexpr char help_key_property[] = "help_key";
inline constexpr char help_scope_property[] = "help_scope";

/// The place of the manual for a widget: its own, or that of what it stands in.
QString help_topic(const QWidget* at);
/// The chapter for what a form shows: the kind of an operation, or a section of the reference.
QString help_chapter(const QString& scope);

class Help : public QObject {
    Q_OBJECT
public:
    explicit Help(QWidget* window);
    ~Help() override;

    /// For what has the focus.
    void open_here();
    void open(const QString& topic);
    /// Null until it is opened.
    HelpWindow* window();

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QWidget* owner_;
    QPointer<HelpWindow> opened_;
};

} // namespace facetmill::ui
