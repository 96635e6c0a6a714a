// Hollow edges of a turning part, in which the cutter rolls from one facet to the other and leaves a fillet:
// where the fillet alone is more than is allowed, and where the side feed has to be shorter for what two
// turns leave on it. Millimetres, radians.
#pragma once

#include "core/mesh/edge_table.h"
#include "core/strategy/lathe/lathe_samples.h"

#include <array>
#include <span>

namespace facetmill {

/// What advances there are: along the axis in a turn, mm, or (lengthwise lines) between two lines, radians.
struct ReachFeed {
    bool across_turns = true;
    std::function<double(double)> advance;
};

class CreaseSearch {
public:
    /// All of it must outlive this.
    CreaseSearch(const ReachSampler& sampler, const LatheProbe& probe, const Mesh& mesh,
                 const ReachFeed& feed)
        : sampler_(sampler), probe_(probe), mesh_(mesh), feed_(feed) {}

    struct Found {
        std::vector<ReachSample> doubtful; ///< where the fillet is more than is allowed
        std::vector<FeedLimit> limits;     ///< where the fillet is less but the advance has to be shorter
        double cusp = 0;                   ///< largest height that the feed leaves at a crease
    };
    Found find(const Progress& progress) const;

private:
    /// An edge between two facets with these normals, towards the tool, that is hollow.
    struct Crease {
        std::array<Index, 2> ends;
        std::array<Vec3, 2> normal;
    };
    /// Creases filed under their ends: those that meet at a corner v are meeting[first[v]] to meeting[first[v
    /// + 1]].
    struct Corners {
        std::vector<Index> ends; ///< corners with creases
        std::vector<std::size_t> first, meeting;
    };

    std::vector<Crease> creases(const Progress& progress) const;
    void add_crease(Index low, const EdgeSide& side, const EdgeSide& other, double least,
                    std::vector<Crease>& creases) const;
    Corners corners_of(const std::vector<Crease>& creases, const Progress& progress) const;
    void along(const Crease& crease, LatheField::Hint& hint, Found& found, const Progress& progress) const;
    void hollow(const Vec3& p, std::span<const Vec3> normals, double length, LatheField::Hint& hint,
                Found& found, const Progress& progress) const;
    double left_by(double advance, const LathePlace& place, const Vec3& p, std::span<const Vec3> normals,
                   LatheField::Hint& hint) const;
    void limit_feed(const LathePlace& place, const Vec3& p, std::span<const Vec3> normals,
                    LatheField::Hint& hint, Found& found) const;
    void thin_out(std::vector<ReachSample>& samples) const;

    const ReachSampler& sampler_;
    const LatheProbe& probe_;
    const Mesh& mesh_;
    const ReachFeed& feed_;
};

} // namespace facetmill
