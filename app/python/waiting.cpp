#include "app/python/waiting.h"

#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

namespace facetmill::python {

namespace {

/// Asked with the interpreter's lock held alone. Never destroyed: threads may still wait when Python ends.
std::vector<std::unique_ptr<WorkThread>>& spare_threads() {
    static auto& spare = *new std::vector<std::unique_ptr<WorkThread>>;
    return spare;
}

} // namespace

WorkThread::WorkThread() : shared_(std::make_shared<Shared>()), process_(::getpid()) {
    std::thread([shared = shared_] {
        std::unique_lock lock(shared->mutex);
        for (;;) {
            shared->changed.wait(lock, [&] { return shared->work != nullptr; });
            const std::function<void()>& work = *shared->work;
            lock.unlock();
            work();
            lock.lock();
            shared->work = nullptr;
            shared->changed.notify_all();
        }
    }).detach();
}

std::unique_ptr<WorkThread> WorkThread::take() {
    auto& spare = spare_threads();
    while (!spare.empty()) {
        std::unique_ptr<WorkThread> last = std::move(spare.back());
        spare.pop_back();
        if (last->process_ == ::getpid()) return last;
    }
    return std::unique_ptr<WorkThread>(new WorkThread);
}

void WorkThread::give_back(std::unique_ptr<WorkThread> thread) {
    spare_threads().push_back(std::move(thread));
}

void WorkThread::begin(const std::function<void()>& work) {
    const std::lock_guard lock(shared_->mutex);
    shared_->work = &work;
    shared_->changed.notify_all();
}

bool WorkThread::ended_within(std::chrono::milliseconds time) {
    std::unique_lock lock(shared_->mutex);
    return shared_->changed.wait_for(lock, time, [&] { return shared_->work == nullptr; });
}

} // namespace facetmill::python
