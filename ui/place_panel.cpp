#include "ui/place_panel.h"

#include "ui/flow_layout.h"
#include "ui/icons.h"
#include "ui/place_value.h"
#include "ui/text.h"
#include "ui/value_words.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace facetmill::ui {

namespace {

constexpr int rows_seen = 5;

QToolButton* button(QWidget* parent, Icon which, const QString& label, const QString& tip, const char* name) {
    auto* b = new QToolButton(parent);
    b->setObjectName(QLatin1String(name));
    b->setIcon(icon(which));
    b->setIconSize(QSize(18, 18));
    b->setText(label);
    b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    b->setToolTip(tip);
    b->setFocusPolicy(Qt::TabFocus);
    return b;
}

QLabel* section(const QString& title, QWidget* parent) {
    auto* label = new QLabel(title, parent);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

} // namespace

PlacePanel::PlacePanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("place_panel"));
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 6, 8, 6);
    column->setSpacing(6);
    size_ = new QLabel(content);
    size_->setObjectName(QStringLiteral("place_size"));
    size_->setWordWrap(true);
    extents_ = new QLabel(content);
    extents_->setObjectName(QStringLiteral("place_extents"));
    extents_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(size_);
    column->addWidget(extents_);
    build_list(column);
    build_picks(column);
    build_turns(column);
    build_moves(column);
    build_zero(column);
    column->addStretch(1);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);
    show_box(Box3(), LengthUnit::mm);
}

void PlacePanel::build_list(QVBoxLayout* column) {
    auto* head = new QHBoxLayout;
    auto* title = section(tr("Lay it on a face"), this);
    title->setWordWrap(true);
    head->addWidget(title, 1);
    order_ = new QComboBox(this);
    order_->setObjectName(QStringLiteral("place_order"));
    order_->addItems({tr("Best first"), tr("Largest first")});
    order_->setToolTip(tr("Best: the least surface that faces the table, where no tool from above comes to, "
                          "the most that lies on it, and a firm stand. "
                          "Largest: the most area on the table."));
    head->addWidget(order_);
    column->addLayout(head);
    list_ = new QTreeWidget(this);
    list_->setObjectName(QStringLiteral("place_faces"));
    list_->setAccessibleName(tr("Faces to lie on"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    list_->setColumnCount(tilt_column + 1);
    list_->setTextElideMode(Qt::ElideNone);
    const QString tips[] = {
        tr("Area of the part that lies on the table"),
        tr("Share of the surface that faces the table without lying on it: no tool from above comes there"),
        tr("Height of the part as it lies"), tr("How far the table may be tilted before the part falls")};
    for (int c = contact_column; c <= tilt_column; ++c) {
        list_->headerItem()->setToolTip(c, tips[c]);
        list_->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        list_->header()->setSectionResizeMode(c, QHeaderView::Stretch);
    }
    list_->header()->setSectionsMovable(false);
    list_->header()->setStretchLastSection(false);
    list_->header()->setMinimumSectionSize(30);
    list_->setFixedHeight((rows_seen + 2) * (list_->fontMetrics().height() + 7)
                          + 4); // the header has two lines
    column->addWidget(list_);
    note_ = new QLabel(this);
    note_->setObjectName(QStringLiteral("place_note"));
    note_->setWordWrap(true);
    note_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(note_);
    lay_ = new QPushButton(icon(Icon::place), tr("Lay on this face"), this);
    lay_->setObjectName(QStringLiteral("place_lay"));
    lay_->setToolTip(tr("Turns the part so that the face marked in the view comes down to Z 0"));
    lay_->setEnabled(false);
    column->addWidget(lay_);
    connect(order_, &QComboBox::activated, this, &PlacePanel::order_changed);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
        lay_->setEnabled(chosen().has_value());
        emit face_chosen();
    });
    connect(list_, &QTreeWidget::itemActivated, this, &PlacePanel::lay_wanted);
    connect(lay_, &QPushButton::clicked, this, &PlacePanel::lay_wanted);
}

