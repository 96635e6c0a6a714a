#include "core/setup/machine.h"

#include "core/base/catalogue.h"
#include "core/base/strict_json.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/setup/machine_files.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

using namespace strict;

namespace {

constexpr long newest_version = 1;
constexpr const char* linear_names[] = {"X", "Y", "Z"};

/// One value after the other of an object, by key; `finish` refuses the keys nobody asked for.
class Reader {
public:
    Reader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
        expect_object(object_, place_);
    }

    std::string at(const std::string& key) const { return member(place_, key); }
    bool has(const std::string& key) {
        known_.push_back(key);
        return object_.contains(key);
    }
    const Json& value(const std::string& key, const std::string& remedy) {
        known_.push_back(key);
        return require(object_, place_, key, remedy);
    }
    std::string text(const std::string& key, const std::string& remedy) {
        return read_text(value(key, remedy), at(key));
    }
    /// One of `words`.
    std::size_t word(const std::string& key, const std::vector<std::string>& words) {
        std::string list;
        for (const std::string& w : words)
            list += (list.empty() ? "\"" : " or \"") + w + "\"";
        const std::string given = text(key, "write " + list);
        const auto found = std::find(words.begin(), words.end(), given);
        if (found == words.end())
            throw Error(ErrorCode::out_of_range, at(key), "'" + printable(given) + "' is not known",
                        "write " + list);
        return std::size_t(found - words.begin());
    }
    double positive(const std::string& key, double scale, const std::string& remedy) {
        const double v = number(value(key, remedy), at(key));
        if (!(v > 0) || v > tolerance::largest_program_coordinate)
            throw Error(ErrorCode::out_of_range, at(key), format_number(v) + " is not above 0, or too large",
                        remedy);
        return v * scale;
    }
    Vec3 triple(const std::string& key, double scale, const std::string& remedy) {
        Vec3 v;
        numbers(key, v.data(), 3, remedy);
        return v * scale;
    }
    double sign(const std::string& key) {
        const double v = number(value(key, ""), at(key));
        if (v != 1 && v != -1)
            throw Error(ErrorCode::out_of_range, at(key), format_number(v) + " is no sign", "write 1 or -1");
        return v;
    }
    Travel travel(double scale) {
        if (!has("travel")) return {};
        double v[2];
        numbers("travel", v, 2, "write [lowest, highest], or leave it out for no limit");
        if (!(v[0] < v[1]))
            throw Error(ErrorCode::out_of_range, at("travel"),
                        "the limits " + format_number(v[0]) + " and " + format_number(v[1])
                            + " leave no travel",
                        "write the lower limit first");
        return {v[0] * scale, v[1] * scale};
    }
    double acceleration(double scale) {
        return has("acceleration")
                   ? positive("acceleration", scale, "write a number above 0, or leave it out")
                   : infinity;
    }
    void finish() const {
        for (auto it = object_.begin(); it != object_.end(); ++it)
            if (std::find(known_.begin(), known_.end(), it.key()) == known_.end())
                unknown_key(it.key(), place_, known_);
    }

private:
    static double number(const Json& v, const std::string& place) {
        if (!v.is_number()) wrong_type(place, v, "a number");
        const double d = v.get<double>();
        if (!std::isfinite(d) || std::abs(d) > tolerance::largest_program_coordinate)
            throw Error(ErrorCode::out_of_range, place, "the number is too large",
                        "write a number of ordinary size");
        return d;
    }
    void numbers(const std::string& key, double* to, std::size_t n, const std::string& remedy) {
        const Json& list = expect_list(value(key, remedy), at(key));
        if (list.size() != n)
            throw Error(ErrorCode::wrong_type, at(key),
                        "the list has " + std::to_string(list.size()) + " values",
                        "expected a list of " + std::to_string(n) + " numbers");
        for (std::size_t i = 0; i < n; ++i)
            to[i] = number(list[i], element(at(key), i));
    }

