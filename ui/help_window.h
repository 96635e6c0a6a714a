// The manual in a window: contents and search on the left, the page on the right.
#pragma once

#include <QWidget>

class QAction;
class QLineEdit;
class QListWidget;
class QSplitter;
class QStackedWidget;
class QToolBar;
class QTreeWidget;

namespace facetmill::ui {

class HelpBrowser;

class HelpWindow : public QWidget {
    Q_OBJECT
public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// A place of the manual, "rough.html#depth"; where there is none, or with an empty text, the contents.
    void show_topic(const QString& topic);
    HelpBrowser* browser() { return browser_; }
    QLineEdit* search_field() { return search_; }
    QListWidget* results() { return results_; }
    QTreeWidget* contents() { return contents_; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolBar* make_bar();
    void fill_contents();
    void search(const QString& words);
    void choose_in_contents(const QUrl& shown);
    void zoom(int steps);

    HelpBrowser* browser_ = nullptr;
    QLineEdit* search_ = nullptr;
    QSplitter* halves_ = nullptr;
    QStackedWidget* left_ = nullptr;
    QTreeWidget* contents_ = nullptr;
    QListWidget* results_ = nullptr;
    int zoomed_ = 0;
    bool divided_ = false; ///< by the user
};

} // namespace facetmill::ui
