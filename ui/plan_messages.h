// What is asked before a plan, and told after it.
#pragma once

#include "core/job/planner.h"

#include <QStringList>

#include <string>

class QWidget;

namespace facetmill::ui {

class Messages;

/// A line for each of these operations that would be more work than usual (work_estimate.h). None where the
/// project is not good: planning says that.
QStringList large_work(const Project& project, const PreparedPart& part,
                       const std::vector<std::string>& operations);
/// Asks whether that is meant: a slip by some zeros would take all memory and the rest of the day. True where
/// there is nothing to ask.
bool may_plan(const QStringList& large, QWidget* window);

/// How a program came out, with its warnings; or that an operation has nothing to do.
void tell_operation(Messages& messages, const std::shared_ptr<const OperationResult>& operation,
                    LengthUnit unit);

} // namespace facetmill::ui
