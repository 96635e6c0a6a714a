#include "ui/layer_bar.h"

#include "ui/flow_layout.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "viz/palette.h"
#include "viz/scene.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStandardItemModel>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

struct Entry {
    ViewLayer layer;
    const char *name, *label, *help;
    bool shown;
};

constexpr Entry entries[] = {
    {ViewLayer::part, "part", QT_TRANSLATE_NOOP("LayerBar", "Part"),
     QT_TRANSLATE_NOOP("LayerBar", "The part's surface"), true},
    {ViewLayer::edges, "edges", QT_TRANSLATE_NOOP("LayerBar", "Edges"),
     QT_TRANSLATE_NOOP("LayerBar", "The edges of all facets"), false},
    {ViewLayer::stock, "stock", QT_TRANSLATE_NOOP("LayerBar", "Stock"),
     QT_TRANSLATE_NOOP("LayerBar", "The raw material; during playback as it is cut"), false},
    {ViewLayer::deviation, "deviation", QT_TRANSLATE_NOOP("LayerBar", "Deviation"),
     QT_TRANSLATE_NOOP("LayerBar", "The part in the colours of what the verification found"), true},
    {ViewLayer::regions, "regions", QT_TRANSLATE_NOOP("LayerBar", "Regions"),
     QT_TRANSLATE_NOOP("LayerBar", "Rework and clean-up regions on the part's surface"), true},
    {ViewLayer::cc, "cc", QT_TRANSLATE_NOOP("LayerBar", "CC"),
     QT_TRANSLATE_NOOP("LayerBar", "Cutter contacts: the points of the part that are cut"), false},
    {ViewLayer::cuts, "cuts", QT_TRANSLATE_NOOP("LayerBar", "CL cuts"),
     QT_TRANSLATE_NOOP("LayerBar", "Cutter locations: the path of the tool tip while it cuts"), true},
    {ViewLayer::links, "links", QT_TRANSLATE_NOOP("LayerBar", "Links"),
     QT_TRANSLATE_NOOP("LayerBar", "Links between cuts, approach and retract, at feed"), true},
    {ViewLayer::rapids, "rapids", QT_TRANSLATE_NOOP("LayerBar", "Rapids"),
     QT_TRANSLATE_NOOP("LayerBar", "Clearance moves at rapid speed"), true},
    {ViewLayer::tool, "tool", QT_TRANSLATE_NOOP("LayerBar", "Tool"),
     QT_TRANSLATE_NOOP("LayerBar", "The tool at the picked point of the path"), true},
    {ViewLayer::others, "others", QT_TRANSLATE_NOOP("LayerBar", "Others"),
     QT_TRANSLATE_NOOP("LayerBar", "The paths of all operations, not that of the chosen one alone"), false},
};

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
        low_ = ui::text(format_number(path->low, 3));
        high_ = ui::text(format_number(path->high, 3) + (path->unit == "°" ? "" : " ") + path->unit);
        setToolTip(
            LayerBar::tr("%1 from %2 to %3").arg(ui::text(path_quantity_label(path->quantity)), low_, high_));
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
    static constexpr int bar = 64, gap = 5;
    QString low_, high_;
};

LayerBar::LayerBar(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("layer_bar"));
    auto* flow = new FlowLayout(this, 14);
    flow->setContentsMargins(8, 4, 8, 4);
    for (const Entry& e : entries) {
        auto* box = new QCheckBox(tr(e.label), this);
        box->setObjectName(QStringLiteral("layer_") + QLatin1String(e.name));
        box->setToolTip(tr(e.help));
        box->setChecked(e.shown);
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QCheckBox::toggled, this, &LayerBar::toggled);
        connect(box, &QCheckBox::clicked, this, [this, layer = e.layer] { std::erase(aside_, layer); });
        flow->addWidget(box);
        if (e.layer == ViewLayer::others) box->hide(); // until there are any
        boxes_.push_back(box);
    }
    auto* colors = new QWidget(this);
    auto* row = new QHBoxLayout(colors);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    quantity_ = new QComboBox(colors);
    quantity_->setObjectName(QStringLiteral("path_quantity"));
    quantity_->setToolTip(tr("What the colours of the path mean; their scale stands in the view"));
    quantity_->setFocusPolicy(Qt::TabFocus);
    for (std::size_t q = 0; q < path_quantities; ++q)
        quantity_->addItem(ui::text(path_quantity_label(PathQuantity(q))));
    auto* label = new QLabel(tr("Path by"), colors);
    label->setBuddy(quantity_);
    row->addWidget(label);
    row->addWidget(quantity_);
    scale_ = new ScaleStrip(colors);
    scale_->hide();
    row->addWidget(scale_);
    connect(quantity_, &QComboBox::currentIndexChanged, this, &LayerBar::quantity_chosen);
    flow->addWidget(colors);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
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

void LayerBar::put_paths_aside() {
    for (const ViewLayer layer : {ViewLayer::cc, ViewLayer::cuts, ViewLayer::links, ViewLayer::rapids})
        if (shown(layer)) {
            aside_.push_back(layer);
            set_shown(layer, false);
        }
}

void LayerBar::bring_paths_back() {
    for (const ViewLayer layer : std::exchange(aside_, {}))
        set_shown(layer, true);
}

QStringList LayerBar::shown_names() const {
    QStringList names;
    for (const Entry& e : entries)
        if (shown(e.layer) || std::find(aside_.begin(), aside_.end(), e.layer) != aside_.end())
            names << QLatin1String(e.name);
    return names;
}

void LayerBar::set_shown_names(const QStringList& names) {
    aside_.clear();
    for (const Entry& e : entries)
        set_shown(e.layer, names.contains(QLatin1String(e.name)));
}

void LayerBar::apply(Scene& scene) const {
    scene.set_visible(Layer::part, shown(ViewLayer::part));
    scene.set_visible(Layer::edges, shown(ViewLayer::edges));
    scene.set_visible(Layer::stock, shown(ViewLayer::stock));
    scene.set_visible(Layer::deviation, shown(ViewLayer::deviation));
    scene.set_visible(Layer::findings, shown(ViewLayer::deviation));
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
