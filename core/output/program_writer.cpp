#include "core/output/program_writer.h"

#include "core/base/error.h"

#include <algorithm>
#include <memory>

namespace facetmill {

namespace {

std::vector<ProgramWriter>& registry() {
    static std::vector<ProgramWriter> writers;
    return writers;
}

} // namespace

ProgramWriterRegistration::ProgramWriterRegistration(ProgramWriter writer) {
    auto& writers = registry();
    const auto place =
        std::lower_bound(writers.begin(), writers.end(), writer.name,
                         [](const ProgramWriter& w, const std::string& name) { return w.name < name; });
    writers.insert(place, std::move(writer));
}

const std::vector<ProgramWriter>& program_writers() {
    return registry();
}

const ProgramWriter& program_writer(std::string_view name) {
    std::string known;
    for (const ProgramWriter& writer : registry()) {
        if (writer.name == name) return writer;
        known += (known.empty() ? "" : ", ") + writer.name;
    }
    throw Error(ErrorCode::out_of_range, "writer", "unknown program writer '" + printable(name) + "'",
                "use one of: " + known);
}

} // namespace facetmill
