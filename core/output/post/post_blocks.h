// Blocks of one program, one after the other: what is modal is left out, lines are numbered and no longer
// than the control reads. Internal to the room.
#pragma once

#include "core/output/post/arc.h"
#include "core/output/post/nc_line.h"
#include "core/output/post/nc_text.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace facetmill {

/// What the words in the braces of a template stand for.
using TemplateValues = std::map<std::string, std::string, std::less<>>;

class PostBlocks {
public:
    /// `rapid_mm_per_min`: of rapids that need a feed.
    PostBlocks(const Post& post, LengthUnit unit, double rapid_mm_per_min);

    /// Lines of a template; those that come out empty are left out. Afterwards nothing is modal. Throws
    /// Error(syntax) for one that would not be read back.
    void lines(const std::vector<std::string>& templates, const TemplateValues& values);
    /// Text that begins the next motion.
    void before_next(const std::string& text, const TemplateValues& values);
    void feed_mode(bool inverse_time);

    /// A word for the next motion: mm, radians, or a part of a unit vector.
    void set(NcWord word, double value);
    /// As if it had not been set.
    void leave_out(NcWord word) { slots_[std::size_t(word)].next.reset(); }
    /// True when any of the words set changes something as it is printed.
    bool moves() const;
    bool changes(NcWord word) const;
    /// What a word would say now, and said last, in its last digit; nothing where it said nothing.
    std::optional<std::int64_t> said(NcWord word) const { return slots_[std::size_t(word)].last; }
    void rapid();
    void feed_per_minute(double mm_per_min);
    void feed_for(double seconds);
    /// An arc from where the words said last; those of its end are set.
    void arc(const PlaneArc& arc, double mm_per_min);
    /// Arcs lie in XY again, as templates take it.
    void usual_plane();
    /// A word's value as it would be printed, in the core's unit.
    double printed(NcWord word, double value) const;

    std::string& text() { return text_; }
    std::size_t blocks() const { return blocks_; } ///< that move an axis
    std::size_t lines_written() const { return lines_; }

private:
    struct Slot {
        std::optional<std::int64_t> last, next;
        int decimals = 4;
        double scale = 1; ///< of the word to the core's unit
    };
    void begin(NcCode code, const std::string& text);
    void straight_feed();
    bool vector() const; ///< the next block gives the tool axis
    void words(const std::array<bool, 3>& always = {});
    void add(const std::string& text);
    void arc_word(NcWord word, double mm);
    const std::string& plane_code(int normal) const;
    void end_block();
    void feed_word(double mm_per_min);
    void line(const std::string& body);
    bool moves_axis(const std::string& body) const;
    std::string filled(const std::string& line, const TemplateValues& values) const;

    const Post& post_;
    NcLineReader reader_;
    std::string text_, block_, before_;
    std::array<Slot, nc_words> slots_;
    std::string rapid_code_, feed_code_, minute_code_, inverse_code_, straight_, straight_vectors_,
        rapid_block_;
    double rapid_mm_per_min_;
    NcCode motion_ = NcCode::none;
    int plane_ = -1; ///< axis across the plane of arcs; -1: nobody said
    std::optional<std::int64_t> feed_;
    bool inverse_ = false, mode_known_ = false;
    double feed_scale_ = 1;
    int feed_digits_ = 2;
    long number_;
    std::size_t blocks_ = 0, lines_ = 0;
};

} // namespace facetmill
