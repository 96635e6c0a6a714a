// Where the window's thread is while its event loop does not come round: a call tree of each long pause.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

namespace facetmill::test {

/// Looks four times a millisecond where the thread that made it is (by a signal, so any code is seen, also
/// that of libraries), and writes what it saw in a pause as a tree of calls with the milliseconds of each.
/// One a program.
class PauseTrace {
public:
    /// FACETMILL_TRACE_PAUSES=MS in the environment asks for it; nothing otherwise.
    static std::unique_ptr<PauseTrace> as_asked() {
        const char* ms = std::getenv("FACETMILL_TRACE_PAUSES");
        return ms ? std::unique_ptr<PauseTrace>(new PauseTrace(std::atof(ms))) : nullptr;
    }
    ~PauseTrace() {
        stop_ = true;
        looker_.join();
    }

    /// A round of the event loop has come to its end.
    void round_ended() {
        const double now = now_ms();
        if (now - start_ > over_ms_) print(start_, now);
        count_ = 0;
        start_ = now_ms(); // without the printing
    }

private:
    static constexpr int frames = 64, samples = 8192;
    struct Sample {
        void* frame[frames];
        int count;
    };
    struct Call {
        int seen = 0;
        std::map<std::string, Call> calls;
    };

    explicit PauseTrace(double over_ms) : over_ms_(over_ms), samples_(samples), start_(now_ms()) {
        void* first[4];
        backtrace(first, 4); // loads what it needs, which must not happen in the signal
        self() = this;
        struct sigaction action = {};
        action.sa_handler = [](int) { self()->look(); };
        action.sa_flags = SA_RESTART;
        sigaction(SIGUSR2, &action, nullptr);
        looker_ = std::thread([this, watched = pthread_self()] {
            while (!stop_) {
                usleep(250);
                pthread_kill(watched, SIGUSR2);
            }
        });
    }
    static PauseTrace*& self() {
        static PauseTrace* one = nullptr;
        return one;
    }
    static double now_ms() {
        timespec t{};
        clock_gettime(CLOCK_MONOTONIC, &t);
        return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
    }
    void look() {
        if (count_ == samples) return;
        Sample& s = samples_[std::size_t(count_)];
        s.count = backtrace(s.frame, frames);
        ++count_;
    }
    static std::string name(void* at) {
        Dl_info info{};
        if (!dladdr(static_cast<char*>(at) - 1, &info) || !info.dli_fname) return "?";
        const char* slash = std::strrchr(info.dli_fname, '/');
        const std::string file = slash ? slash + 1 : info.dli_fname;
        if (!info.dli_sname) return file;
        int failed = 0;
        char* plain = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &failed);
        std::string result = plain ? plain : info.dli_sname;
        std::free(plain);
        return result.substr(0, 110);
    }
    static void print(const Call& call, double ms_each, int depth) {
        for (const auto& [name, inner] : call.calls) {
            if (inner.seen * ms_each < 1) continue;
            std::printf("%*s%.1f %s\n", depth, "", inner.seen * ms_each, name.c_str());
            print(inner, ms_each, depth + 1);
        }
    }
    void print(double from, double to) {
        const int seen = count_;
        Call root;
        for (int i = 0; i < seen; ++i) {
            const Sample& s = samples_[std::size_t(i)];
            Call* call = &root;
            for (int k = s.count - 1; k >= 2; --k) { // 0 and 1 are the signal's own
                call = &call->calls[name(s.frame[k])];
                ++call->seen;
            }
        }
        std::printf("--- a pause of %.1f ms, seen %d times\n", to - from, seen);
        print(root, seen > 0 ? (to - from) / seen : 0, 1);
    }

    double over_ms_;
    std::vector<Sample> samples_;
    std::atomic<int> count_{0};
    double start_;
    std::atomic<bool> stop_{false};
    std::thread looker_;
};

} // namespace facetmill::test
