// ASCII STL. The grammar is by tokens, whatever the line ends: whole files on one line and one token a line
// both occur. Only names (behind solid and endsolid) and unknown statements between facets run to the end of
// their line, or to a facet that certainly starts before that. Inside a facet nothing is guessed.
#include "core/base/parallel.h"
#include "core/mesh/mesh_reader.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"

#include <array>
#include <cctype>
#include <optional>

namespace facetmill::detail {

namespace {

/// Thrown when a number has a decimal comma while points are expected (the file is then read once more), or a
/// decimal point in that second reading.
struct CommaFound {
    std::size_t offset;
};
struct PointFound {};

struct AsciiFindings {
    std::vector<Vec3> points; ///< three a facet
    std::string name;
    std::size_t solids = 0; ///< opened in this piece
    bool empty_solid = false, unknown_lines = false, trailing_data = false;
    bool missing_endsolid = false; ///< before another solid
    bool bad_normals = false, normals_disagree = false;
    bool open_at_end = false;     ///< no endsolid for the last solid
    bool ends_with_facet = false; ///< the last thing in the piece is a facet that ends where the piece ends
};

class AsciiParser : TextReader {
public:
    /// Reads [begin, end) of the file; a piece that does not begin the file begins behind an "endfacet".
    AsciiParser(const MeshSource& source, std::size_t begin, std::size_t end, char decimal_mark)
        : TextReader(source), cursor_{source.bytes.substr(0, end), begin}, decimal_mark_(decimal_mark),
          in_solid_(begin > 0), solid_is_empty_(begin == 0) {
        if (begin == 0) cursor_.position = byte_order_mark(source.bytes);
    }

    AsciiFindings run(const Progress& progress) {
        const std::size_t begin = cursor_.position;
        for (std::size_t steps = 0;; ++steps) {
            if ((steps & 0xFFF) == 0)
                progress.set(double(cursor_.position - begin) / double(cursor_.text.size() - begin + 1));
            const std::size_t before = cursor_.position;
            const std::string_view token = cursor_.token();
            if (token.empty()) {
                cursor_.position = before;
                break;
            }
            if (in_solid_)
                statement_in_solid(token);
            else
                statement_outside(token);
        }
        if (junk_) found_.trailing_data = true;
        found_.open_at_end = in_solid_;
        found_.empty_solid = found_.empty_solid || (in_solid_ && solid_is_empty_);
        return std::move(found_);
    }

private:
    static constexpr std::array<std::string_view, 6> inner_words = {"normal", "outer",   "loop",
                                                                    "vertex", "endloop", "endfacet"};

    [[noreturn]] void fail_token(std::string_view token, const std::string& expected) const {
        if (token.empty() || token.data() + token.size() == source_.bytes.data() + source_.bytes.size())
            fail(ErrorCode::truncated, source_.bytes.size(), "the file ends inside a facet",
                 "the file was cut: copy or export it again");
        fail(ErrorCode::syntax, start_of(token),
             expected + " expected, found '" + printable(token, 40) + "'");
    }

    void statement_in_solid(std::string_view token) {
        found_.ends_with_facet = false;
        if (same_word(token, "facet")) {
            facet();
            solid_is_empty_ = false;
            found_.ends_with_facet = true;
        } else if (same_word(token, "endsolid") || ends_in_two_words(token)) {
            in_solid_ = false;
            found_.empty_solid = found_.empty_solid || solid_is_empty_;
            skip_end_name();
        } else if (same_word(token, "solid")) {
            found_.missing_endsolid = true;
            found_.empty_solid = found_.empty_solid || solid_is_empty_;
            open_solid();
        } else {
            for (const std::string_view word : inner_words)
                if (same_word(token, word)) fail_token(token, "facet or endsolid");
            if (cursor_.at_end() && cursor_.text.size() == source_.bytes.size()) {
                // An unfinished last word: part of the end, or of a facet that is lost?
                if (same_word(token, std::string_view("endsolid").substr(0, token.size()))) return;
                if (same_word(token, std::string_view("facet").substr(0, token.size())))
                    fail(ErrorCode::truncated, source_.bytes.size(), "the file ends inside the word facet",
                         "the file was cut: copy or export it again");
            }
            found_.unknown_lines = true;
            skip_line(cursor_);
        }
    }

