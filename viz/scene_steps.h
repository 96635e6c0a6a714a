// A picture in steps: large things piece by piece, then everything else, then smoothing and what is flat on
// top.
#pragma once

#include "core/base/vec.h"
#include "viz/scene_actor.h"

#include <cstdint>
#include <optional>
#include <vector>

class vtkRenderer;

namespace facetmill {

/// What the steps before the last draw, of what is visible, in this order.
struct HeavyActors {
    std::vector<SceneActor*> surfaces, lines;
};

class SceneSteps {
public:
    /// Groups the visible ones. `apart`, unless null, is drawn once more before all others. Returns the
    /// number of steps.
    std::size_t begin(const HeavyActors& heavy, SceneActor* apart);
    void set(std::size_t step);
    /// The picture is a whole one again. To be called before actors go that a group may name.
    void forget();

    bool running() const { return step_.has_value(); }
    /// What the first picture begins with; the steps before only bring points to the graphics card.
    bool erases() const { return !step_ || *step_ <= first_; }
    bool smooths() const { return !step_ || *step_ == groups_.size() + 1; }
    /// Draws what is flat on top of everything.
    bool last() const { return !step_ || *step_ == last_of_all(); }
    /// Hides what the present step leaves out of what is shown.
    void hide_others(vtkRenderer* renderer) const;

private:
    /// All that is light; then the smoothing, for which what it smooths must be drawn; then what is flat.
    bool light() const { return *step_ == groups_.size(); }
    std::size_t last_of_all() const { return groups_.size() + 2; }

    std::optional<std::size_t> step_;
    std::vector<std::vector<SceneActor*>> groups_;
    std::size_t first_ = 0;
};

/// Something small in the ways that actors look: for the shaders, not to be seen.
class SceneRehearsal {
public:
    explicit SceneRehearsal(vtkRenderer* renderer) : renderer_(renderer) {}
    ~SceneRehearsal();

    /// A triangle at a place of the view, with its size across and up.
    void begin(const Vec3& center, const Vec3& right, const Vec3& up);
    void end();
    bool running() const { return running_; }

    /// Each in the look of another actor.
    void triangle(const SceneActor& like);
    void unlit_triangle(const SceneActor& like);
    void colored_triangle(const SceneActor& like);
    void segments(const SceneActor& like);
    void dots(const SceneActor& like);
    /// Nothing but these.
    void show();

private:
    void add(const SceneActor& like, vtkPolyData* data);

    vtkRenderer* renderer_;
    bool running_ = false;
    Vec3 center_ = Vec3::Zero();
    std::vector<float> points_; ///< behind the actors' data
    SceneActors actors_;
};

} // namespace facetmill
