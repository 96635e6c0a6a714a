#include "ui/usual_project_box.h"

#include "core/job/project_setup.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include <algorithm>

namespace facetmill::ui {

UsualProjectBox::UsualProjectBox(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* name, const QString& label) {
        auto* box = new QComboBox(this);
        box->setObjectName(QString::fromLatin1(name));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(22);
        form->addRow(label, box);
        connect(box, &QComboBox::activated, this, &UsualProjectBox::chosen);
        return box;
    };
    machine_ = add("usual_machine", tr("&Machine"));
    for (const Machine& m : machines())
        machine_->addItem(worded(m.label), text(m.name));
    post_ = add("usual_post", tr("&Control"));
    post_->addItem(tr("none: APT only"), QString());
    for (const Post& p : posts())
        post_->addItem(worded(p.label), text(p.name));
    unit_ = add("usual_unit", tr("Meshes are in"));
    unit_->addItem(tr("ask each time"), QString());
    for (const LengthUnit unit : mesh_units)
        unit_->addItem(text(unit_name(unit)), text(unit_name(unit)));
}

settings::UsualProject UsualProjectBox::usual() const {
    return {utf8(machine_->currentData().toString()), utf8(post_->currentData().toString()),
            mesh_unit_of(unit_->currentData().toString())};
}

void UsualProjectBox::set_usual(const settings::UsualProject& usual) {
    const auto choose = [](QComboBox* box, const QString& value) {
        box->setCurrentIndex(std::max(0, box->findData(value)));
    };
    choose(machine_, text(usual.machine.empty() ? Setup().machine : usual.machine));
    choose(post_, text(usual.post));
    choose(unit_, usual.unit ? text(unit_name(*usual.unit)) : QString());
}

} // namespace facetmill::ui
