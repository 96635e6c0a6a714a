// STL: which of its two forms a file has, and the binary one. The files lie: headers that start with "solid",
// counts that are wrong, bytes behind the end. Rules, in this order:
//   size = 84 + 50 count                      binary (also with the count's bytes reversed: big endian)
//   starts with "solid" and is text           ASCII
//   else binary with a wrong count:
//     with every CR LF made LF again the size is right: damaged by a transfer as text
//     walking `count` records of 50 + attribute bytes ends at the end of the file: attributes have a payload
//     count 0, 0xFFFFFFFF or too small, and whole records to the end of the file: the size is right
//     count too small and a rest of no whole record: the count is right, if what it covers looks like facets
//     count too large: truncated
#include "core/base/parallel.h"
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/stl_records.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"

#include <cmath>
#include <limits>

namespace facetmill::detail {

namespace {

/// Of a facet's longest edge and cross product, and of how far it reaches: more than what rounding to float
/// makes.
bool has_area(double cross, double edge, double reach) {
    return cross > tolerance::float_noise * reach * edge;
}

double reach_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
}
double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
}

} // namespace

NormalState compare_normal(const Vec3& stored, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!stored.allFinite()) return NormalState::unusable;
    const double length = stored.norm();
    if (length == 0.0) return NormalState::zero;
    if (!std::isfinite(length)) return NormalState::unusable;
    const Vec3 u = b - a, v = c - a;
    const Vec3 winding = u.cross(v);
    const double area = winding.norm();
    if (!has_area(area, longest_edge(a, b, c), reach_of(a, b, c))) return NormalState::agrees;
    const double cosine = stored.dot(winding) / (length * area);
    return cosine < 0.0 ? NormalState::opposes : cosine > 0.7 ? NormalState::agrees : NormalState::oblique;
}

namespace {

constexpr std::size_t header_size = 84;

/// The number of facets that a binary file announces, little endian; at least the header must be there.
std::uint64_t announced_count(std::string_view bytes) {
    const auto byte = [&](std::size_t i) { return std::uint64_t(static_cast<unsigned char>(bytes[80 + i])); };
    return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}
/// The same with its bytes reversed.
std::uint64_t reversed_count(std::uint64_t count) {
    return (count & 0xFF) << 24 | (count & 0xFF00) << 8 | (count >> 8 & 0xFF00) | count >> 24;
}

/// What one pass over all records finds.
struct RecordScan {
    bool attributes = false, bad_normals = false, normals_disagree = false;
    std::size_t plausible = 0; ///< usable corners and a stored normal along the winding or zero
    std::size_t certain = 0;   ///< and that normal is not zero, and the facet has an area
    std::size_t non_finite = std::size_t(-1); ///< first facet with a corner that is not a number
    std::size_t out_of_range = std::size_t(-1);
};

RecordScan scan_records(const TriangleSoup& soup, double limit, const Progress& progress) {
    return parallel_reduce(
        soup.record_count, 32768, RecordScan{}, progress,
        [&](std::size_t begin, std::size_t end) {
            RecordScan scan;
            for (std::size_t f = begin; f < end; ++f) {
                const StlRecord record(soup, f);
                scan.attributes = scan.attributes || record.attribute() != 0;
                const Vec3 a = record.corner(0), b = record.corner(1), c = record.corner(2);
                if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
                    scan.non_finite = std::min(scan.non_finite, f);
                    continue;
                }
                const double largest = reach_of(a, b, c);
                if (largest > limit) {
                    scan.out_of_range = std::min(scan.out_of_range, f);
                    continue;
                }
                const NormalState normal = compare_normal(record.normal(), a, b, c);
                scan.bad_normals = scan.bad_normals || normal == NormalState::unusable;
                scan.normals_disagree = scan.normals_disagree || normal == NormalState::opposes;
                // Normals turned inside out as a whole are a known fault of writers; noise is not parallel to
                // anything.
                const bool along = normal == NormalState::agrees
                                   || (normal == NormalState::opposes
                                       && compare_normal(-record.normal(), a, b, c) == NormalState::agrees);
                const double length = record.normal().norm();
                const bool flat = !has_area((b - a).cross(c - a).norm(), longest_edge(a, b, c), largest);
                // Bytes of something else are often nearly zero: then the normal's length is the only sign.
                scan.plausible +=
                    flat ? std::abs(length - 1) < 0.01
                         : along || normal == NormalState::zero || normal == NormalState::unusable;
                scan.certain += along && !flat;
            }
            return scan;
        },
        [](RecordScan total, const RecordScan& part) {
            total.attributes = total.attributes || part.attributes;
            total.bad_normals = total.bad_normals || part.bad_normals;
            total.normals_disagree = total.normals_disagree || part.normals_disagree;
            total.plausible += part.plausible;
            total.certain += part.certain;
            total.non_finite = std::min(total.non_finite, part.non_finite);
            total.out_of_range = std::min(total.out_of_range, part.out_of_range);
            return total;
        });
}