    const Json& object_;
    std::string place_;
    std::vector<std::string> known_;
};

bool parallel(const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() < tolerance::level_angle;
}

RotaryAxis read_rotary(Reader& r, double mm) {
    RotaryAxis axis;
    axis.name = std::string(1, char('A' + r.word("name", {"A", "B", "C"})));
    axis.carries =
        r.word("carries", {"tool", "table"}) == 0 ? RotaryAxis::Carries::tool : RotaryAxis::Carries::table;
    const Vec3 direction = r.triple("direction", 1, "write the direction of the rotation axis, as [1, 0, 0]");
    const double length = direction.norm();
    if (!(length > tolerance::level_angle))
        throw Error(ErrorCode::out_of_range, r.at("direction"), "the direction has no length",
                    "write the direction of the rotation axis, as [1, 0, 0]");
    axis.direction = direction / length;
    // A wrong name or direction would turn the machine about another axis than the program says.
    const int named = axis.name[0] - 'A';
    for (int k = 0; k < 3; ++k)
        if (k != named && parallel(axis.direction, Vec3::Unit(k)))
            throw Error(ErrorCode::out_of_range, r.at("direction"),
                        axis.name + " cannot turn about " + linear_names[k],
                        "A turns about X, B about Y, C about Z: mend the name or the direction");
    if (r.has("point")) axis.point = r.triple("point", mm, "write a point on the rotation axis");
    if (r.has("sign")) axis.sign = r.sign("sign");
    axis.travel = r.travel(radians(1));
    axis.speed = r.positive("speed", radians(1), "give the largest speed, in degrees per second");
    axis.acceleration = r.acceleration(radians(1));
    return axis;
}

/// Rotary axes that cannot do what they are for.
void check_chain(const Machine& m, const std::vector<std::string>& places) {
    const auto refuse = [&](std::size_t i, const std::string& what, const std::string& remedy) {
        throw Error(ErrorCode::out_of_range, places[i], what, remedy);
    };
    const auto& r = m.rotary;
    if (r.size() == 2 && r[0].name == r[1].name)
        refuse(1, "there are two axes " + r[0].name, "give every axis its own name");
    if (r.size() == 2 && parallel(r[0].direction, r[1].direction))
        refuse(1, "the rotary axes are parallel: together they turn no further than one of them",
               "check the directions");
    if (r.empty()) return;
    // The axis that turns next to the tool: the inner one of a head, the outer one of a table.
    const std::size_t next = r.size() == 2 && r[1].carries == RotaryAxis::Carries::tool ? 1 : 0;
    if (parallel(r[next].direction, Vec3::UnitZ()))
        refuse(next,
               r[next].name
                   + (r[next].carries == RotaryAxis::Carries::tool
                          ? " turns the tool about its own axis"
                          : " turns the part about the axis of the tool, which nothing inclines"),
               r.size() == 2 ? "list the axis that carries the other one first; check the directions"
                             : "leave it out, or check its direction");
}

