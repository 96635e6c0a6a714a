// The planned paths that the view shows: the programs of all operations, in the order of the scene's path
// sources. No widgets and no scene.
#pragma once

#include "ui/document.h"
#include "viz/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace facetmill::ui {

class ShownPaths {
public:
    explicit ShownPaths(const Document& document) : document_(document) {}

    /// Looks at what the document has planned. True where the programs are others than before.
    bool update();

    std::size_t size() const { return programs_.size(); }
    bool empty() const { return programs_.empty(); }
    const std::vector<std::shared_ptr<const OperationResult>>& programs() const { return programs_; }
    /// The operations' ids in the document, one per program; of an opened program's sections less than 0.
    const std::vector<int>& ids() const { return ids_; }
    bool of_several_operations() const { return !ids_.empty() && ids_.front() != ids_.back(); }

    /// Its operation's place in the document, or of a program that was opened its own; none where that is
    /// gone.
    std::optional<std::size_t> place_of(std::size_t source) const;
    /// Place of a program among those shown; none where it is not.
    std::optional<std::size_t> source_of(const std::shared_ptr<const OperationResult>& program) const;
    /// The tool that a program is cut with. Throws Error(missing_reference).
    const Tool& tool_of(std::size_t source) const;
    /// Number of the motion; for a contact that was picked, the motion that cuts it.
    std::size_t motion_of(const PathPick& pick) const;
    /// The contact at the place that was picked; null where there is none.
    const CutterContact* contact_of(const PathPick& pick) const;
    /// The end of a motion as if it had been picked; nothing where there is no such motion.
    std::optional<PathPick> pick_at(std::size_t source, std::size_t motion) const;
    /// The end of the cutting motion of a path that is nearest to a place.
    std::optional<PathPick> nearest_cut(std::size_t source, const Vec3& tip) const;

private:
    const Document& document_;
    std::vector<std::shared_ptr<const OperationResult>> programs_;
    std::vector<int> ids_;
    std::shared_ptr<const OpenedProgram> opened_; ///< whose sections they are; null: planned
};

} // namespace facetmill::ui
