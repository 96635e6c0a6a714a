// Packed projects are unpacked before they are opened: asks into which folder.
#pragma once

#include "ui/folder_dialog.h"

#include <filesystem>

namespace facetmill::ui {

/// The folder is one that is not there yet, or is empty.
class UnpackDialog : public FolderDialog {
    Q_OBJECT
public:
    /// Suggests a new folder beside the file that is called like it.
    explicit UnpackDialog(const std::filesystem::path& packed, QWidget* parent = nullptr);

private:
    QString trouble() const override;
    QString browsed() override;

    std::filesystem::path packed_;
};

} // namespace facetmill::ui
