// An actor of a scene with its mapper, and a large thing in several of them.
#pragma once

#include "core/base/vec.h"

#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProperty;

namespace facetmill {

struct Rgb;
struct SceneStage;

/// Hidden until it has data. The arrays behind the data belong to whoever made them.
struct SceneActor {
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    bool filled = false;

    SceneActor();
    ~SceneActor();
    SceneActor(const SceneActor&) = delete;
    SceneActor& operator=(const SceneActor&) = delete;

    void set_data(vtkPolyData* data, const Vec3& center);
    void clear();
    /// Every place p is seen at turn * p + move from now on.
    void set_pose(const Mat3& turn, const Vec3& move);
    /// Where there is something and it is wanted.
    void show(bool wanted);
    bool shown() const;

    vtkProperty* property() const;
    void color(const Rgb& color);
    void unlit();
    void set_line_width(double pixels);
    void set_point_size(double pixels);
    /// Lines and dots are drawn nearer by so many 1/65000 of the depth of the view, or the facets beside them
    /// would cut them up. 32 is about half a pixel on a steep facet; the order settles what lies on what.
    void nearer(double by);
    /// Property, colours of points and place before or behind the surface are those of another.
    void look_like(const SceneActor& other);
    /// Triangles, line segments and dots; only of an actor that has data.
    std::size_t elements() const;
};

using SceneActors = std::vector<std::unique_ptr<SceneActor>>;

/// Triangles of a large thing in one actor, and about what one step of a picture draws: some 10 ms without a
/// graphics card.
inline constexpr std::size_t elements_in_piece = 30'000;

/// A large thing as actors of some size that look like the first one.
class ScenePieces {
public:
    SceneActor first;

    /// No pieces: nothing.
    void set(SceneStage& stage, const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, const Vec3& center);
    void show(bool wanted);
    void add_to(std::vector<SceneActor*>& all);
    void add_to(std::vector<vtkActor*>& all) const;

private:
    SceneActors more_;
};

} // namespace facetmill
