// The zero of the work coordinates in a scene: three short axes and its name.
#pragma once

#include "viz/scene_layer.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace facetmill {

struct OverlayContent; // overlay.h

struct ZeroMark {
    Vec3 point = Vec3::Zero();
    double length = 1; ///< of the axes, mm
    std::string name;  ///< "G54"
    bool operator==(const ZeroMark& o) const {
        return point == o.point && length == o.length && name == o.name;
    }
};

class SceneZero : public SceneLayer {
public:
    explicit SceneZero(SceneStage& stage);

    /// None: nullopt. Shown whatever the layers of the view are.
    void set(const std::optional<ZeroMark>& mark);
    const std::optional<ZeroMark>& mark() const { return mark_; }
    void add_to(OverlayContent& content) const;

private:
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;

    std::optional<ZeroMark> mark_;
    std::array<std::vector<float>, 3> points_; ///< behind the actors' data
    std::vector<std::int32_t> segments_{0, 1};
    std::array<SceneActor, 3> axes_;
};

} // namespace facetmill
