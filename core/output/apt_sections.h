// Puts the motions of an APT file into sections: the statements before a motion say what holds for it.
// Internal to the room; the public door is apt.h.
#pragma once

#include "core/output/apt.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::detail {

/// FEDRAT: mm per minute or per turn of the spindle.
struct AptFeed {
    double value = 0;
    bool per_turn = false;
    bool operator==(const AptFeed&) const = default;
};

class AptSections {
public:
    /// `tell` hears what was read over, with its line.
    explicit AptSections(std::function<void(const std::string& what, long line)> tell)
        : tell_(std::move(tell)) {}

    // What holds from the next motion on.
    void operation(std::string name) { next_.operation = std::move(name); }
    void tool_name(std::string name) { next_.tool_name = std::move(name); }
    void cutter(const AptCutter& cutter) { next_.cutter = cutter; }
    void tool_number(long number) { next_.number = number; }
    void feed(const AptFeed& feed) { feed_ = feed; }
    void spindle(double rpm, long line) { spindle_ = {rpm, line}; }
    void coolant(Coolant coolant, long line) { coolant_ = {coolant, line}; }

    void move(const Vec3& tip, const Vec3& axis, bool rapid, long line);
    /// Where the tool stands; null where that is not known.
    const CutterLocation* position() const;
    /// False until something was cut.
    bool cuts() const { return cuts_; }

    /// Moves the sections into `result`; `line` is the file's last.
    void finish(AptReadResult& result, long line);

private:
    /// Names and numbers that are given before the motion they are for, in any order.
    struct Head {
        std::optional<std::string> operation, tool_name;
        std::optional<AptCutter> cutter;
        std::optional<long> number;
    };
    template <class T>
    struct Given {
        T value;
        long line;
    };
    struct FeedChange {
        std::size_t motion = 0;
        AptFeed feed;
    };

    bool next_is_another_tool() const;
    void take_head(long line);
    void begin_section(bool another_tool, long line);
    void note_cut();
    void close_section(long line);
    std::optional<double> minute_feed(const AptFeed& feed) const;

    std::function<void(const std::string&, long)> tell_;
    Head next_;
    std::optional<AptFeed> feed_;
    std::optional<Given<double>> spindle_;
    std::optional<Given<Coolant>> coolant_;
    bool cuts_ = false;

    std::vector<std::shared_ptr<const ClSection>> sections_; ///< those that are complete
    std::vector<AptReadResult::Tool> tools_;

    // The section that is being read.
    ClSection section_;
    AptReadResult::Tool tool_;
    std::optional<CutterLocation> from_; ///< where the one before ended, with the same tool
    std::vector<FeedChange> feeds_;      ///< where it cuts
    std::optional<double> section_spindle_;
    std::optional<Coolant> section_coolant_;
};

} // namespace facetmill::detail
