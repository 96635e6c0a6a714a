#include "ui/layer_bar.h"

#include "ui/flow_layout.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"
#include "viz/palette.h"
#include "viz/scene.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include <algorithm>

namespace facetmill::ui {

namespace {

struct Entry {
    ViewLayer layer;
    const char *name, *label, *help;
};

constexpr Entry entries[] = {
    {ViewLayer::part, "part", QT_TRANSLATE_NOOP("LayerBar", "Part"),
     QT_TRANSLATE_NOOP("LayerBar", "The part's surface")},
    {ViewLayer::edges, "edges", QT_TRANSLATE_NOOP("LayerBar", "Edges"),
     QT_TRANSLATE_NOOP("LayerBar", "The edges of all facets")},
    {ViewLayer::stock, "stock", QT_TRANSLATE_NOOP("LayerBar", "Stock"),
     QT_TRANSLATE_NOOP("LayerBar", "The raw material; during playback as it is cut")},
    {ViewLayer::deviation, "deviation", QT_TRANSLATE_NOOP("LayerBar", "Deviation"),
     QT_TRANSLATE_NOOP("LayerBar", "The part in the colours of what the verification found")},
    {ViewLayer::regions, "regions", QT_TRANSLATE_NOOP("LayerBar", "Regions"),
     QT_TRANSLATE_NOOP("LayerBar", "Rework and clean-up regions on the part's surface")},
    {ViewLayer::cc, "cc", QT_TRANSLATE_NOOP("LayerBar", "CC"),
     QT_TRANSLATE_NOOP("LayerBar", "Cutter contacts: the points of the part that are cut")},
    {ViewLayer::cuts, "cuts", QT_TRANSLATE_NOOP("LayerBar", "CL cuts"),
     QT_TRANSLATE_NOOP("LayerBar", "Cutter locations: the path of the tool tip while it cuts")},
    {ViewLayer::links, "links", QT_TRANSLATE_NOOP("LayerBar", "Links"),
     QT_TRANSLATE_NOOP("LayerBar", "Links between cuts, approach and retract, at feed")},
    {ViewLayer::rapids, "rapids", QT_TRANSLATE_NOOP("LayerBar", "Rapids"),
     QT_TRANSLATE_NOOP("LayerBar", "Clearance moves at rapid speed")},
    {ViewLayer::tool, "tool", QT_TRANSLATE_NOOP("LayerBar", "Tool"),
     QT_TRANSLATE_NOOP("LayerBar", "The tool at the picked point of the path")},
    {ViewLayer::others, "others", QT_TRANSLATE_NOOP("LayerBar", "Others"),
     QT_TRANSLATE_NOOP("LayerBar", "The paths of all operations, not that of the chosen one alone")},
    {ViewLayer::preview, "preview", QT_TRANSLATE_NOOP("LayerBar", "Preview"),
     QT_TRANSLATE_NOOP("LayerBar",
                       "How the passes of the chosen operation will about run, until it is planned")},
};

/// Margins and gaps of the row.
constexpr int room_between = 40;

} // namespace

/// "0.5 [colours] 12 °".
class ScaleStrip : public QWidget {
public:
    explicit ScaleStrip(QWidget* parent) : QWidget(parent) {
        setObjectName(QStringLiteral("path_scale"));
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    void show_path(const TintedPathPtr& path) {
        setVisible(path != nullptr);
        if (!path) return;
        low_ = ui::number_text(path->low, 3);
        high_ = ui::number_text(path->high, 3) + (path->unit == "°" ? QString() : QStringLiteral(" "))
                + ui::worded(path->unit);
        setToolTip(LayerBar::tr("%1 from %2 to %3")
                       .arg(ui::worded(path_quantity_label(path->quantity)), low_, high_));
        updateGeometry();
        update();
    }
    QSize sizeHint() const override {
        const QFontMetrics fm(font());
        return {fm.horizontalAdvance(low_) + fm.horizontalAdvance(high_) + bar + 2 * gap, fm.height() + 2};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter p(this);
        const QFontMetrics fm(font());
        constexpr int high = 10;
        const int x = fm.horizontalAdvance(low_) + gap, y = (height() - high) / 2;
        p.setPen(palette().color(QPalette::WindowText));
        p.drawText(QRect(0, 0, x, height()), int(Qt::AlignLeft | Qt::AlignVCenter), low_);
        for (int i = 0; i < bar; ++i) {
            p.fillRect(x + i, y, 1, high, to_qt(path_tint_color((i + 0.5) / bar)));
        }
        p.drawText(QRect(x + bar + gap, 0, width(), height()), int(Qt::AlignLeft | Qt::AlignVCenter), high_);
    }

private:
    static constexpr int bar = 40, gap = 5;
    QString low_, high_;
};

QStringList layer_names(const LayerSet& layers) {
    QStringList names;
    for (const Entry& e : entries)
        if (layers.contains(e.layer)) names << QLatin1String(e.name);
    return names;
}

QStringList all_layer_names() {
    QStringList names;
    for (const Entry& e : entries)
        names << QLatin1String(e.name);
    return names;
}

LayerSet layers_named(const QStringList& names) {
    LayerSet layers;
    for (const Entry& e : entries)
        if (names.contains(QLatin1String(e.name))) layers.insert(e.layer);
    return layers;
}

LayerBar::LayerBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("layer_bar"));
    auto* flow = new FlowLayout(this, 10);
    flow->setContentsMargins(8, 0, 8, 0);
    add_boxes();
    flow->addWidget(show_);
    add_colours();
    flow->addWidget(colours_);
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMinimumWidth(show_->sizeHint().width() + 16);
}

