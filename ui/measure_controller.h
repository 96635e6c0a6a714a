// Distances and angles on the part: two clicks, a line between them with its length.
#pragma once

#include "ui/controller.h"

#include <vector>

namespace facetmill::ui {

class MeasureOverlay;
class Messages;
class Viewport;

/// What lies between two places of the part that were clicked.
struct Measurement {
    Vec3 from, to;
    double angle = 0; ///< between the surface at the one and at the other, as they are seen; radians
};
/// "Distance 12.5 mm, X 3 mm, Y 4 mm, Z 11.456 mm; faces at 37.5°".
QString measurement_text(const Measurement& m, LengthUnit unit);

class MeasureController : public Controller {
    Q_OBJECT
public:
    MeasureController(Document& document, Viewport& viewport, Messages& messages, QObject* window);
    ~MeasureController() override;

    bool active() const { return active_; }
    /// Clicks are for measuring, or no more. A third click begins anew.
    void set_active(bool on);
    void leave() { set_active(false); }
    /// None before the second click.
    std::optional<Measurement> measured() const;

    void project_opened() override { set_active(false); }
    void project_changed() override { show(); } // it may have another unit
    void part_changed() override { clear(); }
    /// Esc ends it.
    bool take_key(const QKeyEvent& event) override;

signals:
    /// A click in the view is for measuring now.
    void measuring_begun();
    /// It began or ended.
    void switched();

private:
    void take(const PartPick& pick);
    void show();
    void clear();

    Document& document_;
    Viewport& viewport_;
    Messages& messages_;
    MeasureOverlay* overlay_ = nullptr;
    bool active_ = false;
    std::vector<Vec3> points_, normals_; ///< clicked so far: one or two
};

} // namespace facetmill::ui
