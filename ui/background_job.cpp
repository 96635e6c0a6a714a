#include "ui/background_job.h"

#include "core/base/parallel.h"
#include "ui/aside.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <chrono>
#include <new>

namespace facetmill::ui {

struct BackgroundJob::Run {
    QString title;
    Work work;
    Then then;
    Job job;
    JobEnd end;
};

namespace {

/// Calls the work and tells how it ended; nothing that it throws gets past here.
JobEnd run_guarded(const BackgroundJob::Work& work, Job& job) {
    try {
        // What is not saved is on the disk before work begins that might bring the program down.
        while (!finish_aside(std::chrono::milliseconds(20)))
            Progress(job).check();
        work(Progress(job));
        // A result that came too late is one the user has already given up.
        return {job.cancelled() ? JobEnd::How::cancelled : JobEnd::How::done, {}};
    } catch (const Cancelled&) {
        return {JobEnd::How::cancelled, {}};
    } catch (const std::bad_alloc&) {
        return {JobEnd::How::failed,
                QObject::tr("Not enough memory (close other programs or use a smaller part)")};
    } catch (const std::exception& e) {
        return {JobEnd::How::failed, worded(std::string_view(e.what()))};
    } catch (...) {
        return {JobEnd::How::failed, QObject::tr("An unknown exception ended the job")};
    }
}

} // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
    timer_.setInterval(50);
    connect(&timer_, &QTimer::timeout, this, &BackgroundJob::poll);
}

BackgroundJob::~BackgroundJob() {
    if (current_) current_->job.cancel();
    if (thread_.joinable()) thread_.join();
}

bool BackgroundJob::cancelling() const {
    return current_ && current_->job.cancelled();
}

void BackgroundJob::start(const QString& title, Work work, Then then) {
    auto run = std::make_shared<Run>();
    run->title = title;
    run->work = std::move(work);
    run->then = std::move(then);
    if (!current_) {
        launch(std::move(run));
        return;
    }
    current_->job.cancel();
    const auto displaced = std::exchange(waiting_, std::move(run));
    if (displaced && displaced->then) displaced->then({JobEnd::How::cancelled, {}});
}

void BackgroundJob::launch(std::shared_ptr<Run> run) {
    current_ = std::move(run);
    emit started(current_->title);
    timer_.start();
    thread_ = std::thread([this, r = current_] {
        lower_thread_priority();
        r->end = run_guarded(r->work, r->job);
        // Whatever the work captured is freed here: giving back a large mesh would hold up the window.
        r->work = nullptr;
        QMetaObject::invokeMethod(
            this, [this, r] { finish(r); }, Qt::QueuedConnection);
    });
}

void BackgroundJob::cancel() {
    if (current_) current_->job.cancel();
    if (const auto displaced = std::exchange(waiting_, nullptr); displaced && displaced->then)
        displaced->then({JobEnd::How::cancelled, {}});
}

void BackgroundJob::poll() {
    if (current_) emit progressed(current_->job.fraction(), worded(current_->job.label()));
}

void BackgroundJob::finish(const std::shared_ptr<Run>& run) {
    thread_.join(); // the thread has nothing left to do but return
    timer_.stop();
    // A cancel that came between the last instruction of the work and now counts too.
    if (run->end.done() && run->job.cancelled()) run->end.how = JobEnd::How::cancelled;
    current_ = nullptr;
    emit ended(run->end);
    if (run->then) run->then(run->end);
    if (waiting_ && !current_) launch(std::exchange(waiting_, nullptr));
}

} // namespace facetmill::ui
