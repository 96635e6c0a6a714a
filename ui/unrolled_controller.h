// The unrolled view in the window: its dock's content, of which operation it is, and how its mark and the
// tool in the 3D view go together. The window carries the one to the other.
#pragma once

#include "ui/background_job.h"
#include "ui/document.h"
#include "viz/unrolled.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QToolButton;

namespace facetmill::ui {

class UnrolledView;

class UnrolledController : public QObject {
    Q_OBJECT
public:
    UnrolledController(Document& document, QWidget* window);
    ~UnrolledController() override;

    QWidget* panel() { return panel_; }
    UnrolledView* view() { return view_; }
    QComboBox* operation_box() { return operation_; }

    /// The paths that the scene shows from now on, in its order.
    void set_paths(std::vector<std::shared_ptr<const OperationResult>> results);
    /// True where one of them is of a part that turns.
    bool any() const { return !sources_.empty(); }
    /// Where the tool is: of path `source` the end of a motion. Another operation's path comes to be shown.
    void set_place(std::size_t source, std::size_t motion);
    void clear_place();
    /// The panel came to be seen.
    void look();
    bool save_picture(const QString& path);
    QString export_name() const;
    bool busy() const { return job_.running(); }

signals:
    /// The tool is wanted at the end of this motion.
    void place_wanted(std::size_t source, std::size_t motion);
    void step_wanted(int by);
    void picture_requested();
    void failed(const QString& message);
    void told(const QString& message);
    void settled();

private:
    void update();
    void show_place();
    void enable_buttons();
    std::optional<std::size_t> source() const;

    Document& document_;
    QWidget* panel_ = nullptr;
    UnrolledView* view_ = nullptr;
    QComboBox* operation_ = nullptr;
    QToolButton *all_ = nullptr, *picture_ = nullptr;
    std::vector<std::shared_ptr<const OperationResult>> results_;
    std::vector<std::size_t> sources_; ///< of `results_`, those of turning parts: the entries of the box
    std::optional<std::pair<std::size_t, std::size_t>> place_;
    LengthUnit unit_ = LengthUnit::mm;
    BackgroundJob job_; // last: it ends first
};

} // namespace facetmill::ui
