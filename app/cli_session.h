// One run of a command: its job, its progress on stderr, its signals, its output on stdout.
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace facetmill::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP cancel the job and end the process with it within 5 ms:
/// temporary files are removed first, so nothing is left. Where the outputs stand in their places already,
/// the job goes on to its end. Progress goes to stderr: one line that is rewritten on a terminal, a line
/// every ten seconds elsewhere, so that a short job that fails writes one line.
class Session {
public:
    Session();
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    Progress progress() { return Progress(job_); }
    /// The job is over, its files are in place: clears the progress line and gives the signals back.
    void finish();
    /// The job is done, but what it found is bad: exit status 1.
    void fail() { failed_ = true; }
    bool failed() const { return failed_; }
    /// Writes a result, before the files that go with it appear: a job whose result nobody could be told has
    /// failed and leaves none. Throws Error(unwritable) when stdout takes no more.
    void print(std::string_view text);
    /// A line on stderr, whatever the text holds.
    void say(std::string_view text);

private:
    void watch();
    void show(bool last);

    Job job_;
    const std::size_t committed_before_ = committed_outputs();
    bool terminal_ = false, line_shown_ = false, quiet_ = false;
    double seconds_ = 0, next_line_ = 0;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool over_ = false, failed_ = false;
    std::thread watcher_;
};

} // namespace facetmill::cli
