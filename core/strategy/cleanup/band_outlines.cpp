#include "core/strategy/cleanup/band_outlines.h"

#include "core/mesh/index_pair.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace facetmill {

namespace {

constexpr std::size_t edges_per_check = 2048;
/// Two bands that meet on an edge each get this share of it at least.
constexpr double min_part = 0.02;

class BandCutter {
public:
    BandCutter(const ValleyInput& input, const Valleys& valleys, RestFacets rest, const RestGaps& gaps,
               const RestOwners& owners)
        : in_(input), valleys_(valleys), facets_(std::move(rest.facets)), gaps_(gaps), owners_(owners),
          edges_(std::size_t(owners.count)) {
        out_.bands.resize(std::size_t(owners.count));
        out_.points = std::move(rest.points);
        beside_of_.assign(out_.points.size(), -1);
    }

    OutlinedBands run(const Progress& progress) {
        for (std::size_t i = 0; i < facets_.size(); ++i) {
            if (i % edges_per_check == 0) progress.check();
            if (owners_.of[i] >= 0) cut(facets_[i], owners_.of[i]);
        }
        facets_ = {};
        beside_of_ = {};
        order_points();
        out_.band_points.shrink_to_fit();
        fill_bands(progress);
        for (std::size_t i = 0; i < out_.bands.size(); ++i) {
            progress.check();
            RestBand& band = out_.bands[i];
            band.curve = i < valleys_.curves.size() ? int(i) : -1;
            band.boundaries = boundaries(edges_[i]);
            // Bands are most of what is kept until all passes are there.
            band.beside.shrink_to_fit();
        }
        return std::move(out_);
    }

private:
    /// What of a facet is in bands: its points in order, and whose they are.
    struct Outline {
        std::vector<Index> points;
        std::vector<int> owner;
        std::size_t before(std::size_t k) const { return (k + points.size() - 1) % points.size(); }
    };

    void cut(const RestFacet& facet, int owner) {
        const Outline outline = outline_of(facet, owner);
        const std::vector<std::size_t> first = first_points(outline);
        if (first.empty())
            add(outline.points, outline.owner.front());
        else
            divide(outline, first);
    }

    Outline outline_of(const RestFacet& facet, int facet_owner) {
        Outline outline;
        const auto owner_of = [&](Index c) { return gaps_.curve[c] >= 0 ? gaps_.curve[c] : facet_owner; };
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = facet.corner[k], b = facet.corner[(k + 1) % 3];
            const bool in_a = gaps_.gap[a] > in_.tolerance, in_b = gaps_.gap[b] > in_.tolerance;
            // Once will do for all facets that meet there.
            if (!in_a && std::exchange(beside_of_[a], facet_owner) != facet_owner) {
                const Vec3 n = in_.side->towards_tool(in_.mesh->facet_normal(facet.facet));
                out_.bands[std::size_t(facet_owner)].beside.push_back({out_.points[a], n});
            }
            if (in_a) {
                outline.points.push_back(a);
                outline.owner.push_back(owner_of(a));
                RestBand& band = out_.bands[std::size_t(owner_of(a))];
                band.depth = std::max(band.depth, gaps_.gap[a]);
            }
            if (in_a != in_b) {
                outline.points.push_back(crossing(a, b));
                outline.owner.push_back(owner_of(in_a ? a : b));
            }
        }
        return outline;
    }

    /// The first of the points of each owner; none where there is one owner.
    static std::vector<std::size_t> first_points(const Outline& outline) {
        std::vector<std::size_t> first;
        for (std::size_t k = 0; k < outline.points.size(); ++k)
            if (outline.owner[k] != outline.owner[outline.before(k)]) first.push_back(k);
        return first;
    }

    /// Where bands meet it is divided among them, where three do about its middle.
    void divide(const Outline& outline, const std::vector<std::size_t>& first) {
        const std::size_t n = outline.points.size();
        Index middle = no_index;
        if (first.size() > 2) {
            Vec3 sum = Vec3::Zero();
            double left = 0;
            for (const Index p : outline.points) {
                sum += out_.points[p];
                left += left_at(p);
            }
            middle = make(sum / double(n), left / double(n));
        }
        const auto border_before = [&](std::size_t k) {
            const std::size_t last = outline.before(k);
            return border(outline.points[last], outline.owner[last], outline.points[k], outline.owner[k]);
        };
        for (std::size_t j = 0; j < first.size(); ++j) {
            const std::size_t from = first[j], to = first[(j + 1) % first.size()];
            std::vector<Index> part{border_before(from)};
            for (std::size_t k = from; k != to; k = (k + 1) % n)
                part.push_back(outline.points[k]);
            part.push_back(border_before(to));
            if (middle != no_index) part.push_back(middle);
            add(part, outline.owner[from]);
        }
    }

    /// A polygon goes to a band.
    void add(const std::vector<Index>& part, int owner) {
        auto& edges = edges_[std::size_t(owner)];
        for (std::size_t k = 0; k < part.size(); ++k) {
            const Index a = part[k], b = part[(k + 1) % part.size()];
            if (a == b) continue;
            // An edge that another facet runs along the other way is inside.
            if (const auto twin = edges.find(directed_pair(b, a)); twin != edges.end()) {
                if (--twin->second == 0) edges.erase(twin);
            } else {
                ++edges[directed_pair(a, b)];
            }
            // Every point comes with all facets about it.
            if (out_.band_points.size() == points_at_once_) {
                order_points();
                points_at_once_ = std::max(points_at_once_, 2 * out_.band_points.size());
            }
            out_.band_points.push_back({Index(owner), a});
        }
        for (std::size_t k = 2; k < part.size(); ++k)
            pieces_.push_back({Index(owner), {part[0], part[k - 1], part[k]}});
    }

