// Which side of a mesh a tool comes to: of a closed mesh the outside, whichever way it is wound; of a sheet
// either side may be up, and the upper one counts.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

class UpSide {
public:
    UpSide(const Mesh& mesh, const Progress& progress);

    bool closed() const { return out_ != 0; }
    /// A normal by the winding, turned to the side the tool comes from. Of a closed mesh it may face down.
    Vec3 towards_tool(const Vec3& normal) const {
        return (out_ != 0 ? out_ : normal.z() < 0 ? -1 : 1) * normal;
    }

private:
    int out_ = 0; ///< factor that turns normals outward; 0: a sheet
};

} // namespace facetmill