void LayerBar::add_boxes() {
    auto* menu = new QMenu(this);
    auto* list = new QWidget(menu);
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(10, 6, 14, 6);
    column->setSpacing(4);
    for (const Entry& e : entries) {
        auto* box = new QCheckBox(tr(e.label), list);
        box->setObjectName(QStringLiteral("layer_") + QLatin1String(e.name));
        box->setToolTip(tr(e.help));
        connect(box, &QCheckBox::toggled, this, &LayerBar::toggled);
        column->addWidget(box);
        if (e.layer == ViewLayer::others) box->hide(); // until there are any
        boxes_.push_back(box);
    }
    auto* entry = new QWidgetAction(menu);
    entry->setDefaultWidget(list);
    menu->addAction(entry);
    // Opened by a key, the menu leads to its first box.
    connect(menu, &QMenu::aboutToShow, list, [this, list] {
        list->adjustSize();
        QTimer::singleShot(0, list, [this] { boxes_.front()->setFocus(Qt::PopupFocusReason); });
    });
    show_ = new QToolButton(this);
    show_->setObjectName(QStringLiteral("layer_menu"));
    show_->setText(tr("Show"));
    show_->setToolTip(tr("What the view shows"));
    show_->setPopupMode(QToolButton::InstantPopup);
    show_->setAutoRaise(true);
    show_->setFocusPolicy(Qt::TabFocus);
    show_->setMenu(menu);
}

void LayerBar::add_colours() {
    colours_ = new QWidget(this);
    auto* row = new QHBoxLayout(colours_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    quantity_ = new QComboBox(colours_);
    quantity_->setObjectName(QStringLiteral("path_quantity"));
    quantity_->setToolTip(tr("What the colours of the path mean; their scale stands in the view"));
    quantity_->setFocusPolicy(Qt::TabFocus);
    quantity_->setMinimumContentsLength(8);
    quantity_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (std::size_t q = 0; q < path_quantities; ++q)
        quantity_->addItem(ui::worded(path_quantity_label(PathQuantity(q))));
    label_ = new QLabel(tr("Path by"), colours_);
    label_->setBuddy(quantity_);
    row->addWidget(label_);
    row->addWidget(quantity_);
    scale_ = new ScaleStrip(colours_);
    scale_->hide();
    row->addWidget(scale_);
    connect(quantity_, &QComboBox::currentIndexChanged, this, &LayerBar::quantity_chosen);
}

int LayerBar::width_without_label() const {
    return show_->sizeHint().width() + quantity_->sizeHint().width() + room_between;
}

void LayerBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // A narrow window has no room for the word; the box says the same by its tip.
    label_->setVisible(event->size().width() >= width_without_label() + label_->sizeHint().width());
}

void LayerBar::offer_colours(bool on) {
    colours_->setVisible(on);
}

QCheckBox* LayerBar::box(ViewLayer layer) const {
    return boxes_[std::size_t(layer)];
}

void LayerBar::show_scale(const TintedPathPtr& path) {
    scale_->show_path(path);
}

PathQuantity LayerBar::quantity() const {
    return PathQuantity(std::max(0, quantity_->currentIndex()));
}

void LayerBar::set_quantity_missing(PathQuantity quantity, const QString& why) {
    auto* model = qobject_cast<QStandardItemModel*>(quantity_->model());
    QStandardItem* item = model ? model->item(int(quantity)) : nullptr;
    if (!item) return;
    item->setEnabled(why.isEmpty());
    item->setToolTip(why);
}

bool LayerBar::shown(ViewLayer layer) const {
    return box(layer)->isChecked();
}

void LayerBar::set_shown(ViewLayer layer, bool on) {
    box(layer)->setChecked(on);
}

LayerSet LayerBar::shown_set() const {
    LayerSet layers;
    for (const Entry& e : entries)
        if (shown(e.layer)) layers.insert(e.layer);
    return layers;
}

void LayerBar::set_shown_set(const LayerSet& layers) {
    bool changed = false;
    for (const Entry& e : entries) {
        const QSignalBlocker quiet(box(e.layer));
        changed = changed || shown(e.layer) != layers.contains(e.layer);
        set_shown(e.layer, layers.contains(e.layer));
    }
    if (changed) emit toggled();
}

void LayerBar::apply(Scene& scene) const {
    scene.set_visible(Layer::part, shown(ViewLayer::part));
    scene.set_visible(Layer::edges, shown(ViewLayer::edges));
    scene.set_visible(Layer::stock, shown(ViewLayer::stock));
    scene.set_visible(Layer::deviation, shown(ViewLayer::deviation));
    scene.set_visible(Layer::findings, shown(ViewLayer::deviation));
    scene.preview().set_visible(shown(ViewLayer::preview));
    scene.set_visible(Layer::strips, shown(ViewLayer::regions));
    scene.set_visible(Layer::cc, shown(ViewLayer::cc));
    scene.set_visible(Layer::tool, shown(ViewLayer::tool));
    const bool links = shown(ViewLayer::links);
    scene.paths().set_visible(MotionKind::cut, shown(ViewLayer::cuts));
    scene.paths().set_visible(MotionKind::link, links);
    scene.paths().set_visible(MotionKind::approach, links);
    scene.paths().set_visible(MotionKind::retract, links);
    scene.paths().set_visible(MotionKind::rapid, shown(ViewLayer::rapids));
    scene.set_visible(Layer::cl, shown(ViewLayer::cuts) || links || shown(ViewLayer::rapids));
}

} // namespace facetmill::ui
