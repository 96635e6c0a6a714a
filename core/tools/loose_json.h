// JSON of other programs: read tolerantly, with an account of what nobody has asked for.
#pragma once

#include "core/base/strict_json.h"
#include "core/base/units.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace facetmill {

/// The nearest number that a tool may have.
long as_tool_number(double number);

/// One object. Members that are asked for count as carried.
class LooseObject {
public:
    /// The object must outlive this; what is no object has no members.
    explicit LooseObject(const Json& object, std::string place = {});

    bool has(const std::string& key) const { return find(key) != nullptr; }
    /// A number, or the text of one, with a unit behind it or without ("6.0000 mm", "1/4 in", "60 °"):
    /// lengths in mm, by `unit` where none is said, angles in radians, by degrees where none is said. None
    /// where there is no such member or it is null or an empty text. Throws Error(wrong_type) for what is no
    /// number.
    std::optional<double> length(const std::string& key, LengthUnit unit);
    std::optional<double> angle(const std::string& key);
    std::optional<double> number(const std::string& key);
    /// A whole number that counts something, at least 0; 0 where there is none.
    long count(const std::string& key);
    /// The number of a tool as far as tools can have it.
    long tool_number(const std::string& key, long otherwise);
    /// Empty where there is none; numbers as texts.
    std::string text(const std::string& key);
    LooseObject object(const std::string& key);
    /// Empty where there is no list.
    std::vector<LooseObject> objects(const std::string& key);
    /// Not carried, and not worth a word: identifiers, what follows from other members.
    void drop(std::initializer_list<const char*> keys);

    const std::string& place() const { return place_; }
    std::string place_of(const std::string& key) const;
    /// Members that nobody has asked for and that say something: no null, false, 0, empty text, list or
    /// object.
    std::vector<std::string> left() const;

private:
    const Json* find(const std::string& key) const;
    const Json* take(const std::string& key);

    const Json* object_;
    std::string place_;
    std::set<std::string> taken_;
};

} // namespace facetmill
