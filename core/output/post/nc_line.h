// One line of a control's program as codes and words. Internal to the room.
#pragma once

#include "core/output/post/post.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace facetmill {

struct NcLine {
    std::vector<NcCode> codes;
    std::string_view wcs; ///< of a code that chooses one; the post's own text
    std::array<double, nc_words> value{};
    unsigned given = 0; ///< a bit for each word
    /// A tilted plane begins: turned about Z, then about the new X; degrees.
    std::optional<std::array<double, 2>> plane;
    bool plane_off = false;
    bool read_over = false; ///< it has a word that is, and is no number of the block
    /// One of the lines that choose work coordinates by their number; -1: none of them.
    int wcs_line = -1;
    std::optional<long> wcs_number;
    bool has(NcWord w) const { return given >> unsigned(w) & 1u; }
    double operator[](NcWord w) const { return value[std::size_t(w)]; }
    bool has_code(NcCode c) const;
    bool has_axis() const { return (given & axis_bits) != 0; }
    static constexpr unsigned axis_bits = (1u << (unsigned(NcWord::c) + 1)) - 1; ///< X to C
};

class NcLineReader {
public:
    explicit NcLineReader(const Post& post);
    /// Reads a line without its end. Throws Error(syntax) whose place is `where`, for whatever the control's
    /// file does not know.
    void read(std::string_view line, NcLine& into, const std::string& file, long number) const;

private:
    struct Meaning {
        NcCode code = NcCode::none;
        const std::string* text = nullptr;
    };
    struct Cursor {
        std::string_view line;
        std::size_t at = 0;
        const std::string& file;
        long number;
    };
    [[noreturn]] static void fail(const Cursor& c, const std::string& what, const std::string& remedy);
    std::string_view behind_number(std::string_view line) const;
    bool whole_line(std::string_view text, NcLine& into) const;
    bool plane_line(std::string_view text, NcLine& into) const;
    bool wcs_line(std::string_view text, NcLine& into) const;
    void token(Cursor& c, NcLine& into) const;
    /// A comment that tells the tool, where the control has no word for it: "tool 3 ...".
    void comment(std::string_view text, NcLine& into) const;
    void named(Cursor& c, std::size_t letters, NcLine& into) const;
    static double number(Cursor& c);
    void code(const Cursor& c, std::size_t from, const Meaning& meaning, NcLine& into) const;
    void word(const Cursor& c, std::size_t from, NcWord which, double value, NcLine& into) const;
    /// A control that counts the last digits of numbers without a point would go a thousandth of the way.
    void check_point(const Cursor& c, std::size_t from, NcWord which, double value) const;

    bool parentheses_, semicolons_, bare_numbers_, tool_in_comments_, needs_point_;
    std::array<bool, 26> code_letter_{};
    std::array<int, 26> word_letter_{};              ///< NcWord, -1: none
    std::unordered_map<long, Meaning> numbered_;     ///< letter * 1e6 + ten times the number
    std::unordered_map<std::string, Meaning> named_; ///< "TRAORI"
    std::unordered_map<std::string, NcWord> long_words_;
    std::string block_letter_;
    /// The line that begins a tilted plane: what stands before, between and behind its angles; and whether
    /// the turn about Z comes first. Lines that end it.
    std::array<std::string, 3> plane_on_;
    bool z_first_ = true;
    std::vector<std::string> plane_off_;
    /// The lines that choose work coordinates: what stands before the number and behind it.
    struct WcsLine {
        std::string before, behind;
        bool tells = false;
    };
    std::vector<WcsLine> wcs_lines_;
};

} // namespace facetmill
