// Which objects of a file are asked for, by name or number: what readers of formats with objects share.
#pragma once

#include "core/mesh/mesh_format.h"

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill::detail {

class ObjectChoice {
public:
    /// From the reading that `source` asks for; it must outlive this.
    explicit ObjectChoice(const MeshSource& source);

    /// Nothing is asked for: the file's own scene or plate is read.
    bool is_open() const { return wanted_.empty(); }
    /// Whether an object is asked for that goes by these; an empty one is no name. Remembers that it is
    /// there.
    bool takes(std::initializer_list<std::string_view> names);
    /// Asks `find` of each name that no object was taken by, whether it is elsewhere in the file. Throws
    /// Error(missing_reference) where it is not; `there`: the file's ObjectList.
    void rest(const std::function<bool(const std::string&)>& find,
              const std::function<std::string()>& there) const;

private:
    const MeshSource& source_;
    std::vector<std::string> wanted_;
    std::vector<bool> found_; ///< of `wanted_`
};

/// "2, 5 (Handle), ...": numbers and names of a file's objects for a message, the first twenty.
class ObjectList {
public:
    void add(const std::string& number, std::string_view name);
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::size_t count_ = 0;
};

} // namespace facetmill::detail
