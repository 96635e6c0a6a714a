// Wavefront OBJ: v and f in all index forms; everything else that the format knows is passed over.
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"

#include "core/base/error.h"
#include "core/base/units.h"

#include <charconv>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr std::string_view silent_words[] = {
    "vt",        "vn",     "vp",     "o",      "g",        "s",        "mg",   "usemtl",
    "mtllib",    "usemap", "maplib", "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj",
    "trace_obj", "ctech",  "stech",  "cstype", "deg",      "bmat",     "step", "parm",
    "trim",      "hole",   "scrv",   "sp",     "end",      "con",
};

/// How an index was written is settled when all vertices are known: a file may name vertices that come later.
struct LatestReference {
    long long vertex = 0; ///< from 1
    std::size_t offset = 0;
};

class ObjParser : TextReader {
public:
    explicit ObjParser(const MeshSource& source) : TextReader(source), cursor_{source.bytes} {
        cursor_.position = byte_order_mark(source.bytes);
        soup_.format = "OBJ";
        soup_.indexed = true;
    }

    TriangleSoup run(const Progress& progress) {
        const double size = double(source_.bytes.size());
        for (std::size_t lines = 0; !cursor_.at_end(); ++lines) {
            if ((lines & 0xFFF) == 0) progress.set(0.8 * double(cursor_.position) / size);
            line();
            cursor_.skip_line_end();
        }
        if (latest_.vertex > (long long)(soup_.points.size()))
            fail(ErrorCode::syntax, latest_.offset,
                 "the facet names vertex " + std::to_string(latest_.vertex) + ", the file has "
                     + std::to_string(soup_.points.size()));
        if (sizes_.empty())
            throw Error(ErrorCode::no_facets, source_.name, "the file holds no facet",
                        "export the part as triangles");
        if (!is_line_end(source_.bytes.back())) soup_.warnings.insert("unterminated_line");
        triangulate(progress.part(0.8, 1.0));
        return std::move(soup_);
    }

private:
    /// The next token of the statement; a backslash at the end of a line continues it.
    std::string_view next() {
        for (;;) {
            std::string_view token = cursor_.token_in_line();
            if (token.empty() || token.back() != '\\') return token;
            if (!cursor_.at_end() && !is_line_end(source_.bytes[cursor_.position])) return token;
            cursor_.skip_line_end();
            token.remove_suffix(1);
            if (!token.empty()) return token;
            if (cursor_.at_end()) return {};
        }
    }
    void skip_statement() {
        while (!next().empty()) {
        }
    }

    void line() {
        const std::string_view word = next();
        if (word.empty()) return;
        if (word.front() == '#') {
            cursor_.to_line_end();
        } else if (word == "v") {
            vertex(start_of(word));
        } else if (word == "f" || word == "fo") {
            facet(start_of(word));
        } else if (word == "p" || word == "l") {
            soup_.warnings.insert("lines_ignored");
            skip_statement();
        } else if (word == "curv" || word == "curv2" || word == "surf") {
            soup_.warnings.insert("free_form_ignored");
            skip_statement();
        } else if (std::find(std::begin(silent_words), std::end(silent_words), word)
                   != std::end(silent_words)) {
            if (word == "o" && soup_.name.empty()) name();
            skip_statement();
        } else {
            soup_.warnings.insert("unknown_lines");
            skip_statement();
        }
    }

    void name() {
        const std::size_t begin = cursor_.position;
        cursor_.to_line_end();
        std::string_view text = source_.bytes.substr(begin, cursor_.position - begin);
        while (!text.empty() && is_blank(text.front()))
            text.remove_prefix(1);
        while (!text.empty() && is_blank(text.back()))
            text.remove_suffix(1);
        soup_.name = printable(text, 200);
    }

    double number(std::string_view token) {
        double value = 0;
        switch (read_number(token, value)) {
        case NumberForm::number:
            return value;
        case NumberForm::non_finite:
            fail(ErrorCode::non_finite, start_of(token),
                 "'" + printable(token, 40) + "' is not a finite number");
        case NumberForm::overflow:
            fail(ErrorCode::coordinate_range, start_of(token),
                 "the number " + printable(token, 40) + " is too large",
                 "the file is damaged or in another unit");
        case NumberForm::comma:
            fail(ErrorCode::syntax, start_of(token), "'" + printable(token, 40) + "' has a comma",
                 "export the part with decimal points");
        default:
            break;
        }
        fail(ErrorCode::syntax, start_of(token), "a number expected, found '" + printable(token, 40) + "'");
    }

    /// x y z, then nothing, a weight, or a colour of three, or both.
    void vertex(std::size_t offset) {
        double values[7];
        std::size_t count = 0;
        for (std::string_view token = next(); !token.empty(); token = next()) {
            if (token.front() == '#') {
                cursor_.to_line_end();
                break;
            }
            if (count == 7) fail(ErrorCode::syntax, start_of(token), "a vertex has more than 7 numbers");
            values[count++] = number(token);
        }
        if (count < 3) fail_short(offset, "a vertex has fewer than 3 numbers");
        if (count == 5) fail(ErrorCode::syntax, offset, "a vertex has 5 numbers");
        if ((count == 4 || count == 7) && values[3] != 1.0) soup_.warnings.insert("weights_ignored");
        const Vec3 point(values[0], values[1], values[2]);
        if (point.cwiseAbs().maxCoeff() > source_.coordinate_limit)
            fail(ErrorCode::coordinate_range, offset,
                 "a coordinate is beyond " + format_number(source_.coordinate_limit),
                 "the file is damaged or in another unit");
        soup_.points.push_back(point);
        if (soup_.points.size() >= no_index)
            throw Error(ErrorCode::too_large, source_.name,
                        "the file has more than 4 thousand million vertices",
                        "export the part with a coarser tolerance");
    }

