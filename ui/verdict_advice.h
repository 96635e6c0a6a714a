// What to do about a verification that failed, in one sentence: by what was touched first, then by why most
// of what stays is there.
#pragma once

#include <QString>

namespace facetmill {
struct Verification;
}

namespace facetmill::ui {

/// Empty where it passed, could not be judged, or nothing can be advised.
QString verdict_advice(const Verification& verification);

} // namespace facetmill::ui
