// What planning and verifying came to, as bytes that outlive the program: all that a window shows of it and
// that programs and reports are written from. They are for the program that wrote them, and say nothing of
// what they were made from: who keeps them knows them by that (kept_folder.h).
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "core/verify/verify.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace facetmill {

/// Part and fixtures are not written: who reads has them, `part` as the result was planned on.
std::string result_bytes(const OperationResult& result, const PreparedPart& part, const Progress& progress);
/// The result of operation `i` of the project. What only planning works with is left out: contact indexes are
/// made again where a configuration space is looked at, and of global-local CM2 the assumed path is not
/// there. Throws Error where the bytes are none of such a result, and what the operation's boundary throws.
std::shared_ptr<const OperationResult> result_from_bytes(std::string_view bytes, const Project& project,
                                                         std::size_t i, const PreparedPart& part,
                                                         const Progress& progress);

struct KeptVerdict {
    std::size_t posted_blocks = 0; ///< of the posted programs that were judged; 0: the plan was
    std::shared_ptr<const Verification> verification;
};
/// All but the model of the stock, which playback cuts again.
std::string verdict_bytes(const KeptVerdict& verdict, const Progress& progress);
KeptVerdict verdict_from_bytes(std::string_view bytes, const Progress& progress);

/// `source` is not written: who reads knows it.
std::string carried_bytes(const CarriedStock& stock, const Progress& progress);
std::shared_ptr<CarriedStock> carried_from_bytes(std::string_view bytes, const Progress& progress);

} // namespace facetmill
