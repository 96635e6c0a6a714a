#include "core/setup/machine.h"

#include "core/base/error.h"

namespace facetmill {

const std::vector<Machine>& machines() {
    static const std::vector<Machine> all = {
        // 10 m/min in every axis: what a plain vertical mill of today reaches.
        {.name = "generic-3-axis",
         .label = "Generic mill (3-axis)",
         .rapid_mm_per_s = Vec3(1000, 1000, 1000) / 6},
        // Joint speeds as Lu 3.5.5.2 gives them.
        {.name = "tarus-tpi-2000",
         .label = "Tarus TPI 2000 (5-axis, head-head)",
         .rapid_mm_per_s = Vec3(170, 180, 240)},
    };
    return all;
}

const Machine& find_machine(std::string_view name) {
    std::vector<std::string> known;
    for (const Machine& m : machines()) {
        if (m.name == name) return m;
        known.push_back(m.name);
    }
    std::string list;
    for (const auto& k : known)
        list += (list.empty() ? "" : ", ") + k;
    throw Error(ErrorCode::missing_reference, "machine", "there is no machine '" + printable(name) + "'",
                "known machines: " + list);
}

} // namespace facetmill
