// A renderer for pictures of two sizes in turn, as a view is drawn that is coarse while it turns.
#pragma once

#include <vtkOpenGLRenderer.h>

#include <cstddef>

namespace facetmill {

/// VTK keeps one set of textures in which it adds up what can be seen through, and makes it larger or smaller
/// whenever the picture has another size: 10 to 40 ms each time where the memory of textures is the
/// processor's. This one keeps two, for the two sizes that were drawn last.
class SceneRenderer : public vtkOpenGLRenderer {
public:
    static SceneRenderer* New();
    vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer);

    /// How often a set was made, or made larger or smaller.
    std::size_t textures_sized() const;

protected:
    SceneRenderer();
};

} // namespace facetmill
