// Points and tool axes for parameters, picked by a click on the part.
#pragma once

#include "ui/controller.h"

namespace facetmill::ui {

class Messages;
class PropertiesPanel;
class Viewport;

/// The corner of the facet that lies within some pixels of a click, or the place that was met.
Vec3 snapped_point(const Viewport& viewport, const Mesh& mesh, const PartPick& pick);

class PointPicker : public Controller {
    Q_OBJECT
public:
    PointPicker(Document& document, Viewport& viewport, PropertiesPanel& properties, Messages& messages,
                QObject* window);

    /// Esc ends the picking.
    bool take_key(const QKeyEvent& event) override;
    void leave() { end(); }

signals:
    /// A click in the view is for a parameter now.
    void picking_begun();

private:
    void begin(const std::string& key);
    void take(const std::optional<PartPick>& pick, Qt::KeyboardModifiers modifiers);
    void take_axis(const Vec3& axis);
    bool is_axis() const; ///< it is no point that is picked
    void end();

    Document& document_;
    Viewport& viewport_;
    PropertiesPanel& properties_;
    Messages& messages_;
    std::string key_; ///< parameter whose point is being picked; empty: none
};

} // namespace facetmill::ui