void PlacePanel::build_picks(QVBoxLayout* column) {
    column->addWidget(section(tr("Pick in the view"), this));
    auto* flow = new QWidget(this);
    auto* row = new FlowLayout(flow, 4);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](PlacePick what, Icon which, const QString& label, const QString& tip,
                         const char* name) {
        QToolButton* b = button(flow, which, label, tip, name);
        b->setCheckable(true);
        connect(b, &QToolButton::clicked, this,
                [this, what](bool on) { emit pick_wanted(on ? what : PlacePick::none); });
        row->addWidget(b);
        picks_.push_back(b);
        of_part_.push_back(b);
    };
    add(PlacePick::face, Icon::lay_on_face, tr("Lay on face"),
        tr("Click a flat face of the part: it comes down to Z 0"), "place_pick_face");
    add(PlacePick::points, Icon::lay_on_points, tr("On 3 points"),
        tr("Click three points of the part: their plane comes down to Z 0"), "place_pick_points");
    add(PlacePick::edge, Icon::align_edge, tr("Edge along X"),
        tr("Click beside an edge of the part: the part turns about Z until the edge runs along X"),
        "place_pick_edge");
    column->addWidget(flow);
}

void PlacePanel::build_turns(QVBoxLayout* column) {
    column->addWidget(section(tr("Turn by 90°"), this));
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    const QString axes[] = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    const char* names[2][3] = {{"place_turn_x", "place_turn_y", "place_turn_z"},
                               {"place_back_x", "place_back_y", "place_back_z"}};
    for (int row = 0; row < 2; ++row)
        for (int axis = 0; axis < 3; ++axis) {
            const QString sign = row == 0 ? QStringLiteral("+") : QStringLiteral("−");
            QToolButton* b = button(this, row == 0 ? Icon::quarter_turn : Icon::quarter_back,
                                    axes[axis] + QChar(' ') + sign,
                                    tr("Turns the part by %190° about %2, by the right hand; its lowest "
                                       "point comes to Z 0")
                                        .arg(sign, axes[axis]),
                                    names[row][axis]);
            b->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
            connect(b, &QToolButton::clicked, this,
                    [this, axis, row] { emit turn_wanted(axis, row == 0 ? 1 : -1); });
            grid->addWidget(b, row, axis);
            of_part_.push_back(b);
        }
    column->addLayout(grid);
    column->addWidget(section(tr("By a value"), this));
    value_row_ = new PlaceValueRow(this);
    of_part_.push_back(value_row_);
    column->addWidget(value_row_);
}

void PlacePanel::build_moves(QVBoxLayout* column) {
    column->addWidget(section(tr("Straighten, move, mirror"), this));
    auto* flow = new QWidget(this);
    auto* row = new FlowLayout(flow, 4);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](Icon which, const QString& label, const QString& tip, const char* name,
                         const auto& wanted) {
        QToolButton* b = button(flow, which, label, tip, name);
        connect(b, &QToolButton::clicked, this, wanted);
        row->addWidget(b);
        of_part_.push_back(b);
    };
    add(Icon::square_up, tr("Square up"),
        tr("Turns the part about Z until its box is smallest, the longer side along X"), "place_square",
        [this] { emit square_wanted(); });
    add(Icon::principal_axes, tr("Principal axes"),
        tr("Turns the part so that it is longest along X and shortest along Z, by the moments of its "
           "surface"),
        "place_principal", [this] { emit principal_wanted(); });
    add(Icon::drop, tr("Drop to Z 0"), tr("Moves the part along Z until its lowest point has Z 0"),
        "place_drop", [this] { emit drop_wanted(); });
    add(Icon::centre, tr("Centre"), tr("Moves the middle of the part's box to X 0, Y 0"), "place_centre",
        [this] { emit centre_wanted(); });
    const char* names[] = {"place_mirror_x", "place_mirror_y", "place_mirror_z"};
    for (int axis = 0; axis < 3; ++axis) {
        const QString letter(QChar(u'X' + char16_t(axis)));
        add(Icon::mirror, tr("Mirror %1").arg(letter),
            tr("Makes the part its mirror image: left and right along %1 change places. A part made so is "
               "another one.")
                .arg(letter),
            names[axis], [this, axis] { emit mirror_wanted(axis); });
    }
    column->addWidget(flow);
}

