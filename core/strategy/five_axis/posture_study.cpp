#include "core/strategy/five_axis/posture_study.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/cspace/between_nodes.h"

#include <algorithm>
#include <array>

namespace facetmill {

namespace {
/// Places that a thread takes at a time.
constexpr std::size_t studied_per_block = 8;
/// What is asked for of strips that no posture clears, one after the other.
constexpr std::array strip_shares{0.5, 0.0};

/// A lead and yaw, lifted as little as cuts nothing, if that is free.
std::optional<PostureValue> free_posture(const FiveAxisField& field, const ContactPlace& place,
                                         const std::optional<std::array<double, 2>>& angles,
                                         const std::vector<RaisedCurve>& curves) {
    if (!angles) return std::nullopt;
    const auto [lead, yaw] = *angles;
    ToolLift::Hint hint;
    const double bottom = field.builder().bottom(place.frame, lead, yaw, hint);
    if (!(bottom <= field.builder().top(place.frame, lead, yaw, curves)) || !(bottom < infinity))
        return std::nullopt;
    const PostureValue posture{lead, yaw, bottom};
    if (!field.builder().holds(place.frame, posture)) return std::nullopt;
    return posture;
}

bool has_free_node(const CSpace& space) {
    return std::find(space.block.begin(), space.block.end(), PostureBlock::free) != space.block.end();
}

/// A strip, and what is known of the postures that clear it.
struct StudiedStrip {
    std::vector<RaisedCurve>& curves;
    CSpace& space;
    std::vector<PostureValue>& between;
    char& narrowed;
};

/// Where no posture on the grid clears a strip, postures between its nodes are looked for; where the strip is
/// wider than was estimated, what lies under the pass itself need not stay.
void find_room(const FiveAxisField& field, ContactPlace& place, const StudiedStrip& strip,
               const Progress& progress) {
    // A posture kept by hand that is free here is taken; one that is not changes nothing.
    if (has_free_node(strip.space) || free_posture(field, place, place.kept, strip.curves)) return;
    const bool looks_between = field.settings().posture == Finish5Settings::PostureChoice::global;
    // Leads of a degree or less, by which a flat end clears wide strips of what is hardly bent, lie between
    // the nodes of most grids.
    const auto as_estimated = [&](const ContactPlace& at, const std::vector<RaisedCurve>& curves) {
        if (const auto posture = free_posture(field, at, at.estimated, curves)) strip.between = {*posture};
        return !strip.between.empty();
    };
    if (looks_between && !strip.curves.empty() && !as_estimated(place, strip.curves))
        strip.between = free_between_nodes(field.builder(), strip.space, strip.curves);
    if (!strip.between.empty() || place.v_lo == place.v_hi) return;
    for (const double share : strip_shares) {
        ContactPlace narrow = place;
        narrow.v_lo = place.v + share * (place.v_lo - place.v);
        narrow.v_hi = place.v + share * (place.v_hi - place.v);
        std::vector<RaisedCurve> fewer = field.strip_curves(narrow);
        if (fewer.empty()) continue; // nothing to clear would be cleared by a tool far above the part
        CSpace other = field.builder().build(narrow.frame, fewer, progress);
        if (!has_free_node(other)) {
            if (!looks_between) continue;
            if (!as_estimated(narrow, fewer)) {
                // Of half a strip the grid has to know: its own line asks for less.
                if (share > 0) continue;
                strip.between = free_between_nodes(field.builder(), other, fewer);
                if (strip.between.empty()) continue;
            }
        }
        place = narrow;
        strip.curves = std::move(fewer);
        strip.space = std::move(other);
        strip.narrowed = 1;
        return;
    }
}

} // namespace

PostureStudy study_postures(const FiveAxisField& field, std::vector<ContactPlace>& places,
                            const Progress& progress) {
    PostureStudy study;
    study.curves.resize(places.size());
    parallel_for(places.size(), studied_per_block, progress.part(0, 0),
                 [&](std::size_t i) { study.curves[i] = field.strip_curves(places[i]); });
    std::vector<ContactFrame> frames;
    frames.reserve(places.size());
    for (const ContactPlace& p : places)
        frames.push_back(p.frame);
    study.spaces = field.builder().build(frames, study.curves, progress.part(0, 0), &study.stages);
    study.narrowed.assign(places.size(), 0);
    std::vector<std::vector<PostureValue>> between(places.size());
    parallel_for(places.size(), 1, progress.part(0, 0), [&](std::size_t i) {
        find_room(field, places[i], {study.curves[i], study.spaces[i], between[i], study.narrowed[i]},
                  progress.part(0, 0));
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        PassPoint point;
        point.frame = places[i].frame;
        point.space = &study.spaces[i];
        point.curves = &study.curves[i];
        point.cm2_lead = field.cm2_lead(places[i]);
        point.kept = free_posture(field, places[i], places[i].kept, study.curves[i]);
        point.between = std::move(between[i]);
        study.points.push_back(std::move(point));
    }
    return study;
}

std::vector<ChosenPosture> choose_postures(const FiveAxisField& field, const PostureStudy& study,
                                           Finish5Settings::PostureChoice method,
                                           const std::optional<ToolPose>& before,
                                           std::span<const PassPoint> next, const Progress& progress) {
    ChooseInput input;
    input.builder = &field.builder();
    input.feed = field.settings().feed / 60;
    input.before = before;
    input.next = next;
    input.accelerations = field.settings().accelerations;
    input.room = field.settings().room_chords * field.chord();
    input.turn_limit = field.settings().turn_limit;
    using Method = Finish5Settings::PostureChoice;
    switch (method) {
    case Method::cm2:
        return choose_cm2(study.points, input, progress);
    case Method::local:
        return choose_local(study.points, input, progress);
    case Method::global:
        break;
    }
    return choose_global(study.points, input, progress);
}

} // namespace facetmill
