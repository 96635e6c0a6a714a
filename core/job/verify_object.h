// verify.json as an object, for what writes it beside others. Internal to this room.
#pragma once

#include "core/base/strict_json.h"
#include "core/job/verification.h"

namespace facetmill {

Json verify_object(const Project& project, std::span<const VerifyProgram> programs,
                   const Verification& result);

} // namespace facetmill
