// Templates of jobs: what of a setup serves other parts, kept in the user's own folder, and applied to the
// project that is shown.
#pragma once

#include "ui/document.h"

#include <QObject>

#include <filesystem>

class QMenu;
class QWidget;

namespace facetmill::ui {

class Messages;

class Templates : public QObject {
    Q_OBJECT
public:
    Templates(Document& document, Messages& messages, QWidget* window);

    /// Lists the templates there are whenever it opens.
    QMenu* menu() { return menu_; }
    /// Asks for a name, and before it writes over a template.
    void save_with_dialog();
    /// Keeps the shown setup, as it is now, under a name that a file may have; what comes of it is told in
    /// the window. Throws Error(out_of_range) for another name.
    void save(const QString& name);
    /// As one step of the history; what does not fit is told.
    void apply(const std::filesystem::path& file);

private:
    void list();
    void apply_with_dialog();
    std::filesystem::path file_of(const QString& name) const;

    Document& document_;
    Messages& messages_;
    QWidget* window_;
    QMenu* menu_ = nullptr;
};

} // namespace facetmill::ui
