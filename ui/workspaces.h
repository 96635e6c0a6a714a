// Four ways to look at a job, each with what belongs to it: Prepare (part, stock, fixtures), Plan (paths),
// Verify (the part in the colours of the verdict) and Simulate (the stock as it is cut). One row below the
// view: the four, the layers, the meaning of the colours; above it the bar that belongs to the chosen one.
#pragma once

#include "ui/layer_bar.h"

#include <QWidget>

#include <array>
#include <vector>

class QLabel;
class QToolButton;

namespace facetmill::ui {

enum class Workspace { prepare, plan, verify, simulate };
inline constexpr std::size_t workspace_count = 4;
/// For settings and object names.
const char* workspace_name(Workspace workspace);
/// As buttons and menus have them.
QString workspace_label(Workspace workspace);
QString workspace_help(Workspace workspace);

class Workspaces : public QWidget {
    Q_OBJECT
public:
    /// Takes the bars in: the layers, those of chosen operations (a roughing layer, a divide) and the
    /// playback.
    Workspaces(LayerBar& layers, const std::vector<QWidget*>& operation_bars, QWidget& playback_bar,
               QWidget* parent);

    Workspace current() const { return current_; }
    /// What was just done is to be seen there. Each has the layers that were shown in it last.
    void enter(Workspace workspace);
    QToolButton* button(Workspace workspace) const { return buttons_[std::size_t(workspace)]; }
    /// The layers of all of them, for the next start.
    void keep_layers() const;

signals:
    void entered(facetmill::ui::Workspace now);
    /// By the user, after `entered`.
    void chosen(facetmill::ui::Workspace now);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void add_row();
    void show_bars();

    LayerBar& layers_;
    QWidget& playback_;
    QWidget *plan_bars_ = nullptr, *play_bars_ = nullptr;
    QLabel* nothing_ = nullptr; ///< in place of the playback where there is nothing to play
    Workspace current_ = Workspace::prepare;
    std::array<QToolButton*, workspace_count> buttons_{};
    std::array<LayerSet, workspace_count> shown_;
};

} // namespace facetmill::ui
