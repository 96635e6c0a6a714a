// Candidates worked on by another machine that sees the study's folder under the same name. Each worker there
// is begun by ssh, which is to be let in without a password.
#pragma once

#include "core/study/local_workers.h"

#include <string>

namespace facetmill {

/// What `own` begins here is begun on `host`, as ssh knows it, by `program` there; empty: by one that has the
/// place of that of `own`. Throws Error(usage) for what is no host, Error(not_found) where there is no ssh.
/// While it works, Error(not_found) ends the run where the host cannot be reached or has no such program.
StudyWorkers workers_by_ssh(const StudyWorkers& own, const std::string& host, const std::string& program);

} // namespace facetmill
