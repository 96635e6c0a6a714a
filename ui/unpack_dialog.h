// Packed projects are unpacked before they are opened: asks into which folder.
#pragma once

#include <QDialog>

#include <filesystem>

class QLabel;
class QLineEdit;
class QPushButton;

namespace facetmill::ui {

class UnpackDialog : public QDialog {
    Q_OBJECT
public:
    /// Suggests a new folder beside the file that is called like it.
    explicit UnpackDialog(const std::filesystem::path& packed, QWidget* parent = nullptr);

    /// The folder's absolute path; one that is not there yet, or is empty.
    QString folder() const;

private:
    void browse();
    /// Says why a folder will not do; the dialog cannot be accepted then.
    void judge();

    std::filesystem::path packed_;
    QLineEdit* folder_ = nullptr;
    QLabel* trouble_ = nullptr;
    QPushButton* unpack_ = nullptr;
};

} // namespace facetmill::ui
