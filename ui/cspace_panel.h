// The panel of the configuration space: heading, buttons, the three-dimensional view, its legend, and a line
// for what is under the pointer.
#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;

namespace facetmill::ui {

class CSpaceView;
class ElidedLabel;

class CSpacePanel : public QWidget {
    Q_OBJECT
public:
    explicit CSpacePanel(QWidget* parent = nullptr);

    CSpaceView* view() { return view_; }
    ElidedLabel* heading() { return heading_; }
    QLabel* readout() { return readout_; }
    QToolButton* back() { return back_; }
    QToolButton* keep() { return keep_; }
    QToolButton* remove() { return remove_; }
    QToolButton* kept() { return kept_; }
    void set_busy(bool busy, double fraction = 0);
    /// Buttons for what is there: a point, its study.
    void set_ready(bool point, bool study);
    void show_legend();
    /// A posture that is kept by hand: what it is, and for which point.
    struct Kept {
        QString label;
        std::size_t point = 0;
    };
    /// Lists them in the menu of their button, which is hidden where there are none.
    void show_kept(const std::vector<Kept>& all);
    QSize sizeHint() const override { return {400, 460}; }
    bool eventFilter(QObject* object, QEvent* event) override;

signals:
    void stepped(int points, int passes);
    void cancel_requested();
    void picture_requested();
    void table_requested();
    void back_requested(); ///< to the planned posture
    void keep_requested(); ///< the tried posture, for the point
    void remove_requested();
    void kept_chosen(std::size_t point);

private:
    /// The view is too low for the names of postures.
    bool names_in_legend() const;

    CSpaceView* view_ = nullptr;
    ElidedLabel* heading_ = nullptr;
    QLabel* readout_ = nullptr;
    QWidget* legend_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QToolButton *cancel_ = nullptr, *back_ = nullptr, *picture_ = nullptr, *table_ = nullptr;
    QToolButton *keep_ = nullptr, *remove_ = nullptr, *kept_ = nullptr;
    std::vector<QToolButton*> steps_;
    bool legend_names_ = false; ///< the legend has them
};

} // namespace facetmill::ui
