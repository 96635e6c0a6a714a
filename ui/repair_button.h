// The way from the part's form to the scan room: says how many steps the part's recipe has.
#pragma once

#include "ui/document.h"

#include <QPushButton>

namespace facetmill::ui {

class RepairButton : public QPushButton {
    Q_OBJECT
public:
    RepairButton(const Document& document, QWidget* parent);
    /// Hidden where anything but the part is shown.
    void show_part(bool shown);

private:
    const Document& document_;
};

} // namespace facetmill::ui
