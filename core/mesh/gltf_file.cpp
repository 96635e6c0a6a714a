#include "core/mesh/gltf_file.h"

#include "core/base/error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace facetmill::detail {

namespace {

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8, max_gltf_text = std::size_t(60) << 20;
constexpr std::uint32_t json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;
constexpr unsigned byte_type = 5120, ubyte_type = 5121, short_type = 5122, ushort_type = 5123,
                   uint_type = 5125, float_type = 5126;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t v = 0;
    std::memcpy(&v, bytes.data() + at, sizeof v);
    return v;
}

std::size_t bytes_of(unsigned type) {
    switch (type) {
    case byte_type:
    case ubyte_type:
        return 1;
    case short_type:
    case ushort_type:
        return 2;
    case uint_type:
    case float_type:
        return 4;
    default:
        return 0;
    }
}

template <class T>
T read_as(const char* from) {
    T v{};
    std::memcpy(&v, from, sizeof v);
    return v;
}

/// A number of an accessor. Normalized whole numbers are from -1 or 0 to 1.
double value_at(const char* from, unsigned type, bool normalized) {
    switch (type) {
    case byte_type:
        return normalized ? std::max(read_as<std::int8_t>(from) / 127.0, -1.0) : read_as<std::int8_t>(from);
    case ubyte_type:
        return read_as<std::uint8_t>(from) / (normalized ? 255.0 : 1.0);
    case short_type:
        return normalized ? std::max(read_as<std::int16_t>(from) / 32767.0, -1.0)
                          : read_as<std::int16_t>(from);
    case ushort_type:
        return read_as<std::uint16_t>(from) / (normalized ? 65535.0 : 1.0);
    case uint_type:
        return read_as<std::uint32_t>(from);
    default:
        return double(read_as<float>(from));
    }
}

/// The bytes of a text of base64; false where it is none.
bool decode_base64(std::string_view text, std::string& bytes) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    std::uint32_t bits = 0;
    int held = 0;
    bytes.reserve(text.size() / 4 * 3 + 3);
    for (const char c : text) {
        const std::uint32_t v = c >= 'A' && c <= 'Z'   ? std::uint32_t(c - 'A')
                                : c >= 'a' && c <= 'z' ? std::uint32_t(c - 'a') + 26
                                : c >= '0' && c <= '9' ? std::uint32_t(c - '0') + 52
                                : c == '+'             ? 62U
                                : c == '/'             ? 63U
                                                       : 64U;
        if (v > 63) return false;
        bits = bits << 6 | v;
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += char(bits >> held & 0xFF);
    }
    return held < 6; // a letter alone holds no byte
}

std::string of(const char* key, std::size_t i) {
    return std::string(key) + "[" + std::to_string(i) + "]";
}

} // namespace

bool is_glb(std::string_view bytes) {
    return bytes.starts_with("glTF");
}

void GltfFile::fail(ErrorCode code, const std::string& place, const std::string& what,
                    const std::string& remedy) const {
    throw Error(code, source_.name + (place.empty() ? "" : ": " + printable(place, 200)), what, remedy);
}

GltfFile::GltfFile(const MeshSource& source) : source_(source), binary_(is_glb(source.bytes)) {
    std::string_view text = source.bytes;
    if (binary_) {
        read_binary();
        text = source.bytes.substr(header_bytes + chunk_header_bytes, word_at(source.bytes, header_bytes));
    } else if (text.size() > max_gltf_text) {
        fail(ErrorCode::limit_exceeded, "", "the text has more than 60 MB",
             "save it in binary form, as .glb");
    }
    json_ = parse_strict_json(text, source.name);
    if (!json_.is_object() || !json_.contains("asset") || !json_["asset"].is_object())
        fail(ErrorCode::syntax, "", "is JSON, but no glTF: it has no asset", "export the part again");
    const Json& asset = json_["asset"];
    const std::string version =
        asset.contains("version") && asset["version"].is_string() ? asset["version"].get<std::string>() : "";
    if (!version.starts_with("2."))
        fail(ErrorCode::unsupported_format, "asset", "is glTF of version '" + printable(version, 20) + "'",
             "export it as glTF 2.0");
    check_extensions();
    read_buffers();
}

