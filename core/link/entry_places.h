// Where a tool of five axes goes in to the part through what it has cut itself. Millimetres, part
// coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/setup/motion.h"
#include "core/strategy/tilt/tilted_stock.h"

#include <functional>
#include <vector>

namespace facetmill {

/// Locations at which the tool has cut, and along whose axes it may go in and out in rapids because nothing
/// stands behind it there.
class EntryPlaces {
public:
    /// `off`: how far along its axis from such a location a rapid ends.
    EntryPlaces(const TiltedStock& stock, const Tool& tool, double cutter_radius, double off);

    /// The tool has cut here.
    void add(const CutterLocation& at);
    /// Calls `reaches` with places, each off its location, until it returns true: in the order of the length
    /// of a motion from there to `to`, in which turns count with what the middle of the flutes moves. Only
    /// those nearer than `within`, and no more than a few: one beside another that did not serve is left out.
    bool find(const CutterLocation& to, double within,
              const std::function<bool(const CutterLocation&)>& reaches, const Progress& progress);

private:
    struct Place {
        CutterLocation at;
        bool free = false;         ///< what is free stays so
        std::size_t asked = never; ///< when: so many places had been cut
        static constexpr std::size_t never = std::size_t(-1);
    };
    bool is_free(Place& place) const;
    bool asks_again(const Place& place) const;

    const TiltedStock& stock_;
    double flute_length_, spacing_, off_;
    std::vector<Place> places_;
};

} // namespace facetmill
