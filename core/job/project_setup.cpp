#include "core/job/project_setup.h"

#include "core/job/project.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace facetmill {

namespace {

/// Entries of a turn within this of 0, 1 or -1 are these: no angle that can be written has others.
constexpr double same_entry = 1e-14;

} // namespace

const ParameterTable<SetupPlace>& place_parameters() {
    static const auto table = [] {
        ParameterTable<SetupPlace> t;
        t.add(&SetupPlace::rotate, rotate_parameter("Turns the part, as `part` places it, about X, then Y, "
                                                    "then Z (fixed axes) into this setup."));
        t.add(&SetupPlace::translate, translate_parameter("Moves it after it was turned."));
        return t;
    }();
    return table;
}

std::string usual_setup_name(std::size_t place) {
    return "Setup " + std::to_string(place + 1);
}

Setup::Setup(const Setup& other)
    : name(other.name), place(other.place), stock(other.stock), fixtures(other.fixtures),
      boundaries(other.boundaries), machine(other.machine), programs(other.programs) {
    operations.reserve(other.operations.size());
    for (const auto& o : other.operations)
        operations.push_back(o->clone());
}

Setup& Setup::operator=(const Setup& other) {
    if (this != &other) *this = Setup(other);
    return *this;
}

std::size_t setup_count(const Project& project) {
    return project.before.size() + 1 + project.after.size();
}

std::size_t chosen_setup(const Project& project) {
    return project.before.size();
}

const Setup& setup_at(const Project& project, std::size_t i) {
    const std::size_t chosen = chosen_setup(project);
    if (i == chosen) return project;
    return i < chosen ? project.before[i] : project.after.at(i - chosen - 1);
}

Setup& setup_at(Project& project, std::size_t i) {
    return const_cast<Setup&>(setup_at(std::as_const(project), i));
}

void choose_setup(Project& project, std::size_t i) {
    if (i >= setup_count(project))
        throw Error(ErrorCode::internal, "setups", "there is no setup " + std::to_string(i), "report this");
    Setup& chosen = project;
    while (chosen_setup(project) > i) {
        project.after.insert(project.after.begin(), std::move(chosen));
        chosen = std::move(project.before.back());
        project.before.pop_back();
    }
    while (chosen_setup(project) < i) {
        project.before.push_back(std::move(chosen));
        chosen = std::move(project.after.front());
        project.after.erase(project.after.begin());
    }
}

Project view_of_setup(const Project& project, std::size_t i) {
    Project view = project;
    choose_setup(view, i);
    return view;
}

std::size_t find_setup(const Project& project, const std::string& name) {
    std::vector<std::string> names;
    std::string list;
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        names.push_back(setup_at(project, i).name);
        if (names.back() == name) return i;
        list += (i > 0 ? ", " : "") + printable(names.back());
    }
    const std::string near = nearest_name(name, names);
    throw Error(ErrorCode::missing_reference, "setups", "there is no setup '" + printable(name) + "'",
                near.empty() ? "setups there are: " + list : "did you mean '" + printable(near) + "'?");
}

std::size_t setup_of_operation(const Project& project, const std::string& operation) {
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const auto& o : setup_at(project, i).operations)
            if (o->common().name == operation) return i;
    return chosen_setup(project);
}

std::vector<Operation*> all_operations(Project& project) {
    std::vector<Operation*> all;
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const auto& o : setup_at(project, i).operations)
            all.push_back(o.get());
    return all;
}

std::vector<const Operation*> all_operations(const Project& project) {
    std::vector<const Operation*> all;
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const auto& o : setup_at(project, i).operations)
            all.push_back(o.get());
    return all;
}

std::vector<const Operation*> operations_on(const Setup& setup) {
    std::vector<const Operation*> on;
    for (const auto& o : setup.operations)
        if (!o->common().off) on.push_back(o.get());
    return on;
}

std::size_t operations_before(const Project& project) {
    std::size_t n = 0;
    for (const Setup& setup : project.before)
        n += setup.operations.size();
    return n;
}

std::string free_operation_name(const Project& project, const std::string& wish) {
    const std::vector<const Operation*> all = all_operations(project);
    return free_name(wish, [&](const std::string& name) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Operation* o) { return o->common().name == name; });
    });
}

std::string free_setup_name(const Project& project, const std::string& wish) {
    return free_name(wish, [&](const std::string& name) {
        for (std::size_t i = 0; i < setup_count(project); ++i)
            if (setup_at(project, i).name == name) return true;
        return false;
    });
}

std::vector<Setup> take_setups(Project& project) {
    std::vector<Setup> all = std::move(project.before);
    all.push_back(std::move(static_cast<Setup&>(project)));
    std::move(project.after.begin(), project.after.end(), std::back_inserter(all));
    project.before.clear();
    project.after.clear();
    return all;
}

void put_setups(Project& project, std::vector<Setup> setups, std::size_t chosen) {
    if (setups.at(0).stock.kind == StockSpec::Kind::rest)
        throw Error(ErrorCode::missing_reference, "setup '" + printable(setups[0].name) + "'",
                    "it goes on with what the setup before it leaves, and would be the first",
                    "give it a stock of its own before");
    static_cast<Setup&>(project) = std::move(setups[0]);
    project.before.clear();
    project.after.assign(std::make_move_iterator(setups.begin() + 1), std::make_move_iterator(setups.end()));
    choose_setup(project, chosen);
}

Mat3 exact_turn(const Mat3& turn) {
    const Mat3 whole = turn.unaryExpr([](double v) { return std::round(v) + 0.0; });
    return (turn - whole).cwiseAbs().maxCoeff() <= same_entry ? whole : turn;
}

SetupFrame frame_of(const SetupPlace& place) {
    return {exact_turn(rotation_of(place.rotate)),
            Vec3(place.translate[0], place.translate[1], place.translate[2])};
}

SetupFrame flip_about(int axis, const Box3& box) {
    Vec3 signs = -Vec3::Ones();
    signs[axis] = 1;
    const Vec3 middle = box.center();
    return {signs.asDiagonal(), middle - signs.cwiseProduct(middle)};
}

void lay_part(Project& project, const Placement& placement) {
    PartSpec& part = project.part;
    if (setup_count(project) == 1 && project.place == SetupPlace()) {
        part.mirror = placement.mirror;
        part.rotate = placement.rotate;
        part.translate = placement.translate;
        return;
    }
    if (placement.mirror != part.mirror)
        throw Error(ErrorCode::out_of_range, "place",
                    "a setup turns and moves the part, and cannot mirror it",
                    "mirror the part itself, which all setups have");
    const auto frame = [](const Placement& p) { return frame_of({p.rotate, p.translate}); };
    project.place = place_of(frame(placement).after(frame(placement_of(part)).inverse()));
}

SetupPlace place_of(const SetupFrame& frame) {
    const Placement placed = moved({Mirror::none, angles_of(frame.turn), {0, 0, 0}}, frame.move);
    return {placed.rotate, placed.translate};
}

} // namespace facetmill
