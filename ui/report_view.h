// What is known of the thing that is selected: the mesh as it was read, with its defects; the result of an
// operation; or all operations in a table.
#pragma once

#include "ui/document.h"
#include "ui/project_tree.h"

#include <QTextBrowser>

namespace facetmill::ui {

class ReportView : public QTextBrowser {
    Q_OBJECT
public:
    explicit ReportView(Document& document, QWidget* parent = nullptr);
    void show_node(const std::optional<TreeNode>& node);
    QSize sizeHint() const override { return {250, 300}; }
    QSize minimumSizeHint() const override { return {150, 80}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    QString part_html() const;
    QString operation_html(std::size_t i) const;
    QString operations_html() const;
    QString program_html(const OpenedProgram& opened) const;

    Document& document_;
    std::optional<TreeNode> node_;
    QString shown_; ///< what it says now, as HTML
};

} // namespace facetmill::ui
