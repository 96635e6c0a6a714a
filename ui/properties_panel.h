// The form of what is selected in the tree. Edits go to the document as steps of its history.
#pragma once

#include "core/job/unroughed_stock.h"
#include "ui/document.h"
#include "ui/parameter_editor.h"
#include "ui/project_tree.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;

namespace facetmill::ui {

class BoundaryBox;
class CuttingButton;
class ElidedLabel;
class ParameterForm;
class RepairButton;
class ToolSketch;

/// The project's tools for a form; with `none`, number 0 before them.
std::vector<FormChoice> tool_choices(const Project& project, bool none);

class PropertiesPanel : public QWidget {
    Q_OBJECT
public:
    explicit PropertiesPanel(Document& document, QWidget* parent = nullptr);

    void show_node(const std::optional<TreeNode>& node);
    /// Takes over what stands in the fields; false, with the focus on the field, when one is invalid.
    bool commit();
    ParameterForm* form() { return form_; }
    BoundaryBox* boundary_box() { return boundary_box_; }
    RepairButton* repair_button() { return repair_; }
    /// Takes a point that was picked for a parameter of the operation shown; an axis becomes one through
    /// points.
    void take_point(const std::string& key, const Vec3& point);
    /// Shows again what the document holds.
    void reset() { refresh(); }

signals:
    void edit_tool(std::size_t index);
    /// The dialog of a global-local operation's rework regions is asked for.
    void edit_regions(std::size_t operation);
    /// A point for a parameter of the operation shown is to be picked in the view, or (`on` false) no more.
    void pick_requested(const std::string& key, bool on);
    /// Another node is shown.
    void shown();
    /// A mesh for the stock is asked for.
    void choose_stock();
    /// A mesh for a fixture is asked for.
    void choose_fixture(std::size_t index);

private:
    void refresh();
    /// `alarm`: the hint says what is wrong.
    void show_head(const QString& title, const QString& hint, bool alarm);
    /// Beside the form: how a boundary is painted, what feeds an operation's tool knows.
    void show_boxes();
    void take(const std::string& key, const ParameterValue& value);
    /// Takes what is to be shown; true where the form has to be built anew for it.
    bool take_shape();

    Document& document_;
    std::optional<TreeNode> node_;
    QString shape_; ///< what the form was built for; another one builds it anew
    UnroughedLook unroughed_;
    int operation_ = 0; ///< the id of the one that it shows; 0: none
    ElidedLabel* title_ = nullptr;
    QLabel* hint_ = nullptr;
    ParameterForm* form_ = nullptr;
    ToolSketch* sketch_ = nullptr;
    BoundaryBox* boundary_box_ = nullptr;
    CuttingButton* cutting_ = nullptr;
    RepairButton* repair_ = nullptr;
    QPushButton *edit_tool_ = nullptr, *choose_mesh_ = nullptr, *edit_regions_ = nullptr;
};

} // namespace facetmill::ui