    /// None twice.
    void order_points() {
        auto& at = out_.band_points;
        std::sort(at.begin(), at.end());
        at.erase(std::unique(at.begin(), at.end()), at.end());
    }

    /// Once it is known how many triangles each has.
    void fill_bands(const Progress& progress) {
        std::vector<std::size_t> count(out_.bands.size(), 0);
        for (const Piece& piece : pieces_)
            ++count[piece.owner];
        for (std::size_t i = 0; i < count.size(); ++i) {
            out_.bands[i].band.reserve(count[i]);
            out_.bands[i].left.reserve(count[i]);
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (i % edges_per_check == 0) progress.check();
            const auto& [p, q, r] = pieces_[i].corner;
            const Vec3 &a = out_.points[p], &b = out_.points[q], &c = out_.points[r];
            RestBand& band = out_.bands[pieces_[i].owner];
            band.band.push_back({a, b, c});
            band.left.push_back({float(left_at(p)), float(left_at(q)), float(left_at(r))});
            band.area += 0.5 * (b - a).cross(c - a).norm();
        }
        pieces_ = {};
    }

    double left_at(Index p) const {
        return p < gaps_.gap.size() ? gaps_.gap[p] : made_[p - gaps_.gap.size()];
    }
    /// A point that cutting out makes, and how much is left there.
    Index make(const Vec3& p, double left) {
        out_.points.push_back(p);
        made_.push_back(left);
        return Index(out_.points.size() - 1);
    }

    /// Where the gap is the tolerance on the edge between two points.
    Index crossing(Index a, Index b) {
        auto& points = out_.points;
        const auto [found, is_new] = crossings_.try_emplace(pair_of(a, b), Index(points.size()));
        if (is_new) {
            const Index lo = std::min(a, b), hi = std::max(a, b);
            const double at_lo = gaps_.gap[lo], at_hi = gaps_.gap[hi];
            const double t = std::clamp((in_.tolerance - at_lo) / (at_hi - at_lo), 0.0, 1.0);
            make(points[lo] + t * (points[hi] - points[lo]), in_.tolerance);
        }
        return found->second;
    }

    /// Where the centres of two points' curves are equally far on the edge between them.
    Index border(Index a, int owner_a, Index b, int owner_b) {
        auto& points = out_.points;
        const auto [found, is_new] = borders_.try_emplace(pair_of(a, b), Index(points.size()));
        if (is_new) {
            const auto from_center = [&](Index c, int owner) {
                return std::sqrt(square_from_centers(points[c], valleys_.curves[std::size_t(owner)]));
            };
            const auto nearer = [&](Index c, int mine, int others) {
                return from_center(c, others) - from_center(c, mine);
            };
            const double at_a = std::max(nearer(a, owner_a, owner_b), 0.0),
                         at_b = std::max(nearer(b, owner_b, owner_a), 0.0);
            const double between = at_a + at_b > 0 ? at_a / (at_a + at_b) : 0.5,
                         t = std::clamp(between, min_part, 1 - min_part);
            make(points[a] + t * (points[b] - points[a]), (1 - t) * left_at(a) + t * left_at(b));
        }
        return found->second;
    }

    using Edges = std::unordered_map<std::uint64_t, int>; ///< directed, with how often they come

    std::vector<std::vector<Vec3>> boundaries(const Edges& edges) const {
        std::vector<std::pair<std::uint64_t, int>> ordered(edges.begin(), edges.end());
        std::sort(ordered.begin(), ordered.end());
        std::multimap<Index, Index> next;
        for (const auto& [edge, count] : ordered)
            for (int k = 0; k < count; ++k)
                next.emplace(Index(edge >> 32), Index(edge & 0xFFFFFFFFu));
        std::vector<std::vector<Vec3>> loops;
        while (!next.empty()) {
            std::vector<Vec3> loop;
            auto edge = next.begin();
            const Index first = edge->first;
            Index at = first;
            do {
                edge = next.find(at);
                if (edge == next.end()) break;
                loop.push_back(out_.points[at]);
                at = edge->second;
                next.erase(edge);
            } while (at != first);
            if (loop.size() > 2) loops.push_back(std::move(loop));
        }
        return loops;
    }

    const ValleyInput& in_;
    const Valleys& valleys_;
    std::vector<RestFacet> facets_;
    const RestGaps& gaps_;
    const RestOwners& owners_;
    std::vector<int> beside_of_; ///< by points: the last band beside which it was found
    /// A triangle of a band.
    struct Piece {
        Index owner;
        std::array<Index, 3> corner;
    };
    std::vector<Piece> pieces_;
    std::vector<Edges> edges_; ///< those of each band that no other facet runs along
    std::unordered_map<std::uint64_t, Index> crossings_, borders_;
    std::size_t points_at_once_ = 65536; ///< of bands, until they are ordered
    std::vector<double> made_;           ///< what is left at points that cutting out made
    OutlinedBands out_;
};

} // namespace

OutlinedBands cut_out(const ValleyInput& input, const Valleys& valleys, RestFacets rest, const RestGaps& gaps,
                      const RestOwners& owners, const Progress& progress) {
    return BandCutter(input, valleys, std::move(rest), gaps, owners).run(progress);
}

} // namespace facetmill
