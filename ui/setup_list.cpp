#include "ui/setup_list.h"

#include "ui/text.h"
#include "ui/worded.h"

#include <algorithm>

namespace facetmill::ui {

namespace {

/// "Setup 2" in the language of the window: from then on it is the user's.
std::string spoken_setup_name(std::size_t place) {
    return utf8(worded(usual_setup_name(place)));
}

/// The only setup of a project has its first name, which nobody sees until there is another one.
void speak_only_name(std::vector<Setup>& setups) {
    if (setups.size() == 1 && setups[0].name == usual_setup_name(0)) setups[0].name = spoken_setup_name(0);
}

/// Behind those of all setups, so that no program is written over another one on a control that numbers them.
long free_program_number(const Project& project) {
    long number = 1;
    for (std::size_t k = 0; k < setup_count(project); ++k) {
        const Setup& setup = setup_at(project, k);
        number = std::max(number, setup.programs.number + std::max(1L, long(setup.operations.size())));
    }
    return number;
}

} // namespace

void choose_setup(Document& document, std::size_t i) {
    const Project& project = document.project();
    if (i == chosen_setup(project)) return;
    document.change(Document::tr("Go to setup “%1”").arg(text(setup_at(project, i).name)),
                    [i](Project& p) { facetmill::choose_setup(p, i); });
}

void add_setup(Document& document, NewSetup how) {
    const Project& project = document.project();
    if (!document.part_is_current()) return;
    const std::size_t at = chosen_setup(project) + 1;
    Setup setup;
    setup.name = free_setup_name(project, spoken_setup_name(setup_count(project)));
    setup.machine = project.machine;
    setup.programs = project.programs;
    setup.stock.kind = StockSpec::Kind::rest;
    setup.stock.unit = project.stock.unit;
    setup.place = project.place;
    setup.programs.number = free_program_number(project);
    if (how != NewSetup::as_it_lies)
        setup.place = place_of(flip_about(how == NewSetup::flipped_about_x ? 0 : 1, document.part()->box)
                                   .after(frame_of(project.place)));
    document.change_setups(Document::tr("Add setup"), at, [&](auto& setups, auto& ids) {
        speak_only_name(setups);
        setups.insert(setups.begin() + std::ptrdiff_t(at), std::move(setup));
        ids.insert(ids.begin() + std::ptrdiff_t(at), std::vector<int>());
    });
}

void duplicate_setup(Document& document, std::size_t i) {
    const Project& project = document.project();
    Setup copy = setup_at(project, i);
    const bool unnamed = setup_count(project) == 1 && copy.name == usual_setup_name(0);
    copy.name = unnamed ? spoken_setup_name(1) : free_setup_name(project, copy.name);
    copy.programs.number = free_program_number(project);
    std::vector<int> own;
    Project named = project; // takes the new names one by one
    for (auto& operation : copy.operations) {
        operation->common().name = facetmill::free_operation_name(named, operation->common().name);
        named.operations.push_back(operation->clone());
        own.push_back(document.new_id());
    }
    document.change_setups(Document::tr("Duplicate setup"), i + 1, [&](auto& setups, auto& ids) {
        speak_only_name(setups);
        setups.insert(setups.begin() + std::ptrdiff_t(i) + 1, std::move(copy));
        ids.insert(ids.begin() + std::ptrdiff_t(i) + 1, std::move(own));
    });
}

void remove_setup(Document& document, std::size_t i) {
    const Project& project = document.project();
    const std::size_t n = setup_count(project);
    if (n == 1)
        throw Error(ErrorCode::missing_reference, "setup '" + project.name + "'",
                    "a project has one setup at least", "remove its operations instead");
    std::size_t chosen = chosen_setup(project);
    if (i < chosen || chosen + 1 == n) --chosen;
    document.change_setups(Document::tr("Remove setup"), chosen, [&](auto& setups, auto& ids) {
        setups.erase(setups.begin() + std::ptrdiff_t(i));
        ids.erase(ids.begin() + std::ptrdiff_t(i));
    });
}

void move_setup(Document& document, std::size_t i, int by) {
    const Project& project = document.project();
    const auto j = std::ptrdiff_t(i) + by;
    if (j < 0 || j >= std::ptrdiff_t(setup_count(project))) return;
    std::size_t chosen = chosen_setup(project);
    if (chosen == i)
        chosen = std::size_t(j);
    else if (chosen == std::size_t(j))
        chosen = i;
    document.change_setups(Document::tr("Move setup"), chosen, [&](auto& setups, auto& ids) {
        std::swap(setups[i], setups[std::size_t(j)]);
        std::swap(ids[i], ids[std::size_t(j)]);
    });
}

} // namespace facetmill::ui
