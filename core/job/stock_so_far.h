// What stands of a setup's stock before each of its operations, as planners ask for it. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "core/verify/verify.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// What programs leave of a stock, as a mesh that planners read: cut as for the verification, coarser where
/// its surface would come in millions of facets. Of kind mesh, without facets where nothing is left. Throws
/// what verify does.
StockSolid rest_after(const StockSolid& stock, std::span<const VerifyProgram> programs,
                      VerifySettings settings, const Progress& progress);

/// Meshes of stocks between operations, by what they come from.
class RestMeshes {
public:
    void begin_plan();
    /// Forgets what no operation asked for since `begin_plan`.
    void end_plan();
    StockSolid& of(const std::string& key);

private:
    struct Kept {
        StockSolid stock;
        bool used = false;
    };
    std::map<std::string, Kept> kept_;
};

/// The operations of a setup, as far as they are planned. A height field along one axis tells nothing of cuts
/// along another. So what operations with other axes have cut is taken away as for the verification, and
/// planners get what is left as a mesh; and what was cut since then with the operation's own axis as motions.
class StockSoFar {
public:
    /// `key`: another text for another stock or part.
    StockSoFar(const Project& project, const PlanResult& setup, std::string key, RestMeshes& rests);

    /// Operations in their order; `name`: the same one for the same motions, and for no others.
    void add(const Operation& operation, const std::shared_ptr<const OperationResult>& result,
             std::string name);
    /// Names all that the operations so far have cut.
    std::string key() const;
    struct Before {
        StockSolid stock;                                        ///< in the setup
        std::vector<std::shared_ptr<const EarlierCuts>> earlier; ///< in the operation's view
    };
    /// Throws what rest_after does; Error(empty_result) where nothing of the stock is left.
    Before before(const Operation& operation, const Progress& progress) const;

private:
    struct Cut {
        Vec3 axis;
        std::shared_ptr<const OperationResult> result; ///< null: it had nothing to do
        std::shared_ptr<const EarlierCuts> cuts;
        std::string name;
    };
    const StockSolid& rest(std::size_t count, const Progress& progress) const;

    const Project& project_;
    const PlanResult& setup_;
    std::string key_;
    RestMeshes& rests_;
    std::vector<Cut> cuts_;
};

/// What an operation cuts, for those after it that have the same axis; `turn`: from the setup to their view;
/// `allowance`: what it leaves at least, where that is known.
std::shared_ptr<const EarlierCuts> cuts_of(const OperationResult& operation, double allowance = 0,
                                           const Mat3& turn = Mat3::Identity());

} // namespace facetmill
