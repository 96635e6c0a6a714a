// PLY, ASCII and binary of both byte orders: any elements, properties and number types in any order. The
// element `vertex` must have x, y, z; the element `face`, or `tristrips` where there is none, a list
// `vertex_indices` or `vertex_index`. Everything else is passed over.
#include "core/mesh/mesh_format.h"
#include "core/mesh/ply_header.h"

#include "core/base/error.h"
#include "core/base/units.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace facetmill::detail {

namespace {

/// What the vertices and faces go into while the data is read; the same for both encodings.
struct PlyMesh {
    std::vector<Vec3> points;
    std::vector<Index> corners, sizes;
    bool lines = false;
};

class PlyReader : TextReader {
public:
    explicit PlyReader(const MeshSource& source)
        : TextReader(source), header_(read_ply_header(source)),
          encoding_(header_.encoding), cursor_{source.bytes, header_.end} {
        soup_.format = encoding_ == PlyEncoding::ascii ? "PLY ASCII" : "PLY binary";
        soup_.indexed = true;
    }

    TriangleSoup run(const Progress& progress) {
        const PlyElement* vertex = header_.find("vertex");
        const PlyElement* face = header_.find("face");
        if (!face) face = header_.find("tristrips");
        if (!vertex || !face) {
            throw Error(ErrorCode::no_facets, source_.name,
                        vertex ? "the file holds points but no face" : "the file holds no vertices",
                        "export the part as triangles");
        }
        for (const PlyElement& element : header_.elements)
            check_count(element);
        if (face->count == 0)
            throw Error(ErrorCode::no_facets, source_.name, "the file holds no face",
                        "export the part as triangles");
        facets_ = face;
        for (std::size_t i = 0; i < header_.elements.size(); ++i) {
            const double n = double(header_.elements.size());
            read_element(header_.elements[i], progress.part(0.9 * double(i) / n, 0.9 * double(i + 1) / n));
        }
        if (encoding_ == PlyEncoding::ascii) {
            if (!is_line_end(source_.bytes.back())) soup_.warnings.insert("unterminated_line");
            if (!cursor_.token().empty()) {
                soup_.warnings.erase("unterminated_line");
                soup_.warnings.insert("trailing_data");
            }
        } else if (cursor_.position < source_.bytes.size()) {
            soup_.warnings.insert("trailing_data");
        }
        finish(progress.part(0.9, 1.0));
        return std::move(soup_);
    }

private:
    /// A count that the file cannot hold is refused before anything is allocated for it.
    void check_count(const PlyElement& element) const {
        const std::uint64_t left =
            source_.bytes.size() - cursor_.position + 1; // the last number may end the file
        const std::size_t each = element.min_size(encoding_ == PlyEncoding::ascii);
        if (each > 0 && element.count > left / each)
            fail(ErrorCode::truncated, element.offset,
                 "the header announces " + std::to_string(element.count) + " of '"
                     + printable(element.name, 40) + "', more than the file has bytes for",
                 "the file was cut: copy or export it again");
        if (element.count >= no_index && each > 0)
            throw Error(ErrorCode::too_large, source_.name,
                        "the file has more than 4 thousand million elements",
                        "export the part with a coarser tolerance");
    }

    /// "vertex 12": what is being read, for messages.
    std::string place(const PlyElement& element, std::uint64_t i) const {
        return printable(element.name, 40) + " " + std::to_string(i + 1);
    }
    [[noreturn]] void fail_at(ErrorCode code, const PlyElement& element, std::uint64_t i,
                              const std::string& what,
                              const std::string& remedy = "the file is damaged: export it again") const {
        if (encoding_ == PlyEncoding::ascii) fail(code, cursor_.position, what, remedy);
        throw Error(code, source_.name + ", " + place(element, i), what, remedy);
    }

