// Plays a plan back: keeps position and speed, moves the tool, and lets the stock follow. No widgets; the
// window draws what it says. The stock is cut in threads of their own, so the position that is shown lags
// behind the one that is wanted rather than the window behind the user; while it lags, play waits.
#pragma once

#include "ui/playback_track.h"
#include "ui/stock_player.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace facetmill::ui {

struct PlaybackSpeed {
    enum class Unit { machining_time, motions_per_second };
    Unit unit = Unit::machining_time;
    double value = 10; ///< times as fast as the machine, or motions per second
    bool operator==(const PlaybackSpeed&) const = default;
};

class PlaybackController : public QObject {
    Q_OBJECT
public:
    explicit PlaybackController(QObject* parent = nullptr);

    /// Another plan, from its start; null: none. `live` makes the stock that is seen while it moves, `fine`
    /// (or nothing) the one for when it rests.
    void load(PlaybackTrackPtr track, StockPlayer::Source live, StockPlayer::Source fine);
    bool loaded() const { return track_ != nullptr; }
    const PlaybackTrack& track() const { return *track_; }

    /// Where the user wants it.
    double target() const { return target_; }
    /// What is shown: stock and tool together. The target itself while the stock does not follow.
    double position() const;
    /// The stock has not caught up yet.
    bool behind() const { return follow_ && live_.behind(); }
    bool playing() const { return timer_.isActive(); }
    void play();
    void pause();
    void toggle();
    /// Whole motions, from the next or last whole one; stops playing.
    void step(int by);
    void go_to(double position);
    void go_to(const MotionPlace& place) { go_to(track_->position_of(place)); }
    /// The tool was put there by somebody else: playing and steps go on from there.
    void put(double position);
    /// Nobody has played since.
    bool put_by_others() const { return put_by_others_; }
    PlaybackSpeed speed() const { return speed_; }
    void set_speed(const PlaybackSpeed& speed);
    /// Whether the stock is cut along. At first it is not.
    void set_follow(bool on);
    bool follow() const { return follow_; }

    /// Surface of the stock at the position; empty before the first, or while the stock does not follow.
    std::vector<std::shared_ptr<const StockPatch>> stock() const;
    /// The finer surface of the same position; empty until it is there.
    std::vector<std::shared_ptr<const StockPatch>> fine_stock() const;
    CutterLocation tool() const { return track_->location(position()); }

signals:
    void loaded_changed();
    /// Target, position or stock.
    void moved();
    void playing_changed();
    void failed(const QString& why);

private:
    void tick();
    void aim(double position);

    PlaybackTrackPtr track_;
    StockPlayer::Source live_source_, fine_source_;
    double target_ = 0;
    bool follow_ = false, put_by_others_ = false;
    PlaybackSpeed speed_;
    QTimer timer_, rest_timer_;
    QElapsedTimer clock_;
    StockPlayer live_, fine_;
};

} // namespace facetmill::ui
