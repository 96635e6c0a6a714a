#include "ui/stock_player.h"

#include "core/base/parallel.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>

namespace facetmill::ui {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Cutting stops about so often for a look at what is wanted now, and for a picture.
constexpr double slice_ms = 40;
constexpr std::size_t triangles_in_group = 10'000;

} // namespace

StockPlayer::StockPlayer(QObject* parent) : QObject(parent) {}

StockPlayer::~StockPlayer() {
    {
        const std::lock_guard lock(mutex_);
        order_.quit = true;
        if (job_) job_->cancel();
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void StockPlayer::load(Source source) {
    source_ = std::move(source);
    target_.reset();
    frame_ = nullptr;
    {
        const std::lock_guard lock(mutex_);
        order_.source = source_;
        ++order_.load;
        order_.target.reset();
        if (job_) job_->cancel();
    }
    if (!thread_.joinable() && source_) thread_ = std::thread([this] { run(); });
    wake_.notify_all();
}

void StockPlayer::unload() {
    if (source_) load({});
}

void StockPlayer::show(double position) {
    if (!loaded() || target_ == position) return;
    target_ = position;
    {
        const std::lock_guard lock(mutex_);
        order_.target = position;
    }
    wake_.notify_all();
}

void StockPlayer::run() {
    lower_thread_priority();
    for (;;) {
        QString why;
        try {
            work();
            return;
        } catch (const Cancelled&) {
            continue; // another order, or the end
        } catch (const std::bad_alloc&) {
            why = tr("Not enough memory to play back the stock");
        } catch (const std::exception& e) {
            why = worded(std::string_view(e.what()));
        }
        std::unique_lock lock(mutex_);
        const std::uint64_t load = order_.load;
        lock.unlock();
        QMetaObject::invokeMethod(
            this,
            [this, why, load] {
                if (load != order_.load) return; // written by this thread only
                unload();
                emit failed(why);
            },
            Qt::QueuedConnection);
        lock.lock();
        wake_.wait(lock, [&] { return order_.quit || order_.load != load; });
    }
}

void StockPlayer::work() {
    std::unique_ptr<StockPlayback> playback;
    PatchGroups groups(triangles_in_group);
    std::uint64_t load = 0;
    double reached = -1; // what was published
    auto published = Clock::now();
    double slice = 16; // motions
    for (;;) {
        std::unique_lock lock(mutex_);
        const auto wanted = [&] {
            return order_.quit || order_.load != load
                   || (playback && order_.target && *order_.target != reached);
        };
        wake_.wait(lock, wanted);
        if (order_.quit) return;
        const auto job = job_ = std::make_shared<Job>();
        const bool fresh = order_.load != load;
        const Source source = fresh ? order_.source : Source();
        load = order_.load;
        const std::optional<double> target = order_.target;
        lock.unlock();
        const Progress progress(*job);
        if (fresh) {
            playback = nullptr;
            reached = -1;
            slice = 16;
            if (source) playback = source(progress);
            continue;
        }
        const double at = playback->position();
        const double next = std::min(*target, std::floor(at) + slice);
        const auto start = Clock::now();
        playback->go_to(*target < at ? *target : next, progress);
        const double ms = ms_since(start);
        if (*target >= at) {
            if (ms < 0.5 * slice_ms)
                slice = std::min(2 * slice, 1e6);
            else if (ms > 1.5 * slice_ms)
                slice = std::max(std::floor(slice / 2), 1.0);
        }
        const bool arrived = *target < at || next == *target;
        if (!arrived && ms_since(published) < slice_ms) continue;
        publish(*playback, groups, progress, load);
        reached = arrived ? *target : -1;
        published = Clock::now();
    }
}

void StockPlayer::publish(StockPlayback& playback, PatchGroups& groups, const Progress& progress,
                          std::uint64_t load) {
    auto frame = std::make_shared<StockFrame>();
    frame->patches = groups.of(playback.patches(progress));
    frame->position = playback.position();
    const std::lock_guard lock(mutex_);
    finished_ = std::move(frame);
    finished_load_ = load;
    if (std::exchange(announced_, true)) return;
    QMetaObject::invokeMethod(this, &StockPlayer::fetch, Qt::QueuedConnection);
}

void StockPlayer::fetch() {
    {
        const std::lock_guard lock(mutex_);
        announced_ = false;
        if (finished_load_ != order_.load) return;
        frame_ = std::move(finished_);
        finished_ = nullptr;
    }
    if (frame_) emit framed();
}

} // namespace facetmill::ui
