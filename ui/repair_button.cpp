#include "ui/repair_button.h"

#include "ui/text.h"

namespace facetmill::ui {

RepairButton::RepairButton(const Document& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
    setObjectName(QStringLiteral("repair_part"));
    setToolTip(
        tr("Loose pieces, holes, noise, facets: what is wrong with the mesh, and a recipe that mends it"));
}

void RepairButton::show_part(bool shown) {
    setVisible(shown);
    const std::size_t steps = document_.project().part.repair.size();
    setText(steps == 0 ? tr("Scan room…")
                       : tr("Scan room: %1 steps…", nullptr, int(steps)).arg(count_text(steps)));
}

} // namespace facetmill::ui
