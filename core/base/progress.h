// Progress and cancellation. One `Job` per background job: an atomic cancel flag, a fraction that never goes
// back, a label. A `Progress` is an interval of a job; parts of it share the job and hence the flag. The UI
// polls the job; core never calls back.
//
//     Job job;
//     Progress p(job);
//     load(p.part(0.0, 0.2, "Reading part"));
//     plan(p.part(0.2, 1.0, "Finish"));
//
// Loops call `set` or `check` per chunk of at most about 20 ms of work, so that a cancel takes effect within
// 100 ms.
#pragma once

#include "core/base/error.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace facetmill {

class Job {
public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    /// Cancels as soon as the job has come to this fraction, at once if it has: the same place in every run.
    void cancel_at(double fraction);
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

    /// 0 to 1, never decreasing.
    double fraction() const { return fraction_.load(std::memory_order_relaxed); }
    /// "Finish (2 of 3): Placing drive planes": the task, where there is one, and what it is at.
    std::string label() const;

    void raise_fraction(double to);
    void set_label(std::string label);
    /// What the labels from now on are of; empty: the job as a whole.
    void set_task(std::string task);

private:
    std::atomic<bool> cancelled_{false};
    std::atomic<double> fraction_{0.0}, cancel_at_{2.0};
    mutable std::mutex label_mutex_;
    std::string task_, label_;
};

class Progress {
public:
    /// Progress nobody watches and nobody can cancel.
    Progress() = default;
    explicit Progress(Job& job) : job_(&job) {}

    /// The interval [from, to] (0..1 of this one) with its own label; an empty label keeps the present one.
    Progress part(double from, double to, const std::string& label = {}) const;

    /// Names what is worked at from now on (Job::set_task).
    void task(const std::string& name) const {
        if (job_) job_->set_task(name);
    }
    /// Sets the fraction of this interval that is done (0..1). Throws Cancelled when the job was cancelled.
    void set(double fraction) const;
    /// Throws Cancelled when the job was cancelled.
    void check() const {
        if (job_ && job_->cancelled()) throw Cancelled();
    }
    bool cancelled() const { return job_ && job_->cancelled(); }

private:
    Job* job_ = nullptr;
    double from_ = 0.0, to_ = 1.0;
};

} // namespace facetmill
