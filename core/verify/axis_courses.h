// How the tool axis goes from one location of a program to the next. A program says where the tool is, and
// the control decides what lies between; so surface is asked under every course that controls take. On all of
// them the tip moves straight (the control keeps the tool's centre on the line), and a motion's ends are the
// same. Internal to this room.
#pragma once

#include "core/base/progress.h"
#include "core/setup/kinematics.h"
#include "core/verify/program.h"

#include <array>
#include <optional>
#include <vector>

namespace facetmill {

class AxisCourses {
public:
    /// `program` must outlive this. Joints that do not hold the tool axes of the program are not believed.
    AxisCourses(const VerifyProgram& program, const Progress& progress);

    /// False where no point of the tool is anywhere farther than 5e-5 mm from where the great circle has it,
    /// or where the course is not known: then it need not be asked.
    bool differs(Index motion, AxisCourse course) const {
        return !differs_.empty() && (differs_[motion] & (1u << unsigned(course))) != 0;
    }
    /// Where the tool is at a share of a motion.
    CutterLocation at(Index motion, AxisCourse course, double s) const;
    /// The courses beside the great circle.
    static constexpr std::array<AxisCourse, 2> others{AxisCourse::normalized_linear,
                                                      AxisCourse::joint_linear};

private:
    using Angles = std::optional<std::array<double, 2>>;
    const CutterLocation& from(Index motion) const {
        return program_->motions->motions[motion > 0 ? motion - 1 : 0].to;
    }
    void follow_joints(const Progress& progress);

    const VerifyProgram* program_;
    std::optional<Kinematics> kinematics_;
    std::vector<Angles> angles_; ///< at the ends of the motions; empty where no machine is known
    std::vector<std::uint8_t> differs_;
};

} // namespace facetmill
