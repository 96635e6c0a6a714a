// The header of a PLY file: which elements follow, with which properties, and how they are stored.
#pragma once

#include "core/mesh/mesh_reader.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

namespace facetmill::detail {

/// How one number is stored.
enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

inline std::size_t type_size(PlyType type) {
    switch (type) {
    case PlyType::i8:
    case PlyType::u8:
        return 1;
    case PlyType::i16:
    case PlyType::u16:
        return 2;
    case PlyType::i32:
    case PlyType::u32:
    case PlyType::f32:
        return 4;
    case PlyType::f64:
        return 8;
    }
    return 8;
}

inline bool is_integer(PlyType type) {
    return type != PlyType::f32 && type != PlyType::f64;
}

struct PlyProperty {
    std::string_view name;
    PlyType type = PlyType::f32; ///< of a list: of its members
    bool list = false;
    PlyType count_type = PlyType::u8;
};

struct PlyElement {
    std::string_view name;
    std::uint64_t count = 0;
    std::size_t offset = 0; ///< of its line, for messages
    std::vector<PlyProperty> properties;

    bool has_list() const {
        return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.list; });
    }
    /// Bytes of one in a binary file, with empty lists; at least, in a text.
    std::size_t min_size(bool ascii) const {
        std::size_t size = 0;
        for (const PlyProperty& p : properties)
            size += ascii ? 2 : type_size(p.list ? p.count_type : p.type);
        return size;
    }
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements; ///< in the order of their data
    std::size_t end = 0;              ///< where the data begins

    /// The element of a name, or null.
    const PlyElement* find(std::string_view name) const {
        for (const PlyElement& e : elements)
            if (e.name == name) return &e;
        return nullptr;
    }
};

/// Throws Error(syntax, truncated).
PlyHeader read_ply_header(const MeshSource& source);

} // namespace facetmill::detail
