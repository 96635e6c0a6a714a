// Cancelling a job while it runs.
#pragma once

#include "core/base/progress.h"

namespace facetmill::test {

/// Runs `run(Progress)` with a job that is cancelled as soon as it has come to `fraction`. True when it ended
/// by that. Other errors pass.
template <class Run>
bool cancelled_at(Job& job, double fraction, Run&& run) {
    job.cancel_at(fraction);
    try {
        run(Progress(job));
    } catch (const Cancelled&) {
        return true;
    }
    return false;
}

} // namespace facetmill::test