    /// "end solid", as some writers have it; the second word is passed.
    bool ends_in_two_words(std::string_view token) {
        if (!same_word(token, "end")) return false;
        const std::size_t before = cursor_.position;
        if (same_word(cursor_.token_in_line(), "solid")) return true;
        cursor_.position = before;
        return false;
    }

    /// Behind an endsolid: another solid, or bytes that belong to nothing.
    void statement_outside(std::string_view token) {
        token.remove_prefix(byte_order_mark(token)); // of a file that was put behind another
        if (same_word(token, "solid") && (!junk_ || solid_follows())) {
            found_.unknown_lines = found_.unknown_lines || junk_;
            junk_ = false;
            open_solid();
            return;
        }
        if (found_.solids == 0) fail(ErrorCode::syntax, start_of(token), "'solid' expected");
        if (facet_starts(token, cursor_))
            fail(ErrorCode::syntax, start_of(token), "a facet stands outside of a solid");
        junk_ = true;
        if (skip_line(cursor_))
            fail(ErrorCode::syntax, cursor_.position, "a facet stands outside of a solid");
    }

    /// In junk: is the "solid" just read more than a word?
    bool solid_follows() const {
        TextCursor ahead = cursor_;
        skip_line(ahead);
        const std::string_view token = ahead.token();
        return same_word(token, "facet") || same_word(token, "endsolid");
    }

    void open_solid() {
        ++found_.solids;
        in_solid_ = true;
        solid_is_empty_ = true;
        const std::size_t begin = cursor_.position;
        skip_line(cursor_);
        if (found_.solids > 1) return;
        std::string_view name = source_.bytes.substr(begin, cursor_.position - begin);
        while (!name.empty() && is_space(name.front()))
            name.remove_prefix(1);
        while (!name.empty() && is_space(name.back()))
            name.remove_suffix(1);
        found_.name = printable(name, 200);
    }

    /// To the end of the line, or to a facet that starts in it (true): files on one line.
    bool skip_line(TextCursor& cursor) const {
        for (;;) {
            const std::string_view token = cursor.token_in_line();
            if (token.empty()) return false;
            if (facet_starts(token, cursor)) {
                cursor.position = start_of(token);
                return true;
            }
        }
    }

    /// The name behind endsolid; it ends where the solid begins that a facet in the same line belongs to.
    void skip_end_name() {
        const std::size_t begin = cursor_.position;
        if (!skip_line(cursor_)) return;
        const std::size_t facet_begin = cursor_.position;
        std::optional<std::size_t> last_solid;
        cursor_.position = begin;
        while (cursor_.position < facet_begin)
            if (const auto token = cursor_.token_in_line(); same_word(token, "solid"))
                last_solid = start_of(token);
        if (!last_solid) fail(ErrorCode::syntax, facet_begin, "a facet stands outside of a solid");
        cursor_.position = *last_solid;
    }

    /// The token is "facet" and what follows it is certainly one: it goes on to a second vertex. (A name may
    /// hold any of the words.)
    static bool facet_starts(std::string_view token, TextCursor ahead) {
        if (!same_word(token, "facet")) return false;
        const auto number = [&](std::string_view t) {
            double ignored = 0;
            return read_number(t, ignored, '.') != NumberForm::invalid;
        };
        std::string_view t = ahead.token();
        if (same_word(t, "normal")) {
            t = ahead.token();
            for (int i = 0; i < 3 && !same_word(t, "outer"); ++i) {
                if (!number(t)) return false;
                t = ahead.token();
            }
        }
        if (!same_word(t, "outer") || !same_word(ahead.token(), "loop")
            || !same_word(ahead.token(), "vertex"))
            return false;
        for (int i = 0; i < 3; ++i)
            if (!number(ahead.token())) return false;
        return same_word(ahead.token(), "vertex");
    }