    double ascii_value(const PlyElement& element, std::uint64_t i) {
        const std::string_view token = cursor_.token_in_line();
        double value = 0;
        if (token.empty()) {
            if (cursor_.at_end()) fail_truncated(place(element, i), "the file ends here");
            fail(ErrorCode::syntax, cursor_.position,
                 "too few numbers for one '" + printable(element.name, 40) + "'");
        }
        switch (read_number(token, value)) {
        case NumberForm::number:
            return value;
        case NumberForm::non_finite:
            return std::numeric_limits<double>::quiet_NaN();
        case NumberForm::overflow:
            return infinity;
        default:
            break;
        }
        if (token.data() + token.size() == source_.bytes.data() + source_.bytes.size())
            fail_truncated(place(element, i), "the file ends inside a number");
        fail(ErrorCode::syntax, start_of(token), "a number expected, found '" + printable(token, 40) + "'");
    }

    double binary_value(PlyType type, const PlyElement& element, std::uint64_t i) {
        const std::size_t size = type_size(type);
        if (source_.bytes.size() - cursor_.position < size)
            fail_truncated(place(element, i), "the file ends here");
        unsigned char raw[8];
        std::memcpy(raw, source_.bytes.data() + cursor_.position, size);
        cursor_.position += size;
        if (encoding_ == PlyEncoding::big_endian) std::reverse(raw, raw + size);
        std::uint64_t bits = 0;
        for (std::size_t k = size; k-- > 0;)
            bits = bits << 8 | raw[k];
        switch (type) {
        case PlyType::i8:
            return double(std::int8_t(bits));
        case PlyType::u8:
            return double(std::uint8_t(bits));
        case PlyType::i16:
            return double(std::int16_t(bits));
        case PlyType::u16:
            return double(std::uint16_t(bits));
        case PlyType::i32:
            return double(std::int32_t(bits));
        case PlyType::u32:
            return double(std::uint32_t(bits));
        case PlyType::f32:
            return double(std::bit_cast<float>(std::uint32_t(bits))) + 0.0;
        case PlyType::f64:
            return std::bit_cast<double>(bits) + 0.0;
        }
        return 0.0;
    }

    double value(PlyType type, const PlyElement& element, std::uint64_t i) {
        return encoding_ == PlyEncoding::ascii ? ascii_value(element, i) : binary_value(type, element, i);
    }

    /// A whole number in a range, as counts and indices must be.
    std::uint64_t whole_number(PlyType type, const PlyElement& element, std::uint64_t i, double most,
                               const char* what) {
        const double v = value(type, element, i);
        if (!(v >= 0.0 && v <= most && v == std::floor(v)))
            fail_at(ErrorCode::syntax, element, i,
                    std::string(what) + " " + format_number(v) + " is not possible");
        return std::uint64_t(v);
    }

