#include "core/output/post/post_blocks.h"

#include "core/base/error.h"
#include "core/base/vec.h"

namespace facetmill {

namespace {

/// Significant digits of the feed of a block that has its own time.
constexpr int inverse_digits = 6;

} // namespace

PostBlocks::PostBlocks(const Post& post, LengthUnit unit, double rapid_mm_per_min)
    : post_(post), reader_(post), rapid_code_(post.code(NcCode::rapid)), feed_code_(post.code(NcCode::feed)),
      minute_code_(post.code(NcCode::per_minute)), inverse_code_(post.code(NcCode::inverse_time)),
      straight_(post.code(NcCode::straight)), straight_vectors_(post.code(NcCode::straight_vectors)),
      rapid_block_(post.code(NcCode::rapid_block)), rapid_mm_per_min_(rapid_mm_per_min),
      feed_scale_(unit == LengthUnit::inch ? 1 / (mm_per_inch * post.inch_feed) : 1),
      feed_digits_(post.feed_digits(unit)), number_(post.block_first) {
    for (std::size_t i = 0; i < nc_words; ++i) {
        Slot& s = slots_[i];
        const NcWord w = NcWord(i);
        if (w <= NcWord::z) {
            s.decimals = unit == LengthUnit::inch ? post.inch_decimals : post.mm_decimals;
            s.scale = 1 / mm_per(unit);
        } else if (w <= NcWord::c) {
            s.decimals = post.angle_decimals;
            s.scale = 180 / pi;
        } else {
            s.decimals = post.vector_decimals;
        }
    }
}

std::string PostBlocks::filled(const std::string& line, const TemplateValues& values) const {
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] != '{') {
            out += line[i];
            continue;
        }
        const std::size_t close = line.find('}', i);
        const auto value = values.find(std::string_view(line).substr(i + 1, close - i - 1));
        if (value != values.end()) out += value->second;
        i = close;
    }
    while (!out.empty() && out.back() == ' ')
        out.pop_back();
    return out;
}

void PostBlocks::line(const std::string& body) {
    std::string number;
    // Ends of the tape and the number of the program stand before all blocks; what begins with a blank goes
    // on with the block before.
    const bool no_block = body == "%" || body[0] == ' '
                          || (body.size() > 1 && body[0] == 'O' && body[1] >= '0' && body[1] <= '9');
    if (post_.numbers_blocks && !no_block) {
        number = post_.block_letter + std::to_string(number_)
                 + (post_.block_letter.empty() ? " " : post_.separator);
        number_ =
            number_ + post_.block_step > post_.block_last ? post_.block_first : number_ + post_.block_step;
    }
    if (number.size() + body.size() > post_.max_block)
        throw Error(ErrorCode::limit_exceeded, "post '" + printable(post_.name) + "'",
                    "the block '" + printable(body) + "' is longer than " + std::to_string(post_.max_block)
                        + " characters",
                    "shorten the line of the post, or the names in it");
    text_ += number;
    text_ += body;
    text_ += post_.line_end;
    ++lines_;
}

/// A line of a template, as it will be read back.
bool PostBlocks::moves_axis(const std::string& body) const {
    if (body == "%") return false;
    NcLine read;
    try {
        reader_.read(body, read, "", 0);
    } catch (const Error& e) {
        throw Error(e.code(), "post '" + printable(post_.name) + "'",
                    "the line '" + printable(body) + "': " + e.message(), e.remedy());
    }
    return read.has_axis();
}

void PostBlocks::lines(const std::vector<std::string>& templates, const TemplateValues& values) {
    for (const std::string& t : templates) {
        const std::string body = filled(t, values);
        if (body.empty()) continue;
        if (moves_axis(body)) ++blocks_;
        line(body);
    }
    for (Slot& s : slots_)
        s.last.reset();
    feed_.reset();
    motion_ = NcCode::none;
    mode_known_ = false;
    plane_ = -1;
}

void PostBlocks::before_next(const std::string& text, const TemplateValues& values) {
    before_ = filled(text, values);
}

void PostBlocks::feed_mode(bool inverse_time) {
    if (mode_known_ && inverse_ == inverse_time) return;
    inverse_ = inverse_time;
    mode_known_ = true;
    feed_.reset();
    const std::string& code = inverse_time ? inverse_code_ : minute_code_;
    if (!code.empty()) line(code);
}

void PostBlocks::set(NcWord word, double value) {
    Slot& s = slots_[std::size_t(word)];
    s.next = nc_digits(value * s.scale, s.decimals);
}

bool PostBlocks::changes(NcWord word) const {
    const Slot& s = slots_[std::size_t(word)];
    return s.next && s.next != s.last;
}

bool PostBlocks::moves() const {
    for (std::size_t i = 0; i < nc_words; ++i)
        if (changes(NcWord(i))) return true;
    return false;
}

void PostBlocks::add(const std::string& text) {
    if (!block_.empty()) block_ += post_.separator;
    block_ += text;
}

void PostBlocks::begin(NcCode code, const std::string& text) {
    if (!straight_.empty() || motion_ != code || !post_.modal) add(text);
    motion_ = code;
    if (!before_.empty()) add(before_);
    before_.clear();
}

