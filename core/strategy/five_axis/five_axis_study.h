// One contact point of a planned 5-axis operation, studied again: its whole configuration space, why postures
// are blocked, and what each of the three methods chooses there. For the command line and the workbench.
#pragma once

#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/posture_study.h"

#include <array>
#include <memory>
#include <mutex>

namespace facetmill {

class FiveAxisStudy {
public:
    /// Throws what FiveAxisField throws.
    FiveAxisStudy(std::shared_ptr<const FiveAxisRecord> record, const Progress& progress);

    struct Point {
        std::size_t index = 0;
        ContactPlace place;
        PostureGrid grid; ///< that of its piece
        std::vector<RaisedCurve> curves;
        CSpace space;        ///< with the bottom everywhere
        double cm2_lead = 0; ///< the CM2 lead, whether it is free or not
        /// By cm2, local, global (Finish5Settings::PostureChoice); without strips the operation's own.
        std::array<ChosenPosture, 3> chosen;
        ChosenPosture planned; ///< the operation's own
    };
    /// Plans the point's whole pass by every method: the global one depends on all of it. Throws
    /// Error(out_of_range) for an index that is not a contact point's.
    Point point(std::size_t index, const Progress& progress) const;
    /// The same for all points of its line, in the order of travel, at the price of one. The first is number
    /// record().line_of(index).begin.
    std::vector<Point> line(std::size_t index, const Progress& progress) const;

    /// Why a posture is free or blocked, also between nodes of the grid.
    CSpaceBuilder::Reason reason(const Point& point, double lead, double yaw) const {
        return field_.builder().reason(point.place.frame, lead, yaw, point.curves);
    }
    /// The field of the first piece; tool and machine are those of all.
    const FiveAxisField& field() const { return field_; }
    const FiveAxisRecord& record() const { return *record_; }

private:
    std::vector<Point> line_without_strips(const FiveAxisRecord::Line& line, const Progress& progress) const;
    const FiveAxisField& field_of(const FiveAxisRecord::Line& line, const Progress& progress) const;

    std::shared_ptr<const FiveAxisRecord> record_;
    FiveAxisField field_;
    /// Fields of the pieces after the first, made when one of their points is asked for.
    mutable std::vector<std::unique_ptr<FiveAxisField>> further_;
    mutable std::mutex mutex_;
};

} // namespace facetmill
