#include "ui/part_dialog.h"

#include "ui/text.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QRadioButton>
#include <QVBoxLayout>

namespace facetmill::ui {

PartDialog::PartDialog(const QString& file, const MeshReport& report, LengthUnit suggestion, QWidget* parent)
    : QDialog(parent) {
    setObjectName(QStringLiteral("part_dialog"));
    setWindowTitle(tr("Unit of the part"));
    const Vec3 size = report.file_box.size();
    const auto size_in = [&](LengthUnit file_unit, LengthUnit shown) {
        const double s[3] = {size.x() * mm_per(file_unit), size.y() * mm_per(file_unit),
                             size.z() * mm_per(file_unit)};
        return size_text(s, shown, 4);
    };

    auto* question =
        new QLabel(tr("<b>%1</b> holds %2 facets and does not say in which unit. How large is the part?")
                       .arg(elided(file, 48).toHtmlEscaped(), count_text(report.facets)),
                   this);
    question->setWordWrap(true);
    question->setToolTip(file);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(18);
    grid->setContentsMargins(12, 6, 12, 6);
    const std::array<std::pair<QString, const char*>, mesh_units.size()> names{{
        {tr("Millimetres"), "unit_mm"},
        {tr("Centimetres"), "unit_cm"},
        {tr("Metres"), "unit_m"},
        {tr("Inches"), "unit_inch"},
        {tr("Feet"), "unit_ft"},
    }};
    for (std::size_t i = 0; i < mesh_units.size(); ++i) {
        const LengthUnit unit = mesh_units[i];
        auto* choice = choices_[i] = new QRadioButton(names[i].first, this);
        choice->setObjectName(QLatin1String(names[i].second));
        choice->setChecked(unit == suggestion);
        // In the unit that a project has, or where that is the same, in the other one.
        LengthUnit other = project_unit(unit);
        if (other == unit) other = unit == LengthUnit::mm ? LengthUnit::inch : LengthUnit::mm;
        auto* own = new QLabel(size_in(unit, unit), this);
        auto* converted = new QLabel(QStringLiteral("= ") + size_in(unit, other), this);
        converted->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(choice, int(i), 0);
        grid->addWidget(own, int(i), 1);
        grid->addWidget(converted, int(i), 2);
    }
    remember_ = new QCheckBox(tr("Do not ask again for this file"), this);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* column = new QVBoxLayout(this);
    column->addWidget(question);
    column->addLayout(grid);
    column->addWidget(remember_);
    column->addSpacing(6);
    column->addWidget(buttons);
    setMinimumWidth(440);
}

LengthUnit PartDialog::unit() const {
    for (std::size_t i = 0; i < mesh_units.size(); ++i)
        if (choices_[i]->isChecked()) return mesh_units[i];
    return LengthUnit::mm;
}

bool PartDialog::remember() const {
    return remember_->isChecked();
}

} // namespace facetmill::ui
