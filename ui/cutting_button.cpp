#include "ui/cutting_button.h"

#include "core/job/cutting_choice.h"
#include "ui/icons.h"
#include "ui/text.h"

#include <QMenu>

namespace facetmill::ui {

namespace {

/// Characters of a name that comes from a file.
constexpr int shown_material = 40;

QString name_of(const CuttingData& data) {
    QStringList words;
    for (const std::string& word : {data.material, data.name})
        if (!word.empty() && !words.contains(text(word))) words << text(word);
    return words.isEmpty() ? CuttingButton::tr("unnamed")
                           : elided(words.join(QStringLiteral(", ")), shown_material);
}

} // namespace

CuttingButton::CuttingButton(Document& document, QWidget* parent) : QPushButton(parent), document_(document) {
    setObjectName(QStringLiteral("cutting_choice"));
    setIcon(ui::icon(Icon::tool));
    setToolTip(tr("Feed and spindle as the operation’s tool has them for a material; of roughing depth and "
                  "step-over, too"));
    auto* menu = new QMenu(this);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { list(*menu); });
    setMenu(menu);
}

const Tool* CuttingButton::tool() const {
    const Project& project = document_.project();
    if (!operation_ || *operation_ >= project.operations.size()) return nullptr;
    return find_tool(project.tools, project.operations[*operation_]->common().tool);
}

void CuttingButton::set_operation(std::optional<std::size_t> index) {
    operation_ = index;
    const Tool* known = tool();
    setVisible(known && cutting_for(*known));
    if (!known) return;
    const CuttingData* runs = runs_by(document_.operation(*operation_), *known);
    setText(runs ? tr("Feeds: %1").arg(name_of(*runs)) : tr("Feeds of the tool"));
}

void CuttingButton::list(QMenu& menu) {
    menu.clear();
    const Tool* known = tool();
    if (!known) return;
    const CuttingData* now = runs_by(document_.operation(*operation_), *known);
    const LengthUnit unit = document_.unit();
    for (const CuttingData& one : known->cutting) {
        if (!is_complete(*known, one)) continue;
        const double feed = cutting_feed(*known, one);
        QAction* action = menu.addAction(tr("%1: %2 rpm, %3 %4")
                                             .arg(name_of(one), ui::number_text(one.spindle),
                                                  ui::number_text(feed / mm_per(unit), 5),
                                                  ui::text(edge_unit_name(Quantity::feed, unit))));
        action->setCheckable(true);
        action->setChecked(&one == now);
        connect(action, &QAction::triggered, this, [this, one, tool = *known, at = *operation_] {
            if (at >= document_.operation_count()) return;
            document_.change(tr("Feeds of the tool"),
                             [&](Project& p) { run_by(*p.operations.at(at), tool, one); });
        });
    }
}

} // namespace facetmill::ui
