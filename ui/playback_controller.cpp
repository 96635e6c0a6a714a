#include "ui/playback_controller.h"

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {
constexpr int tick_ms = 33;
constexpr int stock_rest_ms = 400;   // without a new position: the finer stock is worth its time
constexpr double longest_tick = 0.2; // s; a window that was held up does not jump
} // namespace

PlaybackController::PlaybackController(QObject* parent) : QObject(parent) {
    timer_.setInterval(tick_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &PlaybackController::tick);
    rest_timer_.setSingleShot(true);
    rest_timer_.setInterval(stock_rest_ms);
    connect(&rest_timer_, &QTimer::timeout, this, [this] {
        if (!fine_source_ || !follow_ || playing()) return;
        if (!fine_.loaded()) fine_.load(fine_source_);
        fine_.show(target_);
    });
    connect(&live_, &StockPlayer::framed, this, &PlaybackController::moved);
    connect(&fine_, &StockPlayer::framed, this, [this] {
        if (!fine_stock().empty()) emit moved();
    });
    const auto fail = [this](const QString& why) {
        pause();
        set_follow(false);
        emit failed(why);
    };
    connect(&live_, &StockPlayer::failed, this, fail);
    connect(&fine_, &StockPlayer::failed, this, [this](const QString&) {
        fine_source_ = {}; // the coarse one is still good
    });
}

void PlaybackController::load(PlaybackTrackPtr track, StockPlayer::Source live, StockPlayer::Source fine) {
    pause();
    live_.unload();
    fine_.unload();
    rest_timer_.stop();
    track_ = track && track->motion_count() > 0 ? std::move(track) : nullptr;
    live_source_ = std::move(live);
    fine_source_ = std::move(fine);
    target_ = 0;
    put_by_others_ = false;
    follow_ = follow_ && track_;
    if (follow_) {
        live_.load(live_source_);
        aim(0);
    }
    emit loaded_changed();
    emit moved();
}

double PlaybackController::position() const {
    if (!follow_) return target_;
    return live_.frame() ? live_.frame()->position : target_;
}

std::vector<std::shared_ptr<const StockPatch>> PlaybackController::stock() const {
    if (!follow_ || !live_.frame()) return {};
    return live_.frame()->patches;
}

std::vector<std::shared_ptr<const StockPatch>> PlaybackController::fine_stock() const {
    if (!follow_ || playing() || !fine_.frame() || fine_.frame()->position != position()) return {};
    return fine_.frame()->patches;
}

void PlaybackController::play() {
    if (!loaded() || playing()) return;
    put_by_others_ = false;
    if (target_ >= double(track_->motion_count())) aim(0); // at the end: from the start again
    rest_timer_.stop();
    clock_.start();
    timer_.start();
    emit playing_changed();
}

void PlaybackController::pause() {
    if (!playing()) return;
    timer_.stop();
    if (follow_) rest_timer_.start();
    emit playing_changed();
    emit moved();
}

void PlaybackController::toggle() {
    if (playing())
        pause();
    else
        play();
}

void PlaybackController::step(int by) {
    if (!loaded()) return;
    pause();
    const double whole = by > 0 ? std::floor(target_) : std::ceil(target_);
    go_to(whole + by);
}

void PlaybackController::go_to(double position) {
    if (!loaded()) return;
    put_by_others_ = false;
    aim(position);
    clock_.start();
    emit moved();
}

void PlaybackController::put(double position) {
    if (!loaded() || playing() || std::clamp(position, 0.0, double(track_->motion_count())) == target_)
        return;
    put_by_others_ = true;
    aim(position);
    emit moved();
}

void PlaybackController::aim(double position) {
    target_ = std::clamp(position, 0.0, double(track_->motion_count()));
    if (!follow_) return;
    live_.show(target_);
    if (!playing()) rest_timer_.start();
}

void PlaybackController::set_speed(const PlaybackSpeed& speed) {
    speed_ = speed;
}

void PlaybackController::set_follow(bool on) {
    on = on && loaded();
    if (on == follow_) return;
    follow_ = on;
    if (on) {
        live_.load(live_source_);
        aim(target_);
    } else {
        live_.unload();
        fine_.unload();
        rest_timer_.stop();
    }
    emit moved();
}

void PlaybackController::tick() {
    if (behind()) return; // the machine is as fast as it is
    const double seconds = std::min(double(clock_.restart()) * 1e-3, longest_tick);
    const double end = double(track_->motion_count());
    double next = 0;
    if (speed_.unit == PlaybackSpeed::Unit::motions_per_second)
        next = target_ + seconds * speed_.value;
    else
        next = track_->position_at(track_->time_at(target_) + seconds * speed_.value);
    aim(std::max(next, target_));
    if (target_ >= end) pause();
    emit moved();
}

} // namespace facetmill::ui
