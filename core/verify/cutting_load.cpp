#include "core/verify/cutting_load.h"

#include <algorithm>

namespace facetmill {

void LoadMeter::add(double length, double feed, double volume, std::size_t motion) {
    load_.volume += volume;
    if (!(feed > 0)) return;
    if (!(length > 0)) {
        still_ += volume;
        return;
    }
    pieces_.push_back({length, length / feed, volume + still_, motion});
    length_ += length;
    still_ = 0;
    if (length_ < stretch_) return;
    longer_ = true;
    look_back();
    while (length_ - pieces_.front().length >= stretch_) {
        length_ -= pieces_.front().length;
        pieces_.pop_front();
    }
}

void LoadMeter::look_back() {
    // From the last piece's end backward.
    const Piece& last = pieces_.back();
    double length = 0, time = 0, volume = 0;
    for (auto p = pieces_.rbegin(); p != pieces_.rend(); ++p) {
        const double share = std::min(1.0, (stretch_ - length) / p->length);
        length += share * p->length;
        time += share * p->time;
        volume += share * p->volume;
        if (share < 1) break;
    }
    look(length, time, volume, last.motion);
    // From the beginning of each piece to where a stretch ends, in the last piece.
    length = length_, time = 0, volume = 0;
    for (const Piece& p : pieces_) {
        time += p.time;
        volume += p.volume;
    }
    for (const Piece& p : pieces_) {
        if (length < stretch_) break;
        const double beyond = length - stretch_;
        if (beyond < last.length) {
            const double share = beyond / last.length;
            look(stretch_, time - share * last.time, volume - share * last.volume, last.motion);
        }
        length -= p.length;
        time -= p.time;
        volume -= p.volume;
    }
}

void LoadMeter::look(double length, double time, double volume, std::size_t motion) {
    // Shorter ones as if their pace went on.
    const double rate = volume / (length < stretch_ ? time * stretch_ / length : time);
    if (!(rate > load_.peak_rate)) return;
    load_.peak_rate = rate;
    load_.peak_motion = motion;
}

void LoadMeter::lift() {
    if (!longer_ && !pieces_.empty()) {
        double time = 0, volume = still_;
        for (const Piece& p : pieces_) {
            time += p.time;
            volume += p.volume;
        }
        look(length_, time, volume, pieces_.back().motion);
    }
    pieces_.clear();
    length_ = still_ = 0;
    longer_ = false;
}

} // namespace facetmill
