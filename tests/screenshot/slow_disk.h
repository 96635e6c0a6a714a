// A disk that does not answer: what was written does not get there before it goes on.
#pragma once

namespace facetmill::test {

/// While one lives `fsync` does not return, in any thread of the program; at most for ten seconds each, so
/// that a test in which the window waits for it fails and does not hang.
class StandingDisk {
public:
    StandingDisk();
    ~StandingDisk() { go_on(); }
    StandingDisk(const StandingDisk&) = delete;
    StandingDisk& operator=(const StandingDisk&) = delete;
    void go_on();
    /// How many calls wait now.
    static int waiting();
};

} // namespace facetmill::test
