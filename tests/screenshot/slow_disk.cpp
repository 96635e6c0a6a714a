#include "tests/screenshot/slow_disk.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <sys/syscall.h>
#include <unistd.h>

namespace {

struct DiskState {
    std::mutex mutex;
    std::condition_variable changed;
    bool stands = false;
    int waiting = 0;
};

DiskState& disk_state() {
    static auto& state = *new DiskState; // threads may write until the program has ended
    return state;
}

} // namespace

/// In place of the C library's.
extern "C" int fsync(int fd) {
    {
        DiskState& disk = disk_state();
        std::unique_lock lock(disk.mutex);
        ++disk.waiting;
        disk.changed.wait_for(lock, std::chrono::seconds(10), [&] { return !disk.stands; });
        --disk.waiting;
    }
    return int(::syscall(SYS_fsync, fd));
}

namespace facetmill::test {

StandingDisk::StandingDisk() {
    const std::lock_guard lock(disk_state().mutex);
    disk_state().stands = true;
}

void StandingDisk::go_on() {
    {
        const std::lock_guard lock(disk_state().mutex);
        disk_state().stands = false;
    }
    disk_state().changed.notify_all();
}

int StandingDisk::waiting() {
    const std::lock_guard lock(disk_state().mutex);
    return disk_state().waiting;
}

} // namespace facetmill::test
