#include "core/mesh/object_choice.h"

#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/mesh/mesh_reader.h"

namespace facetmill::detail {

ObjectChoice::ObjectChoice(const MeshSource& source)
    : source_(source), wanted_(listed_names(source.reading.objects)), found_(wanted_.size(), false) {}

bool ObjectChoice::takes(std::initializer_list<std::string_view> names) {
    bool taken = false;
    for (std::size_t i = 0; i < wanted_.size(); ++i)
        for (const std::string_view name : names)
            if (!name.empty() && wanted_[i] == name) taken = found_[i] = true;
    return taken;
}

void ObjectChoice::rest(const std::function<bool(const std::string&)>& find,
                        const std::function<std::string()>& there) const {
    for (std::size_t i = 0; i < wanted_.size(); ++i)
        if (!found_[i] && !find(wanted_[i]))
            throw Error(ErrorCode::missing_reference, source_.name,
                        "there is no object '" + printable(wanted_[i]) + "'",
                        "objects there are: " + there());
}

void ObjectList::add(const std::string& number, std::string_view name) {
    constexpr std::size_t most = 20;
    ++count_;
    if (count_ > most + 1) return;
    if (count_ > 1) text_ += ", ";
    if (count_ > most)
        text_ += "...";
    else
        text_ += number + (name.empty() ? "" : " (" + printable(name, 60) + ")");
}

} // namespace facetmill::detail
