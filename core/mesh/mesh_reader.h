// What the readers of mesh files share: the triangles as the file gave them, and the scanning of text.
// Internal to the room; the public door is mesh_io.h.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_reading.h"
#include "core/mesh/mesh_report.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill::detail {

/// Triangles in the file's own numbers, before welding. Every coordinate has been checked to be finite and in
/// range. One of three forms: records of a binary STL file left where they are (`records`), three points a
/// facet in file order (`pieces`), or points with facets of indices into them.
struct TriangleSoup {
    std::string format; ///< as MeshReport::format
    std::string name;
    std::set<std::string> warnings;
    bool single_precision = false; ///< coordinates are 32-bit floats, or text printed from them
    bool end_missing = false;      ///< the file may have been cut: only a mesh without open edges is believed
    std::optional<LengthUnit> unit; ///< that the file states
    bool is_relief = false;         ///< as MeshReport::is_relief
    std::vector<MeshObject> objects;
    std::optional<SurfaceReport> surfaces;

    const char* records = nullptr; ///< first record of a binary STL file
    std::size_t record_count = 0;
    bool big_endian = false;
    std::vector<std::uint64_t> record_offsets; ///< from `records`; empty: one every 50 bytes

    std::vector<std::vector<Vec3>> pieces;

    std::vector<Vec3> points;
    std::vector<Facet> facets;
    bool indexed = false;
    std::vector<Index> faces; ///< of each facet the number of its face in the file; empty: there are none

    std::size_t facet_count() const {
        if (records) return record_count;
        if (indexed) return facets.size();
        std::size_t count = 0;
        for (const std::vector<Vec3>& piece : pieces)
            count += piece.size() / 3;
        return count;
    }
};

/// Corner of a soup in pieces by its number; quick for any order.
class PieceCorners {
public:
    explicit PieceCorners(const std::vector<std::vector<Vec3>>& pieces) : pieces_(pieces) {
        begins_.push_back(0);
        for (const std::vector<Vec3>& piece : pieces)
            begins_.push_back(begins_.back() + piece.size());
        // One guess for every stretch of about half a piece: the search then takes a step or two.
        stretch_ = begins_.back() / (2 * pieces.size() + 1) + 1;
        for (std::size_t corner = 0, piece = 0; corner < begins_.back(); corner += stretch_) {
            while (corner >= begins_[piece + 1])
                ++piece;
            guess_.push_back(piece);
        }
    }
    const Vec3& operator()(std::size_t corner) const {
        std::size_t piece = guess_[corner / stretch_];
        while (corner >= begins_[piece + 1])
            ++piece;
        return pieces_[piece][corner - begins_[piece]];
    }

private:
    const std::vector<std::vector<Vec3>>& pieces_;
    std::vector<std::size_t> begins_, guess_;
    std::size_t stretch_ = 1;
};

/// A file being read: its bytes, what to call it in messages, the largest coordinate allowed in its own
/// numbers (where it states no unit), and what the job says of it.
struct MeshSource {
    std::string_view bytes;
    std::string name;
    double coordinate_limit;
    const MeshReading& reading;
};

/// Reads an STL text: it starts with "solid". Throws Error as load_mesh says.
TriangleSoup read_ascii_stl(const MeshSource& source, const Progress& progress);

/// The text, after a byte order mark and white space, starts with the word "solid" (any case).
bool starts_with_solid(std::string_view bytes);
/// UTF-16 or UTF-32, by byte order mark or by zeros between the first letters.
bool is_wide_text(std::string_view bytes);
/// Few control characters: a text in any 8-bit encoding.
bool is_text(std::string_view bytes);
/// "a PNG picture", "a ZIP archive", ... for the well-known first bytes of what is no mesh that can be read,
/// else empty: for messages.
std::string_view foreign_content(std::string_view bytes);
/// The same, or "an OBJ file" and the like for the content of a mesh format other than the one named `but`.
std::string_view content_of(std::string_view bytes, std::string_view but);

