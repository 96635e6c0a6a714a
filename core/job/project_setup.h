// A setup of a project: how its part is clamped once, on which machine, and what is done then. A project
// holds its setups in machining order and is, besides, the view on one of them (core/job/project.h).
#pragma once

#include "core/base/parameter.h"
#include "core/job/program_spec.h"
#include "core/setup/boundary.h"
#include "core/setup/fixture.h"
#include "core/setup/placement.h"
#include "core/setup/stock.h"
#include "core/strategy/plan/operation.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace facetmill {

/// How a setup holds the part: turned and moved from where the project's `part` says that it is.
struct SetupPlace {
    std::array<double, 3> rotate{0, 0, 0};    ///< radians about X, then Y, then Z (fixed axes)
    std::array<double, 3> translate{0, 0, 0}; ///< mm, after the rotation
    bool operator==(const SetupPlace&) const = default;
};

const ParameterTable<SetupPlace>& place_parameters();

/// What a setup is called unless someone names it; the only one of a project has the first name.
std::string usual_setup_name(std::size_t place);

struct Setup {
    std::string name = usual_setup_name(0);
    SetupPlace place;
    StockSpec stock;
    std::vector<Fixture> fixtures;          ///< what holds the part
    std::vector<Boundary> boundaries;       ///< that its operations may name
    std::string machine = "generic-3-axis"; ///< a name, or a file: relative to the project file, or absolute
    ProgramSpec programs;                   ///< keys "post", "wcs", "program_number", "programs", "arcs"
    std::vector<std::unique_ptr<Operation>> operations;

    Setup() = default;
    Setup(const Setup& other);
    Setup& operator=(const Setup& other);
    Setup(Setup&&) = default;
    Setup& operator=(Setup&&) = default;
    ~Setup() = default;
};

struct Project; // project.h

std::size_t setup_count(const Project& project);
/// The place of the setup that the project is the view on.
std::size_t chosen_setup(const Project& project);
Setup& setup_at(Project& project, std::size_t i);
const Setup& setup_at(const Project& project, std::size_t i);
/// Makes the project the view on another of its setups.
void choose_setup(Project& project, std::size_t i);
/// The same project as the view on one of its setups.
Project view_of_setup(const Project& project, std::size_t i);
/// The place of the setup of this name. Throws Error(missing_reference) that names those there are.
std::size_t find_setup(const Project& project, const std::string& name);
/// The place of the setup that has an operation of this name; that of the chosen one where none has.
std::size_t setup_of_operation(const Project& project, const std::string& operation);

/// The wish, or with the first number from 2 that makes it one that is not `taken`.
template <class Taken>
std::string free_name(const std::string& wish, const Taken& taken) {
    if (!taken(wish)) return wish;
    for (int n = 2;; ++n)
        if (std::string name = wish + " " + std::to_string(n); !taken(name)) return name;
}

/// All operations of a project, in machining order.
std::vector<const Operation*> all_operations(const Project& project);
std::vector<Operation*> all_operations(Project& project);
/// The operations of a setup that are not switched off: what is planned and written, in machining order.
std::vector<const Operation*> operations_on(const Setup& setup);
/// How many operations the setups before the chosen one have: programs are numbered through the project.
std::size_t operations_before(const Project& project);
/// "Finish", or "Finish 2" where an operation of the project has that name.
std::string free_operation_name(const Project& project, const std::string& wish);

/// "Setup 2", or what else no setup of the project is called.
std::string free_setup_name(const Project& project, const std::string& wish);
/// All setups, in machining order, taken out of the project, which is no good until they are put back.
std::vector<Setup> take_setups(Project& project);
/// Puts setups into a project as the view on one of them. Throws Error(missing_reference) where the first
/// would go on with the rest of one before it; the project is no good then.
void put_setups(Project& project, std::vector<Setup> setups, std::size_t chosen);

/// A turn that is one of quarter turns, to rounding, without that rounding: then boxes stay boxes.
Mat3 exact_turn(const Mat3& turn);

/// From the coordinates in which the project's `part` stands to those of a setup.
struct SetupFrame {
    Mat3 turn = Mat3::Identity();
    Vec3 move = Vec3::Zero();

    bool is_identity() const { return turn == Mat3::Identity() && move == Vec3::Zero(); }
    Vec3 operator()(const Vec3& p) const { return turn * p + move; }
    SetupFrame inverse() const { return {turn.transpose(), -(turn.transpose() * move)}; }
    /// First `other`, then this.
    SetupFrame after(const SetupFrame& other) const {
        return {exact_turn(turn * other.turn), turn * other.move + move};
    }
};

SetupFrame frame_of(const SetupPlace& place);
/// Lays the part of the chosen setup like this: by the placement of the part itself where the project has no
/// other setup and this one holds the part as it is, else by the setup's. Throws Error(out_of_range) where a
/// setup would have to mirror it.
void lay_part(Project& project, const Placement& placement);
/// A half turn about a line along X (0) or Y (1) through the middle of a box, which then is where it was: the
/// zero on it as well.
SetupFrame flip_about(int axis, const Box3& box);
/// Its numbers rounded as those of all placements that are found.
SetupPlace place_of(const SetupFrame& frame);

} // namespace facetmill