/// Record offsets when every record is followed by as many bytes as its attribute word says and the last one
/// ends at the end of the file; else empty.
std::vector<std::uint64_t> walk_payloads(std::string_view records, std::uint64_t count,
                                         const Progress& progress) {
    std::vector<std::uint64_t> offsets;
    std::uint64_t at = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        if ((i & 0xFFFF) == 0) progress.check();
        if (records.size() - at < StlRecord::size) return {};
        offsets.push_back(at);
        const auto low = static_cast<unsigned char>(records[at + 48]);
        const auto high = static_cast<unsigned char>(records[at + 49]);
        at += StlRecord::size + (low | unsigned(high) << 8);
        if (at > records.size()) return {};
    }
    return at == records.size() ? offsets : std::vector<std::uint64_t>{};
}

/// A transfer as text has put a CR before every LF, and without those the size is right.
bool was_sent_as_text(std::string_view bytes, const Progress& progress) {
    std::uint64_t pairs = 0;
    std::size_t header = header_size; // with the CRs in it
    for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
        if (at == 0 || bytes[at - 1] != '\r') return false;
        if (at <= header) ++header;
        if ((++pairs & 0xFFFF) == 0) progress.check();
    }
    if (pairs == 0 || bytes.size() < header) return false;
    std::string start;
    for (std::size_t i = 0; i < header && start.size() < header_size; ++i)
        if (bytes[i] != '\r' || i + 1 == bytes.size() || bytes[i + 1] != '\n') start += bytes[i];
    return start.size() == header_size
           && bytes.size() - pairs == header_size + StlRecord::size * announced_count(start);
}

/// A program has taken the bytes for text and written them as UTF-8: those beyond ASCII are sequences of it
/// now, which those of numbers hardly ever are.
bool was_written_as_utf8(std::string_view bytes, const Progress& progress) {
    constexpr std::size_t enough = 16;
    std::size_t sequences = 0;
    for (std::size_t i = 0; i < bytes.size();) {
        if ((i & 0xFFFF) == 0) progress.check();
        const auto lead = static_cast<unsigned char>(bytes[i++]);
        if (lead < 0x80) continue;
        if (lead < 0xC2 || lead > 0xF4) return false;
        const std::size_t further = lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
        for (std::size_t k = 0; k < further; ++k, ++i)
            if (i == bytes.size() || (static_cast<unsigned char>(bytes[i]) & 0xC0) != 0x80) return false;
        ++sequences;
    }
    return sequences >= enough;
}

/// Bytes behind the last facet are an STL file themselves.
bool is_another_stl(std::string_view bytes) {
    if (starts_with_solid(bytes) && is_text(bytes)) return true;
    return bytes.size() > header_size
           && bytes.size() == header_size + StlRecord::size * announced_count(bytes);
}

/// Text without any zero byte: a cut binary file has some in its count.
bool is_plain_text(std::string_view bytes) {
    return bytes.find('\0') == std::string_view::npos && is_text(bytes);
}

[[noreturn]] void refuse_foreign(const MeshSource& source, std::string_view what) {
    throw Error(ErrorCode::not_stl, source.name, "is not an STL file but " + std::string(what),
                "open the mesh itself, under a name that ends as its format does");
}

