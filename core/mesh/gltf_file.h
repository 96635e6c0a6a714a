// glTF 2.0 as a file: its JSON, and the numbers that accessors take from its buffers. Internal to the room;
// gltf_reader.cpp makes a mesh of it.
#pragma once

#include "core/base/strict_json.h"
#include "core/mesh/mesh_reader.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill::detail {

/// A binary file begins so.
bool is_glb(std::string_view bytes);

class GltfFile {
public:
    /// The bytes must live as long. Throws Error(syntax, truncated, unsupported_format, missing_reference,
    /// ...): where another version, an extension that changes shapes, or data in another file is asked for.
    explicit GltfFile(const MeshSource& source);

    const Json& json() const { return json_; }
    bool is_binary() const { return binary_; }
    /// The list `key` of the whole file, empty where there is none.
    const Json& list(const char* key) const;
    /// An element of it. Throws Error(missing_reference) where there is none of this number.
    const Json& element(const char* key, std::size_t i) const;
    /// A whole number from 0 on, or `otherwise`.
    std::size_t number(const Json& object, const char* key, std::size_t otherwise,
                       const std::string& place) const;
    /// How many an accessor holds. Bounded by the file's bytes.
    std::size_t count_of(std::size_t accessor) const;
    /// Positions: three numbers each, floats or whole numbers (KHR_mesh_quantization).
    std::vector<Vec3> positions(std::size_t accessor, const Progress& progress) const;
    /// Whole numbers.
    std::vector<Index> indices(std::size_t accessor, const Progress& progress) const;

    [[noreturn]] void fail(ErrorCode code, const std::string& place, const std::string& what,
                           const std::string& remedy = "the file is damaged: export it again") const;

private:
    /// Where an accessor's numbers lie.
    struct Numbers {
        const char* first = nullptr; ///< null: all are zero
        std::size_t count = 0, stride = 0;
        unsigned type = 0; ///< as glTF numbers them: 5126 is float
        bool normalized = false;
    };
    void read_binary();
    void read_buffers();
    void check_extensions() const;
    Numbers numbers(std::size_t accessor, const char* shape, std::size_t components) const;

    const MeshSource& source_;
    Json json_;
    bool binary_ = false;
    std::string_view chunk_;           ///< of a binary file
    std::vector<std::string> decoded_; ///< buffers that stand in the text
    std::vector<std::string_view> buffers_;
};

} // namespace facetmill::detail