    void expect(std::string_view word) {
        const std::string_view token = cursor_.token();
        if (!same_word(token, word)) fail_token(token, std::string(word));
    }

    void facet() {
        const std::size_t begin = cursor_.position;
        std::string_view token = cursor_.token();
        Vec3 normal = Vec3::Zero();
        bool usable = false;
        if (same_word(token, "normal")) {
            token = cursor_.token();
            if (!same_word(token, "outer")) {
                usable = true;
                for (int i = 0; i < 3; ++i) {
                    const NumberForm form = read(token, normal[i]);
                    if (form == NumberForm::invalid) fail_token(token, "a number or outer loop");
                    usable = usable && form == NumberForm::number;
                    token = cursor_.token();
                }
            }
        }
        if (!same_word(token, "outer")) fail_token(token, "outer loop");
        expect("loop");
        Vec3 corners[3];
        for (Vec3& corner : corners) {
            expect("vertex");
            for (int i = 0; i < 3; ++i)
                coordinate(corner[i]);
        }
        token = cursor_.token();
        if (same_word(token, "vertex"))
            fail(ErrorCode::not_triangles, start_of(token), "the facet has more than three corners",
                 "export the part as triangles");
        if (!same_word(token, "endloop")) fail_token(token, "endloop");
        expect("endfacet");

        const NormalState state =
            usable ? compare_normal(normal, corners[0], corners[1], corners[2]) : NormalState::unusable;
        found_.bad_normals = found_.bad_normals || state == NormalState::unusable;
        found_.normals_disagree = found_.normals_disagree || state == NormalState::opposes;
        if (found_.points.empty()) { // all facets of a writer are about as long as the first
            const std::size_t left = cursor_.text.size() - begin, length = cursor_.position - begin + 1;
            found_.points.reserve(3 * (left / length + left / (8 * length) + 1));
        }
        found_.points.insert(found_.points.end(), corners, corners + 3);
    }

    NumberForm read(std::string_view token, double& value) const {
        const NumberForm form = read_number(token, value, decimal_mark_);
        if (form == NumberForm::comma) throw CommaFound{start_of(token)};
        if (form == NumberForm::point) throw PointFound{};
        return form;
    }

    void coordinate(double& value) {
        const std::string_view token = cursor_.token();
        switch (read(token, value)) {
        case NumberForm::number:
            break;
        case NumberForm::non_finite:
            fail(ErrorCode::non_finite, start_of(token),
                 "'" + printable(token, 40) + "' is not a finite number");
        case NumberForm::overflow:
            fail_range(token);
        default:
            fail_token(token, "a number");
        }
        if (std::abs(value) > source_.coordinate_limit) fail_range(token);
    }
    [[noreturn]] void fail_range(std::string_view token) const {
        fail(ErrorCode::coordinate_range, start_of(token),
             "the coordinate " + printable(token, 40) + " is beyond "
                 + format_number(source_.coordinate_limit),
             "the file is damaged or in another unit");
    }