Machine read_machine(const Json& json, std::string_view text) {
    Reader file(json, "");
    const Json& version = file.value("facetmill_machine", "write 1: the version of the file");
    if (!version.is_number_integer()) wrong_type("facetmill_machine", version, "the version, 1");
    if (version.get<double>() > double(newest_version))
        throw Error(ErrorCode::newer_version, "facetmill_machine", "the file is for a newer Facetmill",
                    "update Facetmill");
    if (version.get<double>() < 1)
        throw Error(ErrorCode::out_of_range, "facetmill_machine", "there is no such version", "write 1");
    Machine m;
    m.source = std::string(text);
    m.label = file.text("label", "name the machine as people call it");
    if (m.label.empty())
        throw Error(ErrorCode::out_of_range, "label", "the text is empty", "name the machine");
    if (file.has("description")) m.description = file.text("description", "");
    const double mm = mm_per(parse_length_unit(file.text("units", "write \"mm\" or \"in\""), "units"));

    const Json& axes =
        expect_list(file.value("axes", "list the axes: X, Y, Z and up to two rotary ones"), "axes");
    std::array<bool, 3> found{};
    std::vector<std::string> rotary_places;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        Reader r(axes[i], element("axes", i));
        if (r.word("kind", {"linear", "rotary"}) == 1) {
            if (m.rotary.size() == 2)
                throw Error(ErrorCode::out_of_range, element("axes", i),
                            "there are more than two rotary axes", "leave out those that are clamped");
            m.rotary.push_back(read_rotary(r, mm));
            rotary_places.push_back(element("axes", i));
        } else {
            const std::size_t k = r.word("name", {"X", "Y", "Z"});
            if (found[k])
                throw Error(ErrorCode::out_of_range, r.at("name"),
                            std::string("there are two axes ") + linear_names[k],
                            "give every axis its own name");
            found[k] = true;
            m.travel[k] = r.travel(mm);
            m.rapid_mm_per_s[int(k)] = r.positive("speed", mm, "give the largest speed, in units per second");
            m.acceleration_mm_per_s2[int(k)] = r.acceleration(mm);
        }
        r.finish();
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (!found[k])
            throw Error(ErrorCode::missing_key, "axes",
                        std::string("the axis ") + linear_names[k] + " is missing", "list X, Y and Z");
    check_chain(m, rotary_places);
    if (file.has("table")) {
        m.table = file.triple("table", mm, "write where the middle of the part's bottom stands");
    } else {
        for (int k = 0; k < 2; ++k)
            if (const Travel& t = m.travel[std::size_t(k)]; t.limited()) m.table[k] = 0.5 * (t.lo + t.hi);
        for (const RotaryAxis& axis : m.rotary)
            if (axis.carries == RotaryAxis::Carries::table && parallel(axis.direction, Vec3::UnitZ()))
                m.table.head<2>() = axis.point.head<2>();
    }
    file.finish();
    return m;
}

} // namespace

std::string Machine::axis_name(int joint) const {
    return joint < 3 ? linear_names[joint] : rotary.at(std::size_t(joint - 3)).name;
}
double Machine::speed(int joint) const {
    return joint < 3 ? rapid_mm_per_s[joint] : rotary.at(std::size_t(joint - 3)).speed;
}
double Machine::acceleration(int joint) const {
    return joint < 3 ? acceleration_mm_per_s2[joint] : rotary.at(std::size_t(joint - 3)).acceleration;
}
const Travel& Machine::joint_travel(int joint) const {
    return joint < 3 ? travel[std::size_t(joint)] : rotary.at(std::size_t(joint - 3)).travel;
}

std::string machine_kind(const Machine& machine) {
    const std::string kind = std::to_string(machine.joints()) + "-axis";
    std::string parts;
    for (const auto carries : {RotaryAxis::Carries::tool, RotaryAxis::Carries::table})
        for (const RotaryAxis& axis : machine.rotary)
            if (axis.carries == carries)
                parts += (parts.empty() ? "" : "-")
                         + std::string(carries == RotaryAxis::Carries::tool ? "head" : "table");
    return parts.empty() ? kind : kind + ", " + parts;
}

const std::vector<Machine>& machines() {
    static const auto all = built_in<Machine>(machine_files, parse_machine);
    return all;
}

const Machine& find_machine(std::string_view name) {
    return find_built_in(machines(), name, "machine");
}

bool is_machine_file(std::string_view name) {
    return name.ends_with(".json");
}

Machine parse_machine(std::string_view json, const std::string& file) {
    const Json root = parse_strict_json(json, file);
    try {
        return read_machine(root, json);
    } catch (const Error& e) {
        throw e.within(file);
    }
}

Machine load_machine(const std::filesystem::path& path) {
    return load_own<Machine>(path, parse_machine);
}

} // namespace facetmill
