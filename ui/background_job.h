// Work in a thread of its own. However it ends, done, cancelled or failed, the end reaches the thread of this
// object by the same queued signal, and exactly once.
//
//     auto result = std::make_shared<Result>();
//     job.start([=](const Progress& p) { *result = compute(p); }, [=](const JobEnd& end) { ... });
#pragma once

#include "core/base/progress.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <thread>

namespace facetmill::ui {

struct JobEnd {
    enum class How { done, cancelled, failed };
    How how = How::done;
    QString message; ///< why, when it failed; one line
    bool done() const { return how == How::done; }
};

class BackgroundJob : public QObject {
    Q_OBJECT
public:
    using Work = std::function<void(const Progress&)>;
    using Then = std::function<void(const JobEnd&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    /// Cancels and waits for the thread, at most as long as the work takes to see the flag; reports nothing.
    ~BackgroundJob() override;

    /// Runs `work` in a thread; `then` and `ended` are called from this object's event loop. Where another
    /// job still runs it is cancelled, and the new one starts when it has ended; a waiting one that gives way
    /// ends as cancelled.
    void start(const QString& title, Work work, Then then = {});
    /// Raises the flag and returns at once. The end is "cancelled" also when the work finishes without seeing
    /// it.
    void cancel();
    /// From `start` until `ended` is emitted.
    bool running() const { return current_ != nullptr; }
    bool cancelling() const;

signals:
    void started(const QString& title);
    /// Every 50 ms while the job runs.
    void progressed(double fraction, const QString& label);
    void ended(const facetmill::ui::JobEnd& end);

private:
    struct Run;
    void launch(std::shared_ptr<Run> run);
    void finish(const std::shared_ptr<Run>& run);
    void poll();

    std::shared_ptr<Run> current_, waiting_;
    std::thread thread_;
    QTimer timer_;
};

} // namespace facetmill::ui
