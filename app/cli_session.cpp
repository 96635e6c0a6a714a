#include "app/cli_session.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <unistd.h>

namespace facetmill::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto poll = std::chrono::milliseconds(5);
constexpr double terminal_interval = 0.1, line_interval = 10.0; // seconds
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<Job*> running{nullptr};
static_assert(std::atomic<Job*>::is_always_lock_free); // a signal handler touches it

void cancel_running(int) {
    if (Job* job = running.load()) job->cancel();
}

void handle_signals(void (*handler)(int)) {
    for (int s : signals) {
        struct ::sigaction action {};
        if (s == SIGHUP && ::sigaction(s, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
            continue; // nohup
        action = {};
        action.sa_handler = handler;
        ::sigemptyset(&action.sa_mask);
        action.sa_flags = SA_RESTART;
        ::sigaction(s, &action, nullptr);
    }
}

} // namespace

Session::Session() : terminal_(::isatty(STDERR_FILENO) == 1), next_line_(terminal_ ? 0.3 : line_interval) {
    running = &job_;
    handle_signals(cancel_running);
    watcher_ = std::thread([this] { watch(); });
}

Session::~Session() {
    finish();
}

void Session::finish() {
    {
        std::lock_guard lock(mutex_);
        over_ = true;
    }
    wake_.notify_all();
    if (!watcher_.joinable()) return;
    watcher_.join();
    handle_signals(SIG_DFL);
    running = nullptr;
    show(true);
}

void Session::watch() {
    const auto start = Clock::now();
    bool too_late = false;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, poll, [this] { return over_; })) {
        const auto now = Clock::now();
        seconds_ = std::chrono::duration<double>(now - start).count();
        if (!job_.cancelled() || too_late) {
            show(false);
            continue;
        }
        // At once: to unwind and to give memory back piece by piece takes longer than the whole process does.
        too_late = !abandon_outputs(committed_before_);
        if (too_late) continue;
        show(true);
        constexpr std::string_view text = "facetmill-cli: cancelled\n";
        if (::write(STDERR_FILENO, text.data(), text.size()) < 0) ::_exit(1);
        ::_exit(1);
    }
}

void Session::show(bool last) {
    if (last) {
        if (line_shown_) std::fputs("\r\x1b[K", stderr);
        line_shown_ = false;
        return;
    }
    if (quiet_ || seconds_ < next_line_) return;
    next_line_ = seconds_ + (terminal_ ? terminal_interval : line_interval);
    const std::string label = printable(job_.label(), 60);
    const int percent = int(job_.fraction() * 100);
    if (terminal_) {
        std::fprintf(stderr, "\r\x1b[K%3d %%  %s", percent, label.c_str());
        line_shown_ = true;
    } else {
        std::fprintf(stderr, "facetmill-cli: %d %% %s\n", percent, label.c_str());
    }
    std::fflush(stderr);
}

void Session::print(std::string_view text) {
    {
        std::lock_guard lock(mutex_);
        show(true);
        quiet_ = true;
    }
    errno = 0;
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written)
        throw Error(ErrorCode::unwritable, "stdout",
                    "cannot write the result: " + std::generic_category().message(errno),
                    "check the pipe or the disk");
}

void Session::say(std::string_view text) {
    constexpr std::size_t longest = 4000;
    std::lock_guard lock(mutex_);
    show(true);
    std::fprintf(stderr, "facetmill-cli: %s\n", printable(text, longest).c_str());
}

} // namespace facetmill::cli
