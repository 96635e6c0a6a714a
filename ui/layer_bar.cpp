#include "ui/layer_bar.h"

#include "ui/flow_layout.h"
#include "viz/scene.h"

#include <QCheckBox>

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
};

} // namespace

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
        flow->addWidget(box);
        boxes_.push_back(box);
    }
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

QCheckBox* LayerBar::box(ViewLayer layer) const {
    return boxes_[std::size_t(layer)];
}

bool LayerBar::shown(ViewLayer layer) const {
    return box(layer)->isChecked();
}

void LayerBar::set_shown(ViewLayer layer, bool on) {
    box(layer)->setChecked(on);
}

QStringList LayerBar::shown_names() const {
    QStringList names;
    for (const Entry& e : entries)
        if (shown(e.layer)) names << QLatin1String(e.name);
    return names;
}

void LayerBar::set_shown_names(const QStringList& names) {
    for (const Entry& e : entries)
        set_shown(e.layer, names.contains(QLatin1String(e.name)));
}

void LayerBar::apply(Scene& scene) const {
    scene.set_visible(Layer::part, shown(ViewLayer::part));
    scene.set_visible(Layer::edges, shown(ViewLayer::edges));
    scene.set_visible(Layer::stock, shown(ViewLayer::stock));
    scene.set_visible(Layer::deviation, shown(ViewLayer::deviation));
    scene.set_visible(Layer::findings, shown(ViewLayer::deviation));
    scene.set_visible(Layer::cc, shown(ViewLayer::cc));
    scene.set_visible(Layer::tool, shown(ViewLayer::tool));
    const bool links = shown(ViewLayer::links);
    scene.set_motion_visible(MotionKind::cut, shown(ViewLayer::cuts));
    scene.set_motion_visible(MotionKind::link, links);
    scene.set_motion_visible(MotionKind::approach, links);
    scene.set_motion_visible(MotionKind::retract, links);
    scene.set_motion_visible(MotionKind::rapid, shown(ViewLayer::rapids));
    scene.set_visible(Layer::cl, shown(ViewLayer::cuts) || links || shown(ViewLayer::rapids));
}

} // namespace facetmill::ui