/// Refuses a file whose size is not the one that its count asks for, where the cause is known.
void refuse_changed(const MeshSource& source, std::uint64_t count, std::uint64_t whole,
                    const Progress& progress) {
    const std::string_view bytes = source.bytes;
    if (const auto what = content_of(bytes, "STL"); !what.empty()) refuse_foreign(source, what);
    if (is_plain_text(bytes)) refuse_foreign(source, "a text that does not start with 'solid'");
    if (was_sent_as_text(bytes, progress))
        throw Error(ErrorCode::syntax, source.name,
                    "a transfer as text has changed the binary file: there is a CR before every LF",
                    "copy it again as binary (FTP: type binary; Git: mark *.stl as binary)");
    if (was_written_as_utf8(bytes, progress))
        throw Error(ErrorCode::syntax, source.name,
                    "a program has taken the binary file for text and written it as UTF-8",
                    "export it again, and copy it as binary");
    if (count > 0 && count <= whole && is_another_stl(bytes.substr(header_size + count * StlRecord::size)))
        throw Error(ErrorCode::count_mismatch, source.name, "another STL file follows the first in it",
                    "open them one by one, or join them in the program that made them");
}

/// Refuses facets of another length than 50 bytes: a writer that pads its records, or leaves attributes out.
void refuse_other_records(const MeshSource& source, const TriangleSoup& soup, std::uint64_t count,
                          const Progress& progress) {
    constexpr std::uint64_t without_attribute = 48, longest = 256;
    const std::uint64_t size = source.bytes.size() - header_size;
    if (count == 0 || size % count != 0) return;
    const std::uint64_t length = size / count;
    if (length != without_attribute && (length <= StlRecord::size || length > longest)) return;
    TriangleSoup usual = soup, other = soup;
    usual.record_count = std::min(count, size / StlRecord::size);
    other.record_count = count - (length < StlRecord::size); // the last one would be read beyond its end
    for (std::uint64_t i = 0; i < other.record_count; ++i)
        other.record_offsets.push_back(i * length);
    if (scan_records(other, source.coordinate_limit, progress.part(0, 0)).certain
        <= scan_records(usual, source.coordinate_limit, progress.part(0, 0)).certain)
        return;
    throw Error(ErrorCode::count_mismatch, source.name,
                "each facet has " + std::to_string(length) + " bytes, those of a binary STL file have 50",
                "the program that wrote it is wrong: export the part by another one");
}

