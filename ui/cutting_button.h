// The feeds and speeds that an operation's tool knows, offered beside the operation's form.
#pragma once

#include "ui/document.h"

#include <QPushButton>

namespace facetmill::ui {

class CuttingButton : public QPushButton {
    Q_OBJECT
public:
    CuttingButton(Document& document, QWidget* parent);

    /// Says what the operation runs by; hidden for none, and where its tool knows nothing.
    void set_operation(std::optional<std::size_t> index);

private:
    void list(QMenu& menu);
    const Tool* tool() const;

    Document& document_;
    std::optional<std::size_t> operation_;
};

} // namespace facetmill::ui
