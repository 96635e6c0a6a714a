// What the commands that verify have in common: how closely they look.
#pragma once

#include "app/cli_arguments.h"
#include "core/job/planner.h"
#include "core/verify/verify.h"

namespace facetmill::cli {

/// --resolution and --spacing: lengths in the project's units.
OptionInfo resolution_option();
OptionInfo spacing_option();

/// What the command line asks of the judge: these two, --gouge-limit and --uncut-limit. Throws Error(usage).
class AskedSettings {
public:
    /// The arguments must outlive this.
    AskedSettings(const Arguments& arguments, LengthUnit unit);
    /// Throws Error(limit_exceeded) for a spacing that is a slip.
    void apply(VerifySettings& settings, const PreparedPart& part) const;

private:
    const Arguments& arguments_;
    LengthUnit unit_;
    double resolution_, spacing_, gouge_limit_; ///< mm; 0: not given
};

} // namespace facetmill::cli
