// Work of core's while Python waits: in a thread of its own, so that Ctrl-C is heard meanwhile.
#pragma once

#include "core/base/progress.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <optional>

namespace facetmill::python {

struct PythonJob {
    Job job;
};

/// Runs work(progress) without the interpreter's lock, and returns what that returns. What a signal's handler
/// raises cancels it and is thrown once it has ended. Throws what it throws.
template <class Work>
auto waited(PythonJob* given, const Work& work) {
    using Result = decltype(work(Progress()));
    PythonJob own;
    PythonJob& job = given ? *given : own;
    std::optional<pybind11::error_already_set> raised;
    std::future<Result> done = std::async(std::launch::async, [&] { return work(Progress(job.job)); });
    for (;;) {
        {
            const pybind11::gil_scoped_release released;
            constexpr auto heard_within = std::chrono::milliseconds(20);
            if (done.wait_for(heard_within) == std::future_status::ready) break;
        }
        if (!raised && PyErr_CheckSignals() != 0) {
            raised.emplace();
            job.job.cancel();
        }
    }
    if (!raised) return done.get();
    try {
        (void)done.get();
    } catch (const Cancelled&) {
        // As it was asked to.
    }
    throw pybind11::error_already_set(*raised);
}

} // namespace facetmill::python