bool PostBlocks::vector() const {
    const auto given = [&](NcWord w) { return slots_[std::size_t(w)].next.has_value(); };
    return given(NcWord::i) || given(NcWord::j) || given(NcWord::k);
}

void PostBlocks::words(const std::array<bool, 3>& always) {
    // A part of a vector that is left out would count as 0.
    const bool vector = this->vector();
    for (std::size_t i = 0; i < nc_words; ++i) {
        Slot& s = slots_[i];
        if (!s.next) continue;
        const bool part = vector && NcWord(i) >= NcWord::i;
        if (s.next != s.last || !post_.modal || part || (i < 3 && always[i])) {
            add(post_.words[i]);
            if (post_.plus && *s.next >= 0) block_ += '+';
            append_number(block_, *s.next, s.decimals, post_);
        }
        s.last = s.next;
        s.next.reset();
    }
}

void PostBlocks::end_block() {
    line(block_);
    ++blocks_;
}

void PostBlocks::rapid() {
    block_.clear();
    begin(NcCode::rapid, straight_.empty() ? rapid_code_ : vector() ? straight_vectors_ : straight_);
    words();
    if (post_.rapid_feed) feed_word(rapid_mm_per_min_);
    if (!rapid_block_.empty()) block_ += post_.separator + rapid_block_;
    end_block();
}

void PostBlocks::straight_feed() {
    block_.clear();
    begin(NcCode::feed, straight_.empty() ? feed_code_ : vector() ? straight_vectors_ : straight_);
    words();
}

void PostBlocks::feed_per_minute(double mm_per_min) {
    straight_feed();
    feed_word(mm_per_min);
    end_block();
}

const std::string& PostBlocks::plane_code(int normal) const {
    return post_.code(normal == 2 ? NcCode::plane_xy : normal == 1 ? NcCode::plane_xz : NcCode::plane_yz);
}

void PostBlocks::usual_plane() {
    if (plane_ >= 0 && plane_ != 2) line(plane_code(2));
    plane_ = -1;
}

double PostBlocks::printed(NcWord word, double value) const {
    const Slot& s = slots_[std::size_t(word)];
    return nc_value(nc_digits(value * s.scale, s.decimals), s.decimals) / s.scale;
}

/// A length that is no place.
void PostBlocks::arc_word(NcWord word, double mm) {
    const Slot& s = slots_[std::size_t(NcWord::x)];
    const std::int64_t digits = nc_digits(mm * s.scale, s.decimals);
    add(post_.word(word));
    if (post_.plus && digits >= 0) block_ += '+';
    append_number(block_, digits, s.decimals, post_);
}

void PostBlocks::arc(const PlaneArc& arc, double mm_per_min) {
    const bool clockwise = arc.angle < 0;
    block_.clear();
    std::array<bool, 3> in_plane{};
    for (const int k : {arc.first(), arc.second()})
        in_plane[std::size_t(k)] = true;
    if (post_.arcs == Post::Arcs::pole) {
        add(post_.code(NcCode::arc_centre));
        for (const int k : {arc.first(), arc.second()})
            arc_word(NcWord(k), arc.centre[k]);
        line(block_);
        block_.clear();
        begin(NcCode::arc, post_.code(NcCode::arc));
        words(in_plane);
        add(post_.code(clockwise ? NcCode::turns_clockwise : NcCode::turns_anticlockwise));
    } else {
        if (plane_ != arc.normal && !plane_code(arc.normal).empty()) add(plane_code(arc.normal));
        plane_ = arc.normal;
        const NcCode code = clockwise ? NcCode::arc_clockwise : NcCode::arc_anticlockwise;
        begin(code, post_.code(code));
        words(in_plane);
        if (post_.arcs == Post::Arcs::radius)
            arc_word(NcWord::radius, std::abs(arc.angle) > pi ? -arc.radius() : arc.radius());
        else
            for (int k = 0; k < 3; ++k)
                if (in_plane[std::size_t(k)]) arc_word(post_.centre_word(k), arc.centre[k] - arc.from[k]);
    }
    feed_word(mm_per_min);
    end_block();
}

void PostBlocks::feed_word(double mm_per_min) {
    const std::int64_t feed = nc_digits(mm_per_min * feed_scale_, feed_digits_);
    if (feed < 1)
        throw Error(ErrorCode::out_of_range, "post '" + printable(post_.name) + "'",
                    "a feed of " + format_number(mm_per_min) + " mm/min has no digits left",
                    "raise the feed, or the feed's decimals in the post");
    if (feed_ != feed || !post_.modal) {
        block_ += post_.separator + post_.word(NcWord::feed);
        append_number(block_, feed, feed_digits_, post_);
    }
    feed_ = feed;
}

void PostBlocks::feed_for(double seconds) {
    straight_feed();
    block_ += post_.separator + post_.word(NcWord::feed);
    append_significant(block_, 60 / seconds, inverse_digits, post_);
    feed_.reset();
    end_block();
}

} // namespace facetmill