    void read_element(const PlyElement& element, const Progress& progress) {
        const bool is_vertex = element.name == "vertex", is_face = &element == facets_;
        const bool is_strip = is_face && element.name == "tristrips";
        int axis_of[3] = {-1, -1, -1};
        int list_of = -1;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (is_vertex && !property.list)
                for (int axis = 0; axis < 3; ++axis)
                    if (property.name == std::string_view("xyz").substr(std::size_t(axis), 1))
                        axis_of[axis] = int(p);
            if (is_face && property.list
                && (property.name == "vertex_indices" || property.name == "vertex_index"))
                list_of = int(p);
        }
        if (is_vertex && (axis_of[0] < 0 || axis_of[1] < 0 || axis_of[2] < 0))
            fail(ErrorCode::syntax, element.offset, "the vertices have no x, y and z");
        if (is_face && (list_of < 0 || !is_integer(element.properties[std::size_t(list_of)].type)))
            fail(ErrorCode::syntax, element.offset, "the faces have no list vertex_indices of integers");
        if (is_vertex) {
            mesh_.points.reserve(std::size_t(element.count));
            soup_.single_precision = element.properties[std::size_t(axis_of[0])].type == PlyType::f32
                                     && encoding_ != PlyEncoding::ascii;
        }
        if (element.properties.empty()) return; // nothing is stored, however many there are
        if (encoding_ != PlyEncoding::ascii && !is_vertex && !is_face && !element.has_list()) {
            const std::uint64_t bytes =
                element.count * element.min_size(false); // checked before not to overflow
            if (bytes > source_.bytes.size() - cursor_.position)
                fail_truncated(place(element, 0), "the file ends in these elements");
            cursor_.position += std::size_t(bytes);
            return;
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if ((i & 0xFFF) == 0) progress.set(double(i) / double(element.count));
            if (encoding_ == PlyEncoding::ascii) begin_row();
            Vec3 point = Vec3::Zero();
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.list && int(p) == list_of) {
                    is_strip ? read_strip(element, i, property, progress)
                             : read_face(element, i, property, progress);
                } else if (property.list) {
                    skip_list(element, i, property, progress);
                } else {
                    const double v = value(property.type, element, i);
                    for (int axis = 0; axis < 3; ++axis)
                        if (axis_of[axis] == int(p)) point[axis] = v;
                }
            }
            if (encoding_ == PlyEncoding::ascii) end_row(element);
            if (is_vertex) add_point(element, i, point);
        }
    }

    void begin_row() {
        for (;;) {
            while (!cursor_.at_end() && is_blank(source_.bytes[cursor_.position]))
                ++cursor_.position;
            if (cursor_.at_end() || !is_line_end(source_.bytes[cursor_.position])) return;
            cursor_.skip_line_end();
        }
    }
    void end_row(const PlyElement& element) {
        const std::string_view extra = cursor_.token_in_line();
        if (!extra.empty())
            fail(ErrorCode::syntax, start_of(extra),
                 "too many numbers for one '" + printable(element.name, 40) + "'");
        cursor_.skip_line_end();
    }

    void add_point(const PlyElement& element, std::uint64_t i, const Vec3& point) {
        for (int axis = 0; axis < 3; ++axis)
            if (std::isnan(point[axis]) || (std::isinf(point[axis]) && encoding_ != PlyEncoding::ascii))
                fail_at(ErrorCode::non_finite, element, i, "a coordinate is not a finite number");
        if (point.cwiseAbs().maxCoeff() > source_.coordinate_limit)
            fail_at(ErrorCode::coordinate_range, element, i,
                    "a coordinate is beyond " + format_number(source_.coordinate_limit),
                    "the file is damaged or in another unit");
        mesh_.points.push_back(point);
    }

    /// The length of a list, that the rest of the file can hold.
    std::uint64_t list_length(const PlyElement& element, std::uint64_t i, const PlyProperty& property) {
        const std::uint64_t length =
            whole_number(property.count_type, element, i, double(no_index), "the list length");
        const std::size_t each = encoding_ == PlyEncoding::ascii ? 2 : type_size(property.type);
        if (length * each > source_.bytes.size() - cursor_.position)
            fail_truncated(place(element, i), "the file ends inside a list of " + std::to_string(length));
        return length;
    }

    /// Triangles of three vertices in a row, every second one the other way round; -1 begins anew.
    void read_strip(const PlyElement& element, std::uint64_t i, const PlyProperty& property,
                    const Progress& progress) {
        const std::uint64_t length = list_length(element, i, property);
        std::array<Index, 2> before{};
        std::size_t in_strip = 0;
        for (std::uint64_t k = 0; k < length; ++k) {
            if ((k & 0xFFFF) == 0xFFFF) progress.check();
            const double v = value(property.type, element, i);
            if (v == -1) {
                in_strip = 0;
                continue;
            }
            if (!(v >= 0 && v < double(find_vertex_count()) && v == std::floor(v)))
                fail_at(ErrorCode::syntax, element, i,
                        "a strip names vertex " + format_number(v) + ", the file has "
                            + std::to_string(find_vertex_count()) + " (from 0)");
            const Index next = Index(v);
            if (in_strip >= 2 && before[0] != before[1] && next != before[0] && next != before[1]) {
                const bool turned = in_strip % 2 == 1;
                for (const Index corner : {before[turned ? 1 : 0], before[turned ? 0 : 1], next})
                    mesh_.corners.push_back(corner);
                mesh_.sizes.push_back(3);
            }
            before = {before[1], next};
            ++in_strip;
        }
    }

    void read_face(const PlyElement& element, std::uint64_t i, const PlyProperty& property,
                   const Progress& progress) {
        const std::uint64_t length = list_length(element, i, property);
        const std::size_t begin = mesh_.corners.size();
        for (std::uint64_t k = 0; k < length; ++k) {
            if ((k & 0xFFFF) == 0xFFFF) progress.check();
            mesh_.corners.push_back(
                Index(whole_number(property.type, element, i, double(no_index - 1), "the vertex number")));
            if (find_vertex_count() <= mesh_.corners.back())
                fail_at(ErrorCode::syntax, element, i,
                        "the face names vertex " + std::to_string(mesh_.corners.back()) + ", the file has "
                            + std::to_string(find_vertex_count()) + " (from 0)");
        }
        if (length < 3) {
            mesh_.corners.resize(begin);
            mesh_.lines = true;
        } else {
            mesh_.sizes.push_back(Index(length));
        }
    }
    std::uint64_t find_vertex_count() {
        if (!vertex_count_) vertex_count_ = header_.find("vertex")->count;
        return *vertex_count_;
    }

    void skip_list(const PlyElement& element, std::uint64_t i, const PlyProperty& property,
                   const Progress& progress) {
        const std::uint64_t length = list_length(element, i, property);
        if (encoding_ != PlyEncoding::ascii) {
            cursor_.position += std::size_t(length * type_size(property.type));
            return;
        }
        for (std::uint64_t k = 0; k < length; ++k) {
            if ((k & 0xFFFF) == 0xFFFF) progress.check();
            ascii_value(element, i);
        }
    }

    void finish(const Progress& progress) {
        if (mesh_.sizes.empty())
            throw Error(ErrorCode::no_facets, source_.name, "no face has three corners",
                        "export the part as triangles");
        if (mesh_.lines) soup_.warnings.insert("lines_ignored");
        soup_.points = std::move(mesh_.points);
        soup_.facets.reserve(mesh_.corners.size() - 2 * mesh_.sizes.size());
        std::size_t begin = 0;
        for (std::size_t i = 0; i < mesh_.sizes.size(); ++i) {
            if ((i & 0xFFF) == 0) progress.set(double(i) / double(mesh_.sizes.size()));
            if (mesh_.sizes[i] > 3) soup_.warnings.insert("polygons_triangulated");
            if (!triangulate_polygon(soup_.points, &mesh_.corners[begin], mesh_.sizes[i], soup_.facets))
                soup_.warnings.insert("polygons_folded");
            begin += mesh_.sizes[i];
        }
    }

    const PlyHeader header_;
    const PlyEncoding encoding_;
    TextCursor cursor_;
    std::optional<std::uint64_t> vertex_count_;
    const PlyElement* facets_ = nullptr; ///< faces, or strips
    PlyMesh mesh_;
    TriangleSoup soup_;
};

TriangleSoup read_ply(const MeshSource& source, const Progress& progress) {
    if (is_wide_text(source.bytes))
        throw Error(ErrorCode::encoding, source.name, "the text is UTF-16 or UTF-32",
                    "save it as ASCII or UTF-8 (PowerShell: Out-File -Encoding ascii)");
    return PlyReader(source).run(progress);
}

bool sniff_ply(std::string_view bytes) {
    const std::string_view text = bytes.substr(byte_order_mark(bytes));
    return text.starts_with("ply\n") || text.starts_with("ply\r");
}

} // namespace

MeshFormat ply_format() {
    return {"PLY", "a PLY file", {".ply"}, sniff_ply, read_ply};
}

} // namespace facetmill::detail
