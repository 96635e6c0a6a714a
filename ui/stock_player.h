// Cuts the stock to where playback is, in a thread of its own, and publishes the finished surface. Positions
// can be asked for as often as one likes: only the newest counts, and on long ways pictures from halfway are
// published too.
#pragma once

#include "core/base/progress.h"
#include "core/verify/playback.h"
#include "core/verify/stock_surface.h"

#include <QObject>
#include <QString>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace facetmill::ui {

struct StockFrame {
    double position = 0;
    /// Groups of the playback's patches.
    std::vector<std::shared_ptr<const StockPatch>> patches;
};

class StockPlayer : public QObject {
    Q_OBJECT
public:
    /// Runs in the player's thread.
    using Source = std::function<std::unique_ptr<StockPlayback>(const Progress&)>;

    explicit StockPlayer(QObject* parent = nullptr);
    /// Cancels and waits for the thread.
    ~StockPlayer() override;

    /// Another stock; what was published of the one before is gone at once.
    void load(Source source);
    void unload();
    bool loaded() const { return bool(source_); }
    void show(double position);
    /// The newest one, or null.
    std::shared_ptr<const StockFrame> frame() const { return frame_; }
    /// True from `show` until the frame of that position is there.
    bool behind() const { return loaded() && target_ && (!frame_ || frame_->position != *target_); }

signals:
    /// A newer frame is there. Frames nobody has looked at yet are replaced, not queued up.
    void framed();
    void failed(const QString& why);

private:
    void run();
    void work();
    void publish(StockPlayback& playback, PatchGroups& groups, const Progress& progress, std::uint64_t load);
    void fetch();

    // of this object's thread
    Source source_;
    std::optional<double> target_;
    std::shared_ptr<const StockFrame> frame_;
    std::thread thread_;

    // between the threads
    struct Order {
        Source source;
        std::uint64_t load = 0; ///< counts the sources
        std::optional<double> target;
        bool quit = false;
    };
    std::mutex mutex_;
    std::condition_variable wake_;
    Order order_;
    std::shared_ptr<Job> job_; ///< what the thread is doing
    std::shared_ptr<const StockFrame> finished_;
    std::uint64_t finished_load_ = 0;
    bool announced_ = false;
};

} // namespace facetmill::ui