void PlacePanel::build_zero(QVBoxLayout* column) {
    column->addWidget(section(tr("Work zero"), this));
    zero_text_ = new QLabel(this);
    zero_text_->setObjectName(QStringLiteral("zero_text"));
    zero_text_->setWordWrap(true);
    column->addWidget(zero_text_);
    auto* row = new QHBoxLayout;
    auto* grid = new QGridLayout;
    grid->setSpacing(2);
    for (int i = 0; i < 9; ++i) {
        auto* b = zero_spots_[std::size_t(i)] = new QToolButton(this);
        b->setObjectName(QStringLiteral("zero_%1").arg(i));
        b->setCheckable(true);
        b->setFixedSize(26, 22);
        b->setFocusPolicy(Qt::TabFocus);
        const QString places[] = {tr("low"), tr("middle"), tr("high")};
        b->setToolTip(
            tr("Zero at %1 X, %2 Y of the box, as seen from above").arg(places[i % 3], places[i / 3]));
        b->setAccessibleName(b->toolTip());
        grid->addWidget(b, 2 - i / 3, i % 3);
        of_part_.push_back(b);
        connect(b, &QToolButton::clicked, this, [this, i] {
            for (int k = 0; k < 9; ++k)
                zero_spots_[std::size_t(k)]->setChecked(k == i);
            want_zero();
        });
    }
    row->addLayout(grid);
    auto* side = new QVBoxLayout;
    zero_of_ = new QComboBox(this);
    zero_of_->setObjectName(QStringLiteral("zero_of"));
    zero_of_->addItems({tr("Of the stock"), tr("Of the part")});
    zero_of_->setToolTip(tr("Whose box the zero is on; it goes with it"));
    zero_level_ = new QComboBox(this);
    zero_level_->setObjectName(QStringLiteral("zero_level"));
    zero_level_->addItems({tr("Top"), tr("Middle"), tr("Bottom")});
    zero_level_->setToolTip(tr("At which height of the box the zero is"));
    for (QComboBox* box : {zero_of_, zero_level_}) {
        side->addWidget(box);
        of_part_.push_back(box);
        connect(box, &QComboBox::activated, this, &PlacePanel::want_zero);
    }
    row->addLayout(side, 1);
    column->addLayout(row);
    auto* flow = new QWidget(this);
    auto* buttons = new FlowLayout(flow, 4);
    buttons->setContentsMargins(0, 0, 0, 0);
    QToolButton* pick =
        button(flow, Icon::pick, tr("At a point"),
               tr("Click a point of the part for the zero; a corner nearby is taken exactly"), "zero_pick");
    pick->setCheckable(true);
    connect(pick, &QToolButton::clicked, this,
            [this](bool on) { emit pick_wanted(on ? PlacePick::zero : PlacePick::none); });
    picks_.push_back(pick);
    QToolButton* hole = button(flow, Icon::hole, tr("In a hole"),
                               tr("Click into a round hole, on a boss, or beside a hole on its flat face: "
                                  "the zero comes to its axis, at its upper end"),
                               "zero_hole");
    hole->setCheckable(true);
    connect(hole, &QToolButton::clicked, this,
            [this](bool on) { emit pick_wanted(on ? PlacePick::hole : PlacePick::none); });
    picks_.push_back(hole);
    QToolButton* origin =
        button(flow, Icon::reset, tr("Part's origin"),
               tr("Programs count from the origin of the part's coordinates"), "zero_origin");
    connect(origin, &QToolButton::clicked, this, &PlacePanel::zero_origin_wanted);
    for (QToolButton* b : {pick, hole, origin}) {
        buttons->addWidget(b);
        of_part_.push_back(b);
    }
    column->addWidget(flow);
}

void PlacePanel::want_zero() {
    std::array<double, 3> place{0, 0, 1.0 - zero_level_->currentIndex()};
    for (int i = 0; i < 9; ++i)
        if (zero_spots_[std::size_t(i)]->isChecked()) {
            const int column = i % 3 - 1, row = i / 3 - 1;
            place[0] = column;
            place[1] = row;
        }
    emit zero_wanted(zero_of_->currentIndex() == 1, place);
}

