// The user's tool libraries: tools are taken from them into the project, and into them from files of other
// programs and from the project.
#pragma once

#include "core/tools/library_file.h"
#include "ui/document.h"

#include <QDialog>

class QAction;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTableWidget;

namespace facetmill::ui {

class ToolLibraryDialog : public QDialog {
    Q_OBJECT
public:
    /// `folder`: where the libraries lie (own_folders.h).
    ToolLibraryDialog(Document& document, std::filesystem::path folder, QWidget* parent = nullptr);

    /// Opens it over the user's own libraries, in the parent's window.
    static QAction* make_action(Document& document, QWidget* parent);

    // Files are read and written aside; what comes of it is told in the dialog.

    /// Takes over what a file of any format holds, and tells what of it could not be carried.
    void import_file(const QString& path);
    /// Writes the chosen tools, or all that are shown, in the format that the file's name says.
    void export_to(const QString& path);
    /// The chosen tools into the project, with free numbers.
    void add_chosen();
    /// The project's tools into a library of its name.
    void keep_project_tools();

private:
    void read_folder();
    void show_tools();
    void tell(const QString& title, const QStringList& lines);
    /// In the order of the rows.
    std::vector<LibraryTool> shown(bool only_chosen) const;
    void ask_for_file();
    void ask_where();
    void update_buttons();

    Document& document_;
    std::filesystem::path folder_;
    struct Entry {
        LibraryTool tool;
        QString library;
    };
    std::vector<Entry> entries_;
    QLineEdit* filter_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLabel* empty_ = nullptr;
    QLabel* title_ = nullptr;
    QPlainTextEdit* remarks_ = nullptr;
    QPushButton *add_ = nullptr, *keep_ = nullptr, *export_ = nullptr;
};

} // namespace facetmill::ui
