// Dots in a scene where the verification found something.
#pragma once

#include "viz/scene_layer.h"

#include <array>

namespace facetmill {

struct Verification;

/// A place where the verification found something.
struct FindingMark {
    enum class Kind { gouge, excess, collision };
    Kind kind = Kind::gouge;
    Vec3 point = Vec3::Zero();
};
inline constexpr std::size_t finding_kinds = 3;
/// The deepest gouges, the places where most is left, and at most a few hundred collisions.
std::vector<FindingMark> finding_marks(const Verification& verification);

class SceneFindings : public SceneLayer {
public:
    explicit SceneFindings(SceneStage& stage);

    void set(const std::vector<FindingMark>& findings);

private:
    bool has(Layer layer) const override;
    void apply_palette(const Colors& colors) override;
    void apply_line_widths() override;
    void apply_visibility(ShownSurface shown) override;
    void add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const override;
    void rehearse(std::size_t k, SceneRehearsal& rehearsal) override;

    /// One each per kind.
    std::array<SceneActor, finding_kinds> dots_;
    std::array<std::vector<float>, finding_kinds> points_; ///< behind the actors' data
};

} // namespace facetmill