void GltfFile::read_binary() {
    const std::string_view bytes = source_.bytes;
    if (bytes.size() < header_bytes + chunk_header_bytes)
        fail(ErrorCode::truncated, "", "the file ends in its header",
             "the file was cut: copy or export it again");
    if (word_at(bytes, 4) != 2)
        fail(ErrorCode::unsupported_format, "",
             "is binary glTF of version " + std::to_string(word_at(bytes, 4)), "export it as glTF 2.0");
    const std::uint64_t length = word_at(bytes, 8), text = word_at(bytes, header_bytes);
    if (length > bytes.size() || header_bytes + chunk_header_bytes + text > bytes.size())
        fail(ErrorCode::truncated, "",
             "the file has " + std::to_string(bytes.size()) + " bytes, and should have more",
             "the file was cut: copy or export it again");
    if (word_at(bytes, header_bytes + 4) != json_chunk)
        fail(ErrorCode::syntax, "", "does not begin with its JSON");
    std::size_t at = header_bytes + chunk_header_bytes + std::size_t(text);
    while (at + chunk_header_bytes <= length) {
        const std::uint64_t size = word_at(bytes, at);
        if (at + chunk_header_bytes + size > bytes.size())
            fail(ErrorCode::truncated, "", "the file ends within its data",
                 "the file was cut: copy or export it again");
        if (word_at(bytes, at + 4) == bin_chunk && chunk_.data() == nullptr)
            chunk_ = bytes.substr(at + chunk_header_bytes, std::size_t(size));
        at += chunk_header_bytes + std::size_t(size);
    }
}

/// Materials, lights and the like may be required; what changes or packs shapes may not.
void GltfFile::check_extensions() const {
    for (const Json& name : list("extensionsRequired")) {
        const std::string extension = name.is_string() ? name.get<std::string>() : "";
        bool known = extension == "KHR_mesh_quantization";
        for (const char* family :
             {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "KHR_xmp"})
            known = known || extension.starts_with(family);
        if (!known)
            fail(ErrorCode::unsupported_format, "extensionsRequired",
                 "the model cannot be read without the extension '" + printable(extension, 60) + "'",
                 "export it without compression, as plain triangles");
    }
}

void GltfFile::read_buffers() {
    const Json& all = list("buffers");
    decoded_.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string place = of("buffers", i);
        const std::size_t length = number(all[i], "byteLength", 0, place);
        if (!all[i].contains("uri")) {
            if (i > 0 || !binary_) fail(ErrorCode::missing_reference, place, "the buffer has no data");
            buffers_.push_back(chunk_);
        } else {
            const std::string uri = all[i]["uri"].is_string() ? all[i]["uri"].get<std::string>() : "";
            const std::size_t comma = uri.find(";base64,");
            if (!uri.starts_with("data:") || comma == std::string::npos)
                fail(ErrorCode::missing_reference, place,
                     "the data lies in another file, '" + printable(uri, 80) + "'",
                     "export it as one file, .glb");
            if (!decode_base64(std::string_view(uri).substr(comma + 8), decoded_[i]))
                fail(ErrorCode::syntax, place, "the data is no base64");
            buffers_.emplace_back(decoded_[i]);
        }
        if (buffers_.back().size() < length)
            fail(ErrorCode::truncated, place,
                 "the buffer has " + std::to_string(buffers_.back().size()) + " bytes, not "
                     + std::to_string(length),
                 "the file was cut: copy or export it again");
        buffers_.back() = buffers_.back().substr(0, length);
    }
}

const Json& GltfFile::list(const char* key) const {
    static const Json none = Json::array();
    const auto found = json_.find(key);
    if (found == json_.end()) return none;
    if (!found->is_array()) fail(ErrorCode::syntax, key, "is no list");
    return *found;
}

const Json& GltfFile::element(const char* key, std::size_t i) const {
    const Json& all = list(key);
    if (i >= all.size() || !all[i].is_object())
        fail(ErrorCode::missing_reference, key, "there is no number " + std::to_string(i));
    return all[i];
}

