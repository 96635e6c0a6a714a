#include "ui/hole_choice.h"

#include "ui/scan_rows.h"
#include "ui/scan_words.h"

#include <QActionGroup>
#include <QMenu>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

using StepFill = RepairStep::Fill;

bool is_of_hole(const RepairStep& step, const std::vector<Hole>& holes, std::size_t h) {
    return step.kind == RepairStep::Kind::hole
           && hole_near(holes, Vec3(step.at[0], step.at[1], step.at[2])) == h;
}

/// To a thousandth, where that is little beside the hole: numbers that people read.
double rounded_place(double mm, const Hole& hole) {
    constexpr double per_mm = 1000, smallest = 0.1;
    return hole.diameter > smallest ? std::round(mm * per_mm) / per_mm : mm;
}

/// A menu at a place of the screen.
void show_choices(HoleChoice now, const QPoint& at, QWidget* parent,
                  const std::function<void(HoleChoice)>& choose) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("hole_choices"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    auto* group = new QActionGroup(menu);
    const auto add = [&](const QString& words, const QString& help, HoleChoice choice, const char* name) {
        QAction* action = menu->addAction(words);
        action->setObjectName(QLatin1String(name));
        action->setToolTip(help);
        action->setCheckable(true);
        action->setChecked(choice == now);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, parent, [choose, choice] { choose(choice); });
    };
    add(ScanPanel::tr("&As the other holes"), ScanPanel::tr("What the steps for all holes say of its size"),
        HoleChoice::as_all, "hole_as_all");
    menu->addSeparator();
    add(ScanPanel::tr("Fill &smooth"),
        ScanPanel::tr("A step of its own: goes on as the surface around bends"), HoleChoice::smooth,
        "hole_smooth");
    add(ScanPanel::tr("Fill &flat"), ScanPanel::tr("A step of its own: takes the least area"),
        HoleChoice::flat, "hole_flat");
    add(ScanPanel::tr("&Leave open"),
        ScanPanel::tr("A step of its own: it stays open whatever the others say"), HoleChoice::left,
        "hole_left");
    menu->popup(at);
}

} // namespace

HoleChoice hole_choice(const std::vector<Hole>& holes, const std::vector<RepairStep>& recipe, std::size_t h) {
    for (const RepairStep& step : recipe)
        if (!step.off && is_of_hole(step, holes, h))
            return step.fill == StepFill::left   ? HoleChoice::left
                   : step.fill == StepFill::flat ? HoleChoice::flat
                                                 : HoleChoice::smooth;
    return HoleChoice::as_all;
}

std::vector<RepairStep> with_hole_choice(const std::vector<Hole>& holes, std::vector<RepairStep> recipe,
                                         std::size_t h, HoleChoice choice) {
    std::erase_if(recipe, [&](const RepairStep& step) { return is_of_hole(step, holes, h); });
    if (choice == HoleChoice::as_all) return recipe;
    RepairStep step{.kind = RepairStep::Kind::hole};
    step.fill = choice == HoleChoice::left   ? StepFill::left
                : choice == HoleChoice::flat ? StepFill::flat
                                             : StepFill::smooth;
    const Hole& hole = holes[h];
    for (std::size_t k = 0; k < step.at.size(); ++k)
        step.at[k] = rounded_place(hole.center[Eigen::Index(k)], hole);
    const auto first = std::find_if(recipe.begin(), recipe.end(),
                                    [](const RepairStep& s) { return s.kind == RepairStep::Kind::holes; });
    recipe.insert(first, step);
    return recipe;
}

void offer_hole_choices(ScanPanel& panel, const std::function<const std::vector<Hole>*()>& holes,
                        const std::vector<RepairStep>& recipe,
                        const std::function<void(const std::vector<RepairStep>&)>& change) {
    QTreeWidget* list = panel.survey();
    list->setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(
        list, &QTreeWidget::customContextMenuRequested, &panel, [&panel, list, &recipe, holes, change] {
            const QTreeWidgetItem* item = list->currentItem(); // a click has chosen it, and so have keys
            if (!item || !item->parent() || list->indexOfTopLevelItem(item->parent()) != int(holes_line))
                return;
            const auto h = std::size_t(list->currentIndex().row());
            const auto* all = holes();
            if (!all || h >= std::min(all->size(), listed_parts)) return;
            show_choices(hole_choice(*all, recipe, h),
                         list->viewport()->mapToGlobal(list->visualItemRect(item).center()), &panel,
                         [h, &recipe, holes, change](HoleChoice choice) {
                             const auto* now = holes();
                             if (now && h < now->size()) change(with_hole_choice(*now, recipe, h, choice));
                         });
        });
}

} // namespace facetmill::ui