void PlacePanel::show_zero(const ShownZero& zero) {
    zero_text_->setText(kept_together(zero.text));
    for (int i = 0; i < 9; ++i) {
        QToolButton* spot = zero_spots_[std::size_t(i)];
        const int column = i % 3 - 1, row = i / 3 - 1;
        spot->setChecked(!zero.on_origin && zero.place[0] == column && zero.place[1] == row);
        spot->setText(spot->isChecked() ? QStringLiteral("●") : QString());
    }
    if (zero.on_origin) return;
    zero_of_->setCurrentIndex(zero.on_part ? 1 : 0);
    zero_level_->setCurrentIndex(zero.place[2] > 0.5 ? 0 : zero.place[2] > -0.5 ? 1 : 2);
}

LyingOrder PlacePanel::order() const {
    return order_->currentIndex() == 0 ? LyingOrder::best : LyingOrder::largest;
}

std::optional<std::size_t> PlacePanel::chosen() const {
    const auto items = list_->selectedItems();
    if (items.isEmpty()) return std::nullopt;
    return std::size_t(list_->indexOfTopLevelItem(items.front()));
}

void PlacePanel::show_box(const Box3& box, LengthUnit unit, double scale) {
    value_row_->set_unit(unit);
    for (QWidget* w : of_part_)
        w->setEnabled(!box.empty());
    extents_->setVisible(!box.empty());
    if (box.empty()) return size_->setText(tr("No part has been read."));
    const Vec3 s = box.size();
    const double size[3] = {s.x(), s.y(), s.z()};
    const QString said = size_text(size, unit, 5);
    size_->setText(kept_together(scale == 1 ? tr("Size: %1").arg(said)
                                            : tr("Size: %1, scaled by %2").arg(said, number_text(scale, 6))));
    QString rows;
    const auto number = [&](double mm) { return position_text(mm, unit); };
    for (int k = 0; k < 3; ++k)
        rows += QStringLiteral("<tr><td>%1</td><td align=\"right\" style=\"padding-left:10px\">%2</td>"
                               "<td style=\"padding:0 6px\">%3</td><td align=\"right\">%4</td></tr>")
                    .arg(QChar(u'X' + char16_t(k)))
                    .arg(number(box.lo[k]), tr("to"), number(box.hi[k]));
    extents_->setText(QStringLiteral("<table cellspacing=\"0\">%1</table>").arg(rows));
}

void PlacePanel::fill(const std::vector<LyingFace>& faces, LengthUnit unit, const QString& note) {
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        const QString length = text(unit_name(unit));
        list_->setHeaderLabels({tr("Lies,\n%1").arg(length + QStringLiteral("²")), tr("Down"),
                                tr("High,\n%1").arg(length), tr("Falls at")});
        const auto number = [](double v, int digits) { return number_text(v, digits); };
        const double per = mm_per(unit);
        for (const LyingFace& f : faces) {
            auto* item = new QTreeWidgetItem(list_);
            item->setText(contact_column,
                          f.contact_area > 0 ? number(f.contact_area / (per * per), 3) : tr("–"));
            item->setText(down_column, percent_text(f.facing_down));
            item->setText(height_column, number(f.height / per, 4));
            item->setText(tilt_column, QStringLiteral("%1°").arg(degrees(f.tips_at), 0, 'f', 0));
            for (int c = contact_column; c <= tilt_column; ++c) {
                item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
                item->setToolTip(c,
                                 tr("%1 on the table within an outline of %2, %3 of the surface faces down, "
                                    "%4 high, falls at %5°. Double click: lay the part on it.")
                                     .arg(shown_area(f.contact_area, unit), shown_area(f.support_area, unit),
                                          percent_text(f.facing_down), shown_length(f.height, unit, 4))
                                     .arg(degrees(f.tips_at), 0, 'f', 0));
            }
        }
    }
    note_->setText(kept_together(note));
    note_->setVisible(!note.isEmpty());
    lay_->setEnabled(false);
}

void PlacePanel::show_picking(PlacePick picking) {
    for (std::size_t i = 0; i < picks_.size(); ++i)
        picks_[i]->setChecked(int(i) + 1 == int(picking));
}

} // namespace facetmill::ui