std::size_t GltfFile::number(const Json& object, const char* key, std::size_t otherwise,
                             const std::string& place) const {
    if (!object.is_object()) fail(ErrorCode::syntax, place, "is no object");
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    const bool whole = found->is_number() && found->get<double>() >= 0 && found->get<double>() < 1e15
                       && found->get<double>() == std::floor(found->get<double>());
    if (!whole) fail(ErrorCode::syntax, place + "." + key, "is no whole number");
    return std::size_t(found->get<double>());
}

GltfFile::Numbers GltfFile::numbers(std::size_t i, const char* shape, std::size_t components) const {
    const Json& accessor = element("accessors", i);
    const std::string place = of("accessors", i);
    if (accessor.contains("sparse"))
        fail(ErrorCode::unsupported_format, place, "holds changes to other numbers",
             "export it as plain triangles");
    if (accessor.value("type", Json()) != shape)
        fail(ErrorCode::syntax, place, "is of another type than " + std::string(shape));
    Numbers all;
    all.type = unsigned(number(accessor, "componentType", 0, place));
    const std::size_t each = bytes_of(all.type) * components;
    if (each == 0) fail(ErrorCode::syntax, place, "its numbers are of an unknown type");
    all.count = number(accessor, "count", 0, place);
    all.normalized = accessor.value("normalized", Json()) == true;
    all.stride = each;
    if (!accessor.contains("bufferView")) {
        // All zero: as many as the file could hold, so that a small file asks for little.
        if (all.count > source_.bytes.size())
            fail(ErrorCode::limit_exceeded, place, "holds more numbers than the file has bytes");
        return all;
    }
    const std::size_t v = number(accessor, "bufferView", 0, place);
    const Json& view = element("bufferViews", v);
    const std::string view_place = of("bufferViews", v);
    const std::size_t b = number(view, "buffer", 0, view_place),
                      start = number(view, "byteOffset", 0, view_place),
                      length = number(view, "byteLength", 0, view_place),
                      offset = number(accessor, "byteOffset", 0, place);
    all.stride = number(view, "byteStride", each, view_place);
    if (b >= buffers_.size())
        fail(ErrorCode::missing_reference, view_place, "there is no buffer " + std::to_string(b));
    if (start > buffers_[b].size() || length > buffers_[b].size() - start)
        fail(ErrorCode::syntax, view_place, "goes beyond its buffer");
    if (all.stride < each) fail(ErrorCode::syntax, view_place, "its numbers lie over each other");
    if (all.count > 0
        && (offset > length || length - offset < each
            || (length - offset - each) / all.stride < all.count - 1))
        fail(ErrorCode::syntax, place, "goes beyond its part of the buffer");
    all.first = buffers_[b].data() + start + offset;
    return all;
}

std::size_t GltfFile::count_of(std::size_t accessor) const {
    return number(element("accessors", accessor), "count", 0, of("accessors", accessor));
}

std::vector<Vec3> GltfFile::positions(std::size_t accessor, const Progress& progress) const {
    const Numbers all = numbers(accessor, "VEC3", 3);
    std::vector<Vec3> points(all.count, Vec3::Zero());
    for (std::size_t i = 0; all.first && i < all.count; ++i) {
        if (i % 65536 == 0) progress.set(double(i) / double(all.count));
        for (int k = 0; k < 3; ++k)
            points[i][k] = value_at(all.first + i * all.stride + std::size_t(k) * bytes_of(all.type),
                                    all.type, all.normalized);
        if (!points[i].allFinite())
            fail(ErrorCode::non_finite, of("accessors", accessor),
                 "the position " + std::to_string(i) + " is not a finite number");
    }
    return points;
}

std::vector<Index> GltfFile::indices(std::size_t accessor, const Progress& progress) const {
    const Numbers all = numbers(accessor, "SCALAR", 1);
    if (all.type != ubyte_type && all.type != ushort_type && all.type != uint_type)
        fail(ErrorCode::syntax, of("accessors", accessor), "its numbers are no numbers of vertices");
    std::vector<Index> corners(all.count, 0);
    for (std::size_t i = 0; all.first && i < all.count; ++i) {
        if (i % 65536 == 0) progress.set(double(i) / double(all.count));
        corners[i] = Index(value_at(all.first + i * all.stride, all.type, false));
    }
    return corners;
}

} // namespace facetmill::detail
