// What to do about a verification that failed, in one sentence: by what was touched first, then by why most
// of what stays is there.
#pragma once

#include "core/job/new_operation.h"

#include <QString>

#include <string>

namespace facetmill {
struct Project;
struct Verification;
} // namespace facetmill

namespace facetmill::ui {

struct VerdictAdvice {
    QString text;    ///< empty where it passed, or nothing can be advised
    std::string add; ///< the kind of operation that is to be added; empty: the text is about something else
    OperationWish wish = {}; ///< of that operation
};

/// A message about a verification that was not begun, see Verification::not_judged, with what to do.
QString not_begun_message(const std::string& why, const Project& project);
/// For the operations of the project's shown setup: one that is there already is not to be added. A further
/// clean-up takes a tool that none of those before it has.
VerdictAdvice verdict_advice(const Verification& verification, const Project& project);
/// "Add Rough", "Add Clean-up": a button that does what is advised; empty where nothing is to be added.
QString advised_button(const VerdictAdvice& advice);

} // namespace facetmill::ui
