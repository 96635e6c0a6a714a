// What the view shows, as check boxes behind one button, and what the path's colours mean. Wraps where the
// window is narrow.
#pragma once

#include "viz/path_tint.h"

#include <QStringList>
#include <QWidget>

#include <set>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace facetmill {
class Scene;
}

namespace facetmill::ui {

/// What a user tells apart: the scene's layers, with the motions of a path split by kind; `others`: paths of
/// operations beside the chosen one.
enum class ViewLayer {
    part,
    edges,
    stock,
    deviation,
    regions,
    cc,
    cuts,
    links,
    rapids,
    tool,
    others,
    preview
};

using LayerSet = std::set<ViewLayer>;
/// For settings; names that are not known are passed over.
QStringList layer_names(const LayerSet& layers);
LayerSet layers_named(const QStringList& names);
QStringList all_layer_names();

class ScaleStrip;

class LayerBar : public QWidget {
    Q_OBJECT
public:
    explicit LayerBar(QWidget* parent = nullptr);

    bool shown(ViewLayer layer) const;
    void set_shown(ViewLayer layer, bool on);
    QCheckBox* box(ViewLayer layer) const;
    LayerSet shown_set() const;
    /// All at once: those who listen hear of it once.
    void set_shown_set(const LayerSet& layers);
    /// Hands all check marks to the scene.
    void apply(Scene& scene) const;
    /// The menu of the check boxes.
    QToolButton* menu_button() { return show_; }
    /// Whether the colours of paths can be chosen, where there are paths to see.
    void offer_colours(bool on);
    /// What the path's colours are to mean.
    PathQuantity quantity() const;
    QComboBox* quantity_box() { return quantity_; }
    /// The ends of the scale beside the choice, for views too small for a legend; nullptr: none.
    void show_scale(const TintedPathPtr& path);
    /// Why a quantity cannot be chosen; empty: it can. One that was chosen before stays so.
    void set_quantity_missing(PathQuantity quantity, const QString& why);

signals:
    void toggled();
    void quantity_chosen();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    int width_without_label() const;
    void add_boxes();
    void add_colours();

    std::vector<QCheckBox*> boxes_;
    QToolButton* show_ = nullptr;
    QWidget* colours_ = nullptr;
    QLabel* label_ = nullptr;
    QComboBox* quantity_ = nullptr;
    ScaleStrip* scale_ = nullptr;
};

} // namespace facetmill::ui