TriangleSoup read_binary_stl(const MeshSource& source, const Progress& progress) {
    const std::string_view bytes = source.bytes;
    if (bytes.size() < header_size) {
        if (const auto what = content_of(bytes, "STL"); !what.empty()) refuse_foreign(source, what);
        if (is_plain_text(bytes)) refuse_foreign(source, "a text that does not start with 'solid'");
        throw Error(ErrorCode::truncated, source.name,
                    "the file has " + std::to_string(bytes.size()) + " bytes, a binary STL file at least 84",
                    "copy or export it again");
    }
    const std::string_view body = bytes.substr(header_size);
    const std::uint64_t count = announced_count(bytes), reversed = reversed_count(count);
    const std::uint64_t whole = body.size() / StlRecord::size;
    const bool ragged = body.size() % StlRecord::size != 0;

    TriangleSoup soup;
    soup.format = "STL binary";
    soup.single_precision = true;
    soup.records = body.data();
    soup.name = printable(bytes.substr(0, std::min(bytes.substr(0, 80).find('\0'), std::size_t(80))), 200);
    while (!soup.name.empty() && soup.name.back() == ' ')
        soup.name.pop_back();
    if (starts_with_solid(bytes.substr(0, 80))) soup.warnings.insert("binary_solid_header");

    const std::string says = "the header announces " + std::to_string(count)
                             + " facets, the file has bytes for " + std::to_string(whole);
    bool check_sanity = false;
    if (!ragged && count == whole) {
        soup.record_count = count;
    } else if (!ragged && reversed == whole) {
        soup.record_count = reversed;
        soup.big_endian = true;
        soup.warnings.insert("big_endian");
    } else {
        refuse_changed(source, count, whole, progress);
        if (count < whole || (count == whole && ragged))
            soup.record_offsets = walk_payloads(body, count, progress);
        if (soup.record_offsets.empty()) refuse_other_records(source, soup, count, progress);
        if (!soup.record_offsets.empty()) {
            soup.record_count = count;
            soup.warnings.insert("attribute_payload");
        } else if (!ragged && (count == 0xFFFFFFFFu || count < whole) && whole > 0) {
            soup.record_count = whole;
            soup.warnings.insert("count_wrong");
            check_sanity = true;
        } else if (count > whole) {
            throw Error(ErrorCode::truncated, source.name, says, "the file was cut: copy or export it again");
        } else {
            soup.record_count = count;
            soup.warnings.insert("trailing_data");
            check_sanity = true;
        }
    }
    const RecordScan scan = scan_records(soup, source.coordinate_limit, progress.part(0.05, 1.0));
    if (check_sanity && 2 * scan.plausible <= soup.record_count)
        throw Error(ErrorCode::count_mismatch, source.name,
                    ragged ? says + " and a rest, and they do not look like facets"
                           : says + ", and they do not look like facets",
                    "the file is damaged or is not STL: export it again");
    if (soup.record_count == 0)
        throw Error(ErrorCode::no_facets, source.name, "the file holds no facet", "export the part again");
    const auto refuse = [&](ErrorCode code, std::size_t facet, const std::string& what,
                            const std::string& remedy) {
        throw Error(code, source.name + ", facet " + std::to_string(facet + 1), what, remedy);
    };
    if (scan.non_finite < scan.out_of_range && scan.non_finite != std::size_t(-1))
        refuse(ErrorCode::non_finite, scan.non_finite, "a corner is not a finite number",
               "the file is damaged: export it again");
    if (scan.out_of_range != std::size_t(-1))
        refuse(ErrorCode::coordinate_range, scan.out_of_range,
               "a corner is further than " + format_number(source.coordinate_limit) + " from the origin",
               "the file is damaged or in another unit");
    if (scan.attributes && soup.record_offsets.empty()) soup.warnings.insert("attribute_data");
    if (scan.bad_normals) soup.warnings.insert("bad_normals");
    if (scan.normals_disagree) soup.warnings.insert("normals_disagree");
    return soup;
}

TriangleSoup read_stl(const MeshSource& source, const Progress& progress) {
    const std::string_view bytes = source.bytes;
    const auto fits = [&] {
        if (bytes.size() < header_size || (bytes.size() - header_size) % StlRecord::size != 0) return false;
        const std::uint64_t whole = (bytes.size() - header_size) / StlRecord::size;
        return whole == announced_count(bytes) || whole == reversed_count(announced_count(bytes));
    };
    if (fits()) return read_binary_stl(source, progress);
    if (is_wide_text(bytes))
        throw Error(ErrorCode::encoding, source.name, "the text is UTF-16 or UTF-32",
                    "save it as ASCII or UTF-8 (PowerShell: Out-File -Encoding ascii)");
    if (starts_with_solid(bytes)) {
        if (is_text(bytes)) return read_ascii_stl(source, progress);
        // The place of a binary file's count holds text: an ASCII file with binary bytes in it.
        const auto printing = [](char c) { return is_space(c) || (c >= 0x20 && c < 0x7F); };
        if (bytes.size() > header_size && std::all_of(&bytes[80], &bytes[80] + 4, printing))
            throw Error(ErrorCode::syntax, source.name,
                        "the text of an ASCII STL file has binary bytes in it",
                        "the file is damaged: export it again");
    }
    return read_binary_stl(source, progress);
}

bool sniff_stl(std::string_view bytes) {
    const bool has_facet = bytes.size() >= header_size + StlRecord::size;
    return (has_facet && header_size + StlRecord::size * announced_count(bytes) == bytes.size())
           || starts_with_solid(bytes);
}

} // namespace

MeshFormat stl_format() {
    return {"STL", "an STL file", {".stl", ".stla", ".stlb"}, sniff_stl, read_stl};
}

} // namespace facetmill::detail
