// What a program's cutter takes from the stock, and how much of it at once: a measure of what loads it, for
// programs of one part in one material. Power is the volume cut in a time times the specific cutting force of
// the material (Kienzle 1952), which nobody here knows, as nobody knows spindle, holder and chip.
#pragma once

#include <cstddef>
#include <deque>

namespace facetmill {

struct CuttingLoad {
    double volume = 0; ///< of the stock, taken away by the program; mm^3
    /// The largest volume in a time, mm^3/min, of stretches of the tip's path as long as the cutter is wide,
    /// at the feeds that are programmed; 0 where these are not known. Rapids end a stretch; what is cut
    /// between two of them on less than such a length counts as cut on that length. Taken from the rays of
    /// the stock, and evened out within pieces of motions that are up to as long: right to about the
    /// resolution's share of the cutter's width, a fortieth as verdicts have it.
    double peak_rate = 0;
    std::size_t peak_motion = std::size_t(-1); ///< at which such a stretch ends; -1: nothing is cut
};

/// Finds that, piece by piece of the path.
class LoadMeter {
public:
    /// `stretch`: the length, mm.
    explicit LoadMeter(double stretch) : stretch_(stretch) {}
    /// A piece of a motion at feed: of a length (mm), at a feed (mm/min; 0: not known), that takes away a
    /// volume (mm^3).
    void add(double length, double feed, double volume, std::size_t motion);
    /// A rapid, or the program's end.
    void lift();
    const CuttingLoad& load() const { return load_; }

private:
    struct Piece {
        double length, time, volume; ///< mm, min, mm^3
        std::size_t motion;
    };
    void look(double length, double time, double volume, std::size_t motion);
    /// The stretches that end with the last piece, and those that begin with a piece and end in the last one.
    void look_back();

    double stretch_;
    CuttingLoad load_;
    std::deque<Piece> pieces_; ///< the last ones, at least a stretch together where there are so many
    double length_ = 0;        ///< of them
    double still_ = 0;         ///< cut without a way, while the axis turned; part of the piece that comes
    bool longer_ = false;      ///< a whole stretch has been looked at since the last rapid
};

} // namespace facetmill
