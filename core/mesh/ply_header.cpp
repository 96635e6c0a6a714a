#include "core/mesh/ply_header.h"

#include "core/base/error.h"

#include <charconv>

namespace facetmill::detail {

namespace {

/// Scanners write three elements and a dozen properties; names are looked for one by one.
constexpr std::size_t max_elements = 256, max_properties = 1024;

class PlyHeaderReader : TextReader {
public:
    explicit PlyHeaderReader(const MeshSource& source) : TextReader(source), cursor_{source.bytes} {}

    PlyHeader run() {
        cursor_.position = byte_order_mark(source_.bytes);
        if (cursor_.token_in_line() != "ply")
            throw Error(ErrorCode::syntax, source_.name, "is not a PLY file: it does not start with 'ply'",
                        "open the mesh itself, under a name that ends as its format does");
        try {
            statements();
        } catch (const Error& e) {
            // Half a word at the end of the file is no mistake of the writer.
            if (e.code() == ErrorCode::syntax && cursor_.at_end())
                fail_truncated("the header", "the file ends inside the header");
            throw;
        }
        return std::move(header_);
    }

private:
    std::string_view header_token(const char* what) {
        const std::string_view token = cursor_.token_in_line();
        if (token.empty()) {
            if (cursor_.at_end()) fail_truncated("the header", "the file ends inside the header");
            fail(ErrorCode::syntax, cursor_.position, std::string(what) + " expected");
        }
        return token;
    }

    PlyType type(std::string_view token) const {
        static constexpr std::pair<std::string_view, PlyType> names[] = {
            {"char", PlyType::i8},     {"int8", PlyType::i8},     {"uchar", PlyType::u8},
            {"uint8", PlyType::u8},    {"short", PlyType::i16},   {"int16", PlyType::i16},
            {"ushort", PlyType::u16},  {"uint16", PlyType::u16},  {"int", PlyType::i32},
            {"int32", PlyType::i32},   {"uint", PlyType::u32},    {"uint32", PlyType::u32},
            {"float", PlyType::f32},   {"float32", PlyType::f32}, {"double", PlyType::f64},
            {"float64", PlyType::f64},
        };
        for (const auto& [name, t] : names)
            if (token == name) return t;
        fail(ErrorCode::syntax, start_of(token), "unknown number type '" + printable(token, 40) + "'");
    }

    void statements() {
        for (;;) {
            end_line();
            const std::string_view word = cursor_.token_in_line();
            if (word == "comment" || word == "obj_info")
                cursor_.to_line_end();
            else if (word == "format")
                format();
            else if (word == "element")
                element(start_of(word));
            else if (word == "property")
                property(start_of(word));
            else if (word == "end_header")
                break;
            else if (!word.empty())
                fail(ErrorCode::syntax, start_of(word), "unknown header word '" + printable(word, 40) + "'");
        }
        while (!cursor_.at_end() && is_blank(source_.bytes[cursor_.position]))
            ++cursor_.position;
        if (cursor_.at_end()) fail_truncated("the header", "nothing follows the header");
        // In a binary file a CR LF may also be a CR and a first data byte of 10; writers of CR alone are
        // extinct.
        cursor_.skip_line_end();
        if (!has_format_) fail(ErrorCode::syntax, cursor_.position - 1, "the header names no format");
        header_.end = cursor_.position;
    }

    /// Nothing but blanks may follow a statement in its line.
    void end_line() {
        const std::size_t rest = cursor_.position;
        cursor_.to_line_end();
        if (cursor_.position != rest && !only_blank(rest, cursor_.position))
            fail(ErrorCode::syntax, rest, "too many words in the header line");
        if (cursor_.at_end()) fail_truncated("the header", "the file ends inside the header");
        cursor_.skip_line_end();
    }

    void format() {
        const std::string_view name = header_token("a format");
        has_format_ = true;
        if (name == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (name == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (name == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            fail(ErrorCode::syntax, start_of(name), "unknown format '" + printable(name, 40) + "'");
        if (const auto version = header_token("a version"); version != "1.0" && version != "1")
            fail(ErrorCode::syntax, start_of(version), "unknown version '" + printable(version, 40) + "'");
    }

    void element(std::size_t offset) {
        if (header_.elements.size() == max_elements)
            fail(ErrorCode::limit_exceeded, offset, "the header names too many elements");
        PlyElement element;
        element.offset = offset;
        element.name = header_token("a name");
        if (header_.find(element.name))
            fail(ErrorCode::syntax, element.offset,
                 "the element '" + printable(element.name, 40) + "' occurs twice");
        const std::string_view count = header_token("a count");
        const auto r = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (r.ec != std::errc() || r.ptr != count.data() + count.size())
            fail(ErrorCode::syntax, start_of(count),
                 "a count expected, found '" + printable(count, 40) + "'");
        header_.elements.push_back(element);
    }

    void property(std::size_t offset) {
        if (header_.elements.empty()) fail(ErrorCode::syntax, offset, "a property before any element");
        if (header_.elements.back().properties.size() == max_properties)
            fail(ErrorCode::limit_exceeded, offset, "the element has too many properties");
        PlyProperty property;
        std::string_view t = header_token("a type");
        if (t == "list") {
            property.list = true;
            t = header_token("a type");
            property.count_type = type(t);
            if (!is_integer(property.count_type))
                fail(ErrorCode::syntax, start_of(t), "the count of a list must be an integer");
            t = header_token("a type");
        }
        property.type = type(t);
        property.name = header_token("a name");
        header_.elements.back().properties.push_back(property);
    }

    bool only_blank(std::size_t begin, std::size_t end) const {
        return std::all_of(&source_.bytes[begin], &source_.bytes[begin] + (end - begin), is_blank);
    }

    TextCursor cursor_;
    PlyHeader header_;
    bool has_format_ = false;
};

} // namespace

PlyHeader read_ply_header(const MeshSource& source) {
    return PlyHeaderReader(source).run();
}

} // namespace facetmill::detail