/// Extension of a file's name in small letters, with the dot; empty where there is none.
std::string lower_extension(const std::string& name);

/// How a stored facet normal relates to the winding of its facet.
enum class NormalState { agrees, opposes, zero, unusable, oblique };
/// Compares them. The stored normal counts only where the facet is fat enough for its winding normal to mean
/// something; `oblique` is everything between `agrees` (within 45 degrees, or not to be judged) and `opposes`
/// (more than 90 degrees away).
NormalState compare_normal(const Vec3& stored, const Vec3& a, const Vec3& b, const Vec3& c);

/// Adds the triangles of a polygon (at least three corners; indices into `points`): a fan from the first
/// corner if that does not fold, else by cutting ears. Returns false where both fold (the polygon crosses
/// itself); the fan is added then.
bool triangulate_polygon(const std::vector<Vec3>& points, const Index* corners, std::size_t count,
                         std::vector<Facet>& facets);

// Text
// --------------------------------------------------------------------------------------------------------------

inline bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
inline bool is_space(char c) {
    return is_blank(c) || is_line_end(c);
}

/// Line that holds byte `offset`, from 1; LF, CR LF and CR end a line.
std::size_t line_number(std::string_view text, std::size_t offset);
/// "part.stl, line 12"
std::string at_line(const MeshSource& source, std::size_t offset);
/// Equal to a lower-case word, ignoring the case of ASCII letters.
bool same_word(std::string_view token, std::string_view lower_case_word);
/// Length of the UTF-8 byte order mark at the start, 0 or 3.
std::size_t byte_order_mark(std::string_view text);

enum class NumberForm {
    number,
    non_finite, ///< nan, inf, 1.#QNAN, nan(ind) and the like
    overflow,   ///< beyond the range of double
    comma,      ///< a number with a decimal comma, while points are expected
    point,      ///< a number with a decimal point, while commas are expected
    invalid,
};

/// What readers of text have in common: the source, and errors that name the line.
class TextReader {
protected:
    explicit TextReader(const MeshSource& source) : source_(source) {}

    [[noreturn]] void fail(ErrorCode code, std::size_t offset, const std::string& what,
                           const std::string& remedy = "the file is damaged: export it again") const {
        throw Error(code, at_line(source_, offset), what, remedy);
    }
    [[noreturn]] void fail_truncated(const std::string& where, const std::string& what) const {
        throw Error(ErrorCode::truncated, source_.name + ", " + where, what,
                    "the file was cut: copy or export it again");
    }
    /// Offset of a token that lies in the source.
    std::size_t start_of(std::string_view token) const {
        return std::size_t(token.data() - source_.bytes.data());
    }

    const MeshSource& source_;
};

/// Reads a whole token: sign, digits with at most one decimal mark, exponent with e, E, d or D. Underflow
/// gives 0, negative zero gives 0.
NumberForm read_number(std::string_view token, double& value, char decimal_mark = '.');

/// The next token between white space within one line or over lines; empty at the end.
struct TextCursor {
    std::string_view text;
    std::size_t position = 0;

    std::string_view token() {
        while (position < text.size() && is_space(text[position]))
            ++position;
        return rest_of_token();
    }
    /// Empty at the end of the line, which is not passed.
    std::string_view token_in_line() {
        while (position < text.size() && is_blank(text[position]))
            ++position;
        return rest_of_token();
    }
    void skip_line_end() {
        if (position < text.size() && text[position] == '\r') {
            ++position;
            if (position < text.size() && text[position] == '\n') ++position;
        } else if (position < text.size() && text[position] == '\n') {
            ++position;
        }
    }
    void to_line_end() {
        while (position < text.size() && !is_line_end(text[position]))
            ++position;
    }
    bool at_end() const { return position >= text.size(); }

private:
    std::string_view rest_of_token() {
        const std::size_t begin = position;
        while (position < text.size() && !is_space(text[position]))
            ++position;
        return text.substr(begin, position - begin);
    }
};

} // namespace facetmill::detail
