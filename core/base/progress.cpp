#include "core/base/progress.h"

#include <algorithm>

namespace facetmill {

std::string Job::label() const {
    std::lock_guard lock(label_mutex_);
    if (task_.empty() || label_.empty()) return task_ + label_;
    return task_ + ": " + label_;
}

void Job::raise_fraction(double to) {
    to = std::clamp(to, 0.0, 1.0);
    double now = fraction_.load(std::memory_order_relaxed);
    while (now < to && !fraction_.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
    }
    if (to >= cancel_at_.load(std::memory_order_relaxed)) cancel();
}

void Job::cancel_at(double fraction) {
    cancel_at_.store(fraction, std::memory_order_relaxed);
    if (this->fraction() >= fraction) cancel();
}

void Job::set_label(std::string label) {
    std::lock_guard lock(label_mutex_);
    label_ = std::move(label);
}

void Job::set_task(std::string task) {
    std::lock_guard lock(label_mutex_);
    task_ = std::move(task);
    label_.clear();
}

Progress Progress::part(double from, double to, const std::string& label) const {
    Progress p = *this;
    p.from_ = from_ + (to_ - from_) * std::clamp(from, 0.0, 1.0);
    p.to_ = from_ + (to_ - from_) * std::clamp(to, 0.0, 1.0);
    if (job_) {
        check();
        if (!label.empty()) job_->set_label(label);
        job_->raise_fraction(p.from_);
    }
    return p;
}

void Progress::set(double fraction) const {
    if (!job_) return;
    job_->raise_fraction(from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0));
    check();
}

} // namespace facetmill
