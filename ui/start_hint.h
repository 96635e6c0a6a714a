// What an empty window says: how to begin, with what was worked on last, the samples, and the machine that
// new projects are for.
#pragma once

#include <QFrame>

#include <string>

class QLabel;
class QListWidget;
class QMenu;

namespace facetmill::ui {

class UsualProjectBox;

class StartHint : public QFrame {
    Q_OBJECT
public:
    StartHint(QMenu* samples, QWidget* parent);
    /// Keeps itself in the middle of its parent; in a small one there are only words and buttons.
    void place();
    /// What the settings say; the window tells when that is to be read.
    void show_usual();

signals:
    void open_requested();
    void file_chosen(const QString& path);
    void sample_chosen(const std::string& name);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QListWidget* make_list(const QString& name, const QString& called);
    static void lay_out(QListWidget& list, int in_a_row, int spare_height);
    void show_axes(bool on);
    /// As much of a name as stands below a picture.
    QString short_name(const QString& name) const;
    void list_recent();
    void list_samples();

    QLabel *title_ = nullptr, *text_ = nullptr;
    QWidget* more_ = nullptr; ///< all that needs room
    QLabel* recent_label_ = nullptr;
    QListWidget *recent_ = nullptr, *samples_ = nullptr;
    UsualProjectBox* usual_ = nullptr;
};

} // namespace facetmill::ui
