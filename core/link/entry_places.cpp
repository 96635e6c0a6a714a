#include "core/link/entry_places.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// How far from each other locations are remembered, in radii of the cutter, and how many are tried.
constexpr double place_spacing_share = 0.25;
constexpr int max_entry_tries = 8;
/// By how much the axis may turn from a place to where it leads: the bodies of the tool swing through what
/// stands there.
const double max_entry_turn = radians(45);
/// Places that are nearer to one that did not serve than so many spacings, and whose axis is as near, will
/// not serve either.
constexpr double beside = 4;
const double beside_turn = radians(10);
/// Where something stood behind a place it is asked about again when so many more have been cut: they may
/// have taken it away.
constexpr std::size_t asked_again_after = 200;

} // namespace

EntryPlaces::EntryPlaces(const TiltedStock& stock, const Tool& tool, double cutter_radius, double off)
    : stock_(stock), flute_length_(tool.flute_length), spacing_(place_spacing_share * cutter_radius),
      off_(off) {}

void EntryPlaces::add(const CutterLocation& at) {
    if (!places_.empty() && (places_.back().at.tip - at.tip).norm() < spacing_
        && places_.back().at.axis.dot(at.axis) > std::cos(beside_turn))
        return;
    places_.push_back({at});
}

bool EntryPlaces::is_free(Place& place) const {
    if (place.free || !asks_again(place)) return place.free;
    place.asked = places_.size();
    place.free = stock_.free_behind(place.at);
    return place.free;
}

bool EntryPlaces::asks_again(const Place& place) const {
    return place.asked == Place::never || places_.size() >= place.asked + asked_again_after;
}

bool EntryPlaces::find(const CutterLocation& to, double within,
                       const std::function<bool(const CutterLocation&)>& reaches, const Progress& progress) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const CutterLocation& at = places_[i].at;
        const double far = (at.tip + off_ * at.axis - to.tip).norm();
        if (!(places_[i].free || asks_again(places_[i])) || !(far < within)) continue;
        const double turn = std::atan2(at.axis.cross(to.axis).norm(), at.axis.dot(to.axis));
        const double length = far + 0.5 * flute_length_ * turn;
        if (turn <= max_entry_turn && length < within) near.emplace_back(length, i);
    }
    std::sort(near.begin(), near.end());
    std::vector<const CutterLocation*> tried;
    for (const auto& [length, i] : near) {
        progress.check();
        const CutterLocation& at = places_[i].at;
        if (std::any_of(tried.begin(), tried.end(),
                        [&](const CutterLocation* t) {
                            return (t->tip - at.tip).norm() < beside * spacing_
                                   && t->axis.dot(at.axis) > std::cos(beside_turn);
                        })
            || !is_free(places_[i]))
            continue;
        if (reaches({at.tip + off_ * at.axis, at.axis})) return true;
        tried.push_back(&at);
        if (int(tried.size()) == max_entry_tries) break;
    }
    return false;
}

} // namespace facetmill
