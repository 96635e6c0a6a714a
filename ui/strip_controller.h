// Strips of clean-up in the window: a list of what a planned operation found, each to be switched on and off;
// the strips in the view while the list is seen, one of them chosen in either place; and how the previous
// tool stood along it.
#pragma once

#include "core/strategy/cleanup/cleanup.h"
#include "ui/background_job.h"
#include "ui/document.h"
#include "viz/scene.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace facetmill::ui {

class CameraFlight;
class ElidedLabel;
class Viewport;

/// Which operation, its strips, and the place along the one that is chosen.
class StripPanel : public QWidget {
    Q_OBJECT
public:
    explicit StripPanel(QWidget* parent = nullptr);

    QTreeWidget* list() { return list_; }
    QComboBox* operation_box() { return operation_; }
    QCheckBox* touch_box() { return touch_; }
    QSlider* place() { return place_; }
    QLabel* readout() { return readout_; }
    ElidedLabel* note() { return note_; }
    /// What stands instead of the list; empty: the list itself.
    void set_empty_text(const QString& text);
    QString empty_text() const;
    /// All columns but the last as wide as they need, with room for the mark of sorting where it is.
    void fit_columns();
    QSize sizeHint() const override { return {300, 380}; }
    QSize minimumSizeHint() const override { return {170, 120}; }

private:
    QComboBox* operation_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QLabel *empty_ = nullptr, *readout_ = nullptr;
    ElidedLabel* note_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QCheckBox* touch_ = nullptr;
    QSlider* place_ = nullptr;
};

class StripController : public QObject {
    Q_OBJECT
public:
    StripController(Document& document, Viewport& viewport, QWidget* window);
    ~StripController() override;

    StripPanel* panel() { return panel_; }

    /// The paths that the scene shows from now on, in its order, and the ids of their operations.
    void set_paths(std::vector<std::shared_ptr<const OperationResult>> results, std::vector<int> ids);
    /// True where one of them is of a clean-up.
    bool any() const { return !sources_.empty(); }
    /// The panel came to be seen, or is not seen any more.
    void look();
    /// The strip that covers a place of the part becomes the chosen one where the list is seen, and the
    /// previous tool stands at the place. False where there is none.
    bool pick(const Vec3& place);
    /// Clicks on the path mean the strip below it.
    bool takes_path_clicks() const;
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Chooses a strip by its place in the operation's list.
    void choose(std::optional<std::size_t> strip, bool fly);
    /// Something else has the view's tool.
    void leave_tool();
    /// The palette changed.
    void color();
    bool busy() const;
    /// Puts the strips into the view again after others were there.
    void show_again();

signals:
    /// Strips of the list come into the view, or have gone: then it may show others.
    void strips_shown(bool on);
    /// The previous tool belongs here, touching the part at both points.
    void touch_wanted(const facetmill::Tool& tool, const facetmill::CleanupRecord::Touch& touch);
    /// The tool of before belongs into the view again.
    void touch_gone();
    void failed(const QString& message);
    void settled();

private:
    std::optional<std::size_t> source() const;
    /// The chosen operation's result and settings; null where there is none.
    const OperationResult* result() const;
    const CleanupSettings* settings() const;
    QString empty_reason() const;
    void refresh();
    void fill();
    void show_states();
    void show_strips();
    void switch_strip(const QTreeWidgetItem& item);
    void show_place();
    void take_tool();
    void show_touch();
    QTreeWidgetItem* item_of(std::size_t strip) const;

    Document& document_;
    Viewport& viewport_;
    StripPanel* panel_ = nullptr;
    CameraFlight* flight_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<int> ids_;
    std::vector<std::size_t> sources_; ///< of `results_`, those of clean-up: the entries of the box
    std::optional<std::size_t> chosen_;
    const OperationResult* listed_ = nullptr; ///< whose strips the list has
    LengthUnit listed_unit_ = LengthUnit::mm;
    std::vector<std::string> listed_name_;
    StripDisplayPtr shown_;    ///< in the view; null: none
    std::string wanted_;       ///< what the view's strips are, or are being, made from
    bool touch_shown_ = false; ///< the view has the previous tool from here
    bool tool_left_ = false;   ///< something else has it, until a place is chosen again
    BackgroundJob job_;        // last: it ends first
};

} // namespace facetmill::ui
