// The docks around the view: their places at first, how they come to light, and how they make room in a
// narrow window.
#pragma once

#include <QMainWindow>

#include <functional>
#include <map>
#include <vector>

class QDockWidget;

namespace facetmill::ui {

class Controller;

class WindowDocks : public QObject {
    Q_OBJECT
public:
    struct Place {
        QString name; ///< object name of the dock; settings and menus know it by this
        QString title;
        QWidget* content = nullptr;
        Qt::DockWidgetArea area = Qt::RightDockWidgetArea;
        QString beside = {};              ///< shares its place by tabs with this dock
        Controller* controller = nullptr; ///< told when it is seen; shows it by `offered`
        bool hidden = false;              ///< until it is offered or asked for
    };

    explicit WindowDocks(QMainWindow* window);
    ~WindowDocks() override { clear(); }

    void add(const Place& place);
    std::vector<QDockWidget*> all() const;
    /// To the front, with the keys in it: Alt and its number, in the order in which docks were added.
    void enter(const QString& name);
    /// Deletes all docks with what is in them.
    void clear();
    /// To the front.
    void show(const QString& name);
    /// The same as wide as it needs, also where it was hidden.
    void bring(const QString& name);
    /// The sizes of a window that was never changed.
    void size_as_new();
    /// In a narrow window what stands on the right goes behind the parameters, so that the view keeps room;
    /// in a wide one it goes back.
    void arrange();

    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void bring_to_light(QDockWidget* dock);
    void give_key(QDockWidget* dock);
    bool make_room();
    /// The form is wider in a wider window, unless it was given another width by hand.
    void follow_window();
    void go_back();
    bool stands_right(QDockWidget* dock) const;

    QMainWindow& window_;
    std::map<QString, QDockWidget*> docks_;
    std::vector<QDockWidget*> made_room_; ///< put behind the parameters because the window is narrow
    int left_given_ = 0;                  ///< width that the form was given by this
    bool charts_sized_ = false;           ///< they had their height given
};

} // namespace facetmill::ui
