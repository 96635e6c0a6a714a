// Points for parameters, picked by a click on the part.
#pragma once

#include "ui/controller.h"

namespace facetmill::ui {

class Messages;
class PropertiesPanel;
class Viewport;

class PointPicker : public Controller {
    Q_OBJECT
public:
    PointPicker(Document& document, Viewport& viewport, PropertiesPanel& properties, Messages& messages,
                QObject* window);

    /// Esc ends the picking.
    bool take_key(const QKeyEvent& event) override;

private:
    void begin(const std::string& key);
    void take(const std::optional<PartPick>& pick, Qt::KeyboardModifiers modifiers);
    void end();

    Document& document_;
    Viewport& viewport_;
    PropertiesPanel& properties_;
    Messages& messages_;
    std::string key_; ///< parameter whose point is being picked; empty: none
};

} // namespace facetmill::ui