    TextCursor cursor_;
    char decimal_mark_;
    bool in_solid_, solid_is_empty_;
    bool junk_ = false;
    AsciiFindings found_;
};

/// Ends of pieces of about `size` bytes, each behind an "endfacet" and a white space.
std::vector<std::size_t> piece_ends(std::string_view text, std::size_t size) {
    static constexpr std::string_view word = "endfacet";
    std::vector<std::size_t> ends;
    for (std::size_t at = size; at + size / 2 < text.size(); at += size) {
        // The letter 'f' is rare in a file of numbers.
        std::size_t f = at;
        for (; f + 6 < text.size(); ++f)
            if ((text[f] == 'f' || text[f] == 'F') && same_word(text.substr(f - 3, word.size()), word)
                && is_space(text[f + 5]))
                break;
        if (f + 6 >= text.size()) break;
        at = f + 5;
        ends.push_back(at);
    }
    ends.push_back(text.size());
    return ends;
}

/// Pieces side by side. Nothing is believed unless every piece ends with a facet exactly where the next one
/// begins: any doubt (also an error, also a name that looks like a facet) is left to the reading in one
/// piece.
std::optional<AsciiFindings> read_in_pieces(const MeshSource& source, std::vector<std::vector<Vec3>>& points,
                                            const Progress& progress) {
    constexpr std::size_t piece_size = std::size_t(1) << 20;
    const std::vector<std::size_t> ends = piece_ends(source.bytes, piece_size);
    if (ends.size() == 1) return std::nullopt;
    std::vector<AsciiFindings> pieces(ends.size());
    std::atomic<bool> doubtful{false};
    parallel_blocks(ends.size(), 1, progress, [&](std::size_t i, std::size_t) {
        if (doubtful) return;
        try {
            pieces[i] = AsciiParser(source, i == 0 ? 0 : ends[i - 1], ends[i], '.').run(Progress());
        } catch (const Error&) {
            doubtful = true;
        } catch (const CommaFound&) {
            doubtful = true;
        }
        if (i + 1 < ends.size() && !pieces[i].ends_with_facet) doubtful = true;
    });
    if (doubtful) return std::nullopt;

    AsciiFindings all = std::move(pieces[0]);
    all.open_at_end = pieces.back().open_at_end;
    points.push_back(std::move(all.points));
    for (std::size_t i = 1; i < pieces.size(); ++i)
        points.push_back(std::move(pieces[i].points));
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const AsciiFindings& p = pieces[i];
        all.solids += p.solids;
        all.empty_solid |= p.empty_solid;
        all.unknown_lines |= p.unknown_lines;
        all.bad_normals |= p.bad_normals;
        all.normals_disagree |= p.normals_disagree;
        all.trailing_data |= p.trailing_data;
        all.missing_endsolid |= p.missing_endsolid;
    }
    return all;
}

} // namespace

TriangleSoup read_ascii_stl(const MeshSource& source, const Progress& progress) {
    TriangleSoup soup;
    AsciiFindings found;
    bool comma = false;
    if (auto pieces = read_in_pieces(source, soup.pieces, progress)) {
        found = std::move(*pieces);
    } else {
        try {
            found = AsciiParser(source, 0, source.bytes.size(), '.').run(progress);
        } catch (const CommaFound& first) {
            comma = true;
            try {
                found = AsciiParser(source, 0, source.bytes.size(), ',').run(progress);
            } catch (const PointFound&) {
                throw Error(ErrorCode::syntax, at_line(source, first.offset),
                            "a number has a comma where other numbers have a decimal point",
                            "thousands or decimals? export the part again with decimal points");
            }
        }
    }
    if (soup.pieces.empty()) soup.pieces.push_back(std::move(found.points));
    if (soup.facet_count() == 0)
        throw Error(ErrorCode::no_facets, source.name, "the file holds no facet", "export the part again");
    soup.format = "STL ASCII";
    soup.name = found.name;
    soup.single_precision = true;
    soup.end_missing = found.missing_endsolid || found.open_at_end;
    const auto warn = [&](bool condition, const char* word) {
        if (condition) soup.warnings.insert(word);
    };
    warn(comma, "comma_decimal");
    warn(found.empty_solid, "empty_solid");
    warn(found.unknown_lines, "unknown_lines");
    warn(found.trailing_data, "trailing_data");
    warn(soup.end_missing, "missing_endsolid");
    warn(found.bad_normals, "bad_normals");
    warn(found.normals_disagree, "normals_disagree");
    warn(found.solids > 1, "multiple_solids");
    return soup;
}

} // namespace facetmill::detail
