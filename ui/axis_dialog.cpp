#include "ui/axis_dialog.h"

#include "ui/number_box.h"
#include "ui/operation_list.h"
#include "ui/text.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>

#include <cmath>

namespace facetmill::ui {

Vec3 rounded_axis(const Vec3& direction) {
    constexpr double digits = 1e9;
    const Vec3 unit = direction.normalized();
    return (unit * digits).array().round().matrix() / digits + Vec3::Zero();
}

AxisAngles AxisAngles::of(const Vec3& axis) {
    const double away = axis.head<2>().norm();
    return {degrees(std::atan2(away, axis.z())), away > 0 ? degrees(std::atan2(axis.y(), axis.x())) : 0};
}

Vec3 AxisAngles::axis() const {
    const double lean = radians(tilt), about = radians(towards);
    return rounded_axis(
        Vec3(std::sin(lean) * std::cos(about), std::sin(lean) * std::sin(about), std::cos(lean)));
}

AxisDialog::AxisDialog(const QString& operation, const Vec3& axis, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("axis_dialog"));
    setWindowTitle(tr("Tool axis by angles"));
    auto* head =
        new QLabel(tr("Tool axis of <b>%1</b>, from the tip to the spindle, as the setup holds the part")
                       .arg(elided(operation, 40).toHtmlEscaped()),
                   this);
    head->setWordWrap(true);
    const auto field = [&](const char* name, double low, double high, double value, const QString& tip) {
        auto* box = new NumberBox(this);
        box->setObjectName(QLatin1String(name));
        box->setDecimals(4);
        box->setRange(low, high);
        box->setSuffix(QStringLiteral("°"));
        box->setSingleStep(5);
        box->setValue(value);
        box->setToolTip(tip);
        connect(box, &QDoubleSpinBox::valueChanged, this, &AxisDialog::show_direction);
        return box;
    };
    const AxisAngles angles = AxisAngles::of(axis);
    tilt_ = field("axis_tilt", 0, 180, angles.tilt, tr("0° is upright, 90° level, 180° from below"));
    towards_ = field("axis_towards", -360, 360, angles.towards,
                     tr("Seen from above: 0° leans towards X, 90° towards Y"));
    direction_ = new QLabel(this);
    direction_->setObjectName(QStringLiteral("axis_direction"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* rows = new QFormLayout(this);
    rows->addRow(head);
    rows->addRow(tr("&Tilt from upright"), tilt_);
    rows->addRow(tr("To&wards, from X"), towards_);
    rows->addRow(tr("Direction"), direction_);
    rows->addRow(buttons);
    setMinimumWidth(380);
    show_direction();
    tilt_->selectAll();
}

Vec3 AxisDialog::axis() const {
    return AxisAngles{tilt_->value(), towards_->value()}.axis();
}

void AxisDialog::show_direction() {
    towards_->setEnabled(tilt_->value() > 0 && tilt_->value() < 180);
    const Vec3 a = axis();
    const auto number = [](double v) { return in_user_numbers(QString::number(v, 'g', 5)); };
    direction_->setText(number_list({number(a.x()), number(a.y()), number(a.z())}));
}

void ask_tool_axis(Document& document, std::size_t operation, QWidget* window) {
    const Operation& asked = document.operation(operation);
    auto* dialog = new AxisDialog(text(asked.common().name), asked.tool_axis(), window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QDialog::accepted, window,
                     [&document, dialog, operation] { set_tool_axis(document, operation, dialog->axis()); });
    dialog->open();
}

} // namespace facetmill::ui