    /// A statement without its last words at the end of the file was cut.
    [[noreturn]] void fail_short(std::size_t offset, const std::string& what) const {
        if (cursor_.at_end())
            fail(ErrorCode::truncated, offset, what + " and the file ends there",
                 "the file was cut: copy or export it again");
        fail(ErrorCode::syntax, offset, what);
    }

    void facet(std::size_t offset) {
        std::size_t count = 0;
        for (std::string_view token = next(); !token.empty(); token = next()) {
            if (token.front() == '#') {
                cursor_.to_line_end();
                break;
            }
            corners_.push_back(corner(token));
            ++count;
        }
        if (count < 3) fail_short(offset, "a facet has fewer than 3 corners");
        sizes_.push_back(Index(count));
    }

    /// v, v/vt, v//vn or v/vt/vn, each from 1 or counted back from the latest by a negative number.
    Index corner(std::string_view token) {
        const auto bad = [&] {
            if (cursor_.at_end())
                fail(ErrorCode::truncated, start_of(token), "the file ends inside a facet",
                     "the file was cut: copy or export it again");
            fail(ErrorCode::syntax, start_of(token),
                 "a vertex number expected, found '" + printable(token, 40) + "'");
        };
        const char* at = token.data();
        const char* const end = at + token.size();
        long long vertex = 0;
        for (int part = 0; part < 3; ++part) {
            long long value = 0;
            const auto r = std::from_chars(at, end, value);
            const bool empty = r.ptr == at;
            if (r.ec == std::errc::result_out_of_range || (empty && (part != 1 || at == end || *at != '/'))
                || (!empty && value == 0))
                bad();
            if (part == 0) vertex = value;
            at = r.ptr;
            if (at == end) break;
            if (*at != '/' || part == 2) bad();
            ++at;
        }
        const auto known = (long long)(soup_.points.size());
        if (vertex < 0) vertex += known + 1;
        if (vertex < 1 || vertex >= (long long)(no_index))
            fail(ErrorCode::syntax, start_of(token),
                 "the facet names vertex " + printable(token, 40) + ", " + std::to_string(known)
                     + " are known so far");
        if (vertex > latest_.vertex) latest_ = {vertex, start_of(token)};
        return Index(vertex - 1);
    }

    void triangulate(const Progress& progress) {
        soup_.facets.reserve(corners_.size() - 2 * sizes_.size());
        std::size_t begin = 0;
        for (std::size_t i = 0; i < sizes_.size(); ++i) {
            if ((i & 0xFFF) == 0) progress.set(double(i) / double(sizes_.size()));
            if (sizes_[i] > 3) soup_.warnings.insert("polygons_triangulated");
            if (!triangulate_polygon(soup_.points, &corners_[begin], sizes_[i], soup_.facets))
                soup_.warnings.insert("polygons_folded");
            begin += sizes_[i];
        }
    }

    TextCursor cursor_;
    TriangleSoup soup_;
    std::vector<Index> corners_, sizes_; ///< of all polygons, one behind the other
    LatestReference latest_;
};

TriangleSoup read_obj(const MeshSource& source, const Progress& progress) {
    if (is_wide_text(source.bytes))
        throw Error(ErrorCode::encoding, source.name, "the text is UTF-16 or UTF-32",
                    "save it as ASCII or UTF-8 (PowerShell: Out-File -Encoding ascii)");
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorCode::syntax, source.name, "is not an OBJ file" + why,
                    "open the mesh itself, under a name that ends as its format does");
    };
    const auto what = content_of(source.bytes, "OBJ");
    // These two are short enough for a text to begin so by chance.
    if (!what.empty() && what != "an OFF file" && what != "a BMP picture")
        refuse(" but " + std::string(what));
    if (!is_text(source.bytes)) refuse(": it is no text");
    return ObjParser(source).run(progress);
}

/// A text that names vertices in its first lines.
bool sniff_obj(std::string_view bytes) {
    const std::string_view text = bytes.substr(std::min(byte_order_mark(bytes), bytes.size()));
    if (!foreign_content(bytes).empty() || !is_text(text)) return false;
    TextCursor cursor{text};
    for (int line = 0; line < 20 && !cursor.at_end(); ++line) {
        const std::string_view word = cursor.token();
        if (word == "v" || word == "mtllib" || word == "vn") return true;
        cursor.to_line_end();
    }
    return false;
}

} // namespace

MeshFormat obj_format() {
    return {"OBJ", "an OBJ file", {".obj"}, sniff_obj, read_obj};
}

} // namespace facetmill::detail
