#pragma once
#include "core/job/project.h"

#include <functional>
#include <string>
#include <vector>

namespace facetmill {

/// An operation that has to be planned, and who asks for it.
struct AskedOperation {
    const Operation* operation;
    bool result;         ///< it is wanted itself, else only for those after it
    bool leaves = false; ///< an operation after it asks what stands of the stock
    bool read = false;   ///< an operation after it asks what it came to
    bool needed() const { return result || leaves || read; }
};

/// The wanted operations of a project and those before them whose stock or path they ask for, in the
/// project's order, without those that are switched off. `wanted` is called once for every index of
/// Project::operations; none wanted: an empty list. The pointers are the project's.
std::vector<AskedOperation> asked_operations(const Project& project,
                                             const std::function<bool(std::size_t)>& wanted);

/// "Finish (2 of 3)": what a plan of `n` operations is at (Progress::task).
std::string task_text(const std::string& operation, std::size_t i, std::size_t n);
/// Numbers of all tools that an operation uses or asks about, its own first.
std::vector<long> tools_of(const Operation& operation);
/// Those of all operations of a setup, a number as often as it is named.
std::vector<long> tools_of(const Setup& setup);
/// Empties the lists of an operation: postures and regions that were kept for places of a part. Returns those
/// that held something.
std::vector<const ParameterInfo*> forget_places(Operation& operation);

/// Throws Error(missing_reference): there is no operation of this name among `names`.
[[noreturn]] void refuse_operation(const std::string& name, const std::vector<std::string>& names);
/// Throws Error(missing_key, missing_reference): why nothing of a setup is to be planned, where
/// asked_operations tells nothing of an operation of this name (empty: of any).
[[noreturn]] void refuse_to_plan(const Setup& setup, const std::string& name);

} // namespace facetmill
