#include "ui/boundary_box.h"

#include "ui/flow_layout.h"
#include "ui/icons.h"
#include "ui/number_box.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

constexpr int row_gap = 4;

QDoubleSpinBox* number_box(QWidget* parent, const char* name, double most, int decimals) {
    auto* box = new NumberBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setDecimals(decimals);
    box->setMaximum(most);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    return box;
}

QToolButton* word_button(QWidget* parent, const QString& label, const QString& tip, const char* name) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setText(label);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace

BoundaryBox::BoundaryBox(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("boundary_box"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(6);
    start_ = new QPushButton(icon(Icon::edit), QString(), this);
    start_->setObjectName(QStringLiteral("paint"));
    start_->setCheckable(true);
    column->addWidget(start_);
    painting_ = new QWidget(this);
    auto* inner = new QVBoxLayout(painting_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(6);
    build_shapes(inner);
    build_changes(inner);
    column->addWidget(painting_);
    help_ = new QLabel(this);
    help_->setObjectName(QStringLiteral("paint_help"));
    help_->setWordWrap(true);
    help_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(help_);
    connect(start_, &QPushButton::toggled, this, [this](bool on) {
        update_enabled();
        emit activated(on);
    });
    show_kind(Boundary::Kind::facets, LengthUnit::mm);
}

void BoundaryBox::build_shapes(QVBoxLayout* column) {
    auto* holder = new QWidget(painting_);
    auto* shapes = new FlowLayout(holder, row_gap);
    shapes_ = new QButtonGroup(this);
    const auto shape = [&](PaintSettings::Shape which, const QString& label, const QString& tip,
                           const char* name) {
        QToolButton* b = word_button(painting_, label, tip, name);
        b->setCheckable(true);
        shapes_->addButton(b, int(which));
        shapes->addWidget(b);
    };
    using Shape = PaintSettings::Shape;
    shape(Shape::brush, tr("Brush"), tr("Paint what the ring touches"), "paint_brush");
    shape(Shape::flood, tr("Flood"), tr("Paint a face: up to edges where the surface turns by more"),
          "paint_flood");
    shape(Shape::box, tr("Box"), tr("Paint what lies wholly in a rectangle"), "paint_box");
    shapes_->button(int(Shape::brush))->setChecked(true);
    column->addWidget(holder);
    auto* grid = new QGridLayout;
    radius_label_ = new QLabel(tr("Radius"), painting_);
    radius_ = number_box(painting_, "paint_radius", 1e5, 3);
    radius_->setMinimum(0.001);
    radius_->setAccessibleName(radius_label_->text());
    angle_label_ = new QLabel(tr("Angle"), painting_);
    angle_ = number_box(painting_, "paint_angle", 180, 1);
    angle_->setSuffix(QStringLiteral("°"));
    angle_->setValue(20);
    angle_->setAccessibleName(angle_label_->text());
    grid->addWidget(radius_label_, 0, 0);
    grid->addWidget(radius_, 0, 1);
    grid->addWidget(angle_label_, 1, 0);
    grid->addWidget(angle_, 1, 1);
    grid->setColumnStretch(1, 1);
    column->addLayout(grid);
    erase_ = new QCheckBox(tr("Erase"), painting_);
    erase_->setObjectName(QStringLiteral("paint_erase"));
    erase_->setToolTip(tr("Take facets out. Shift does the other of the two."));
    through_ = new QCheckBox(tr("Hidden ones too"), painting_);
    through_->setObjectName(QStringLiteral("paint_through"));
    through_->setToolTip(tr("The box takes facets that are not seen from here as well"));
    column->addWidget(erase_);
    column->addWidget(through_);
    connect(shapes_, &QButtonGroup::idToggled, this, [this](int, bool on) {
        if (!on) return;
        update_enabled();
        emit settings_changed();
    });
    for (QDoubleSpinBox* box : {radius_, angle_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &BoundaryBox::settings_changed);
    for (QCheckBox* box : {erase_, through_})
        connect(box, &QCheckBox::toggled, this, &BoundaryBox::settings_changed);
}

void BoundaryBox::build_changes(QVBoxLayout* column) {
    auto* holder = new QWidget(painting_);
    auto* row = new FlowLayout(holder, row_gap);
    const auto change = [&](Change which, const QString& label, const QString& tip, const char* name) {
        QToolButton* b = word_button(painting_, label, tip, name);
        connect(b, &QToolButton::clicked, this, [this, which] { emit change_wanted(which); });
        row->addWidget(b);
    };
    change(Change::invert, tr("All others"), tr("Facets that are out come in, those that are in go out"),
           "paint_invert");
    change(Change::clear, tr("Clear"), tr("Take all facets out"), "paint_clear");
    change(Change::grow, tr("Grow"), tr("Take in what lies so near, along edges"), "paint_grow");
    change(Change::shrink, tr("Shrink"), tr("Take out what lies so near to the border, along edges"),
           "paint_shrink");
    column->addWidget(holder);
    auto* by = new QHBoxLayout;
    auto* by_label = new QLabel(tr("Grow and shrink by"), painting_);
    by_label->setWordWrap(true);
    by->addWidget(by_label, 1);
    distance_ = number_box(painting_, "paint_distance", 1e5, 3);
    distance_->setSpecialValueText(tr("one ring"));
    distance_->setAccessibleName(by_label->text());
    by->addWidget(distance_, 1);
    column->addLayout(by);
}

void BoundaryBox::show_kind(Boundary::Kind kind, LengthUnit unit) {
    const double per = mm_per(unit_) / mm_per(unit);
    kind_ = kind;
    if (unit != unit_ || radius_->suffix().isEmpty()) {
        const double radius = radius_->value() * per, distance = distance_->value() * per;
        unit_ = unit;
        for (QDoubleSpinBox* box : {radius_, distance_})
            box->setSuffix(QChar(' ') + QString::fromLatin1(unit_name(unit).data()));
        radius_->setValue(radius);
        distance_->setValue(distance);
    }
    update_enabled();
}

void BoundaryBox::update_enabled() {
    const bool facets = kind_ == Boundary::Kind::facets, on = start_->isChecked();
    const PaintSettings::Shape shape = settings().shape;
    start_->setText(facets ? tr("Paint") : tr("Draw curve"));
    painting_->setVisible(facets);
    const bool brush = shape == PaintSettings::Shape::brush, flood = shape == PaintSettings::Shape::flood;
    radius_label_->setVisible(brush);
    radius_->setVisible(brush);
    angle_label_->setVisible(flood);
    angle_->setVisible(flood);
    through_->setVisible(shape == PaintSettings::Shape::box);
    help_->setVisible(on);
    help_->setText(facets
                       ? tr("The left button paints, with Shift it erases; beside the part and with Ctrl "
                            "it turns the view. Esc ends it.")
                       : tr("Clicks on the part add corners; a double click or Enter closes the curve, "
                            "Backspace takes the last corner back. Corners of a closed one can be dragged. "
                            "Esc ends it."));
}

void BoundaryBox::set_active(bool active) {
    start_->setChecked(active);
}

bool BoundaryBox::active() const {
    return start_->isChecked();
}

void BoundaryBox::set_radius(double radius) {
    radius_->setValue(radius / mm_per(unit_));
}

PaintSettings BoundaryBox::settings() const {
    PaintSettings s;
    s.shape = PaintSettings::Shape(shapes_->checkedId());
    s.radius = radius_->value() * mm_per(unit_);
    s.angle = radians(angle_->value());
    s.erase = erase_->isChecked();
    s.through = through_->isChecked();
    return s;
}

double BoundaryBox::distance() const {
    return distance_->value() * mm_per(unit_);
}

} // namespace facetmill::ui
