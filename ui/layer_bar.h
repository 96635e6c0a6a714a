// Check boxes for what the view shows, and what the path's colours mean. Wraps where the window is narrow.
#pragma once

#include "viz/path_tint.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;

namespace facetmill {
class Scene;
}

namespace facetmill::ui {

/// What a user tells apart: the scene's layers, with the motions of a path split by kind; `others`: paths of
/// operations beside the chosen one.
enum class ViewLayer { part, edges, stock, deviation, regions, cc, cuts, links, rapids, tool, others };

class ScaleStrip;

class LayerBar : public QWidget {
    Q_OBJECT
public:
    explicit LayerBar(QWidget* parent = nullptr);

    bool shown(ViewLayer layer) const;
    void set_shown(ViewLayer layer, bool on);
    QCheckBox* box(ViewLayer layer) const;
    /// Switches paths and contacts off until `bring_paths_back`: they would cover what is looked at. What the
    /// user switches meanwhile stays as it is switched; settings have what is put aside as shown.
    void put_paths_aside();
    void bring_paths_back();
    /// The shown layers by name, for settings; names that are not known are passed over.
    QStringList shown_names() const;
    void set_shown_names(const QStringList& names);
    /// Hands all check marks to the scene.
    void apply(Scene& scene) const;
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

private:
    std::vector<QCheckBox*> boxes_;
    std::vector<ViewLayer> aside_;
    QComboBox* quantity_ = nullptr;
    ScaleStrip* scale_ = nullptr;
};

} // namespace facetmill::ui
