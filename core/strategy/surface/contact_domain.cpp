#include "core/strategy/surface/contact_domain.h"

#include "core/base/large_pages.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <limits>

namespace facetmill {

namespace {

constexpr std::size_t pairs_per_check = 8192;
/// A fan with more facets than this is represented by its outermost moves in sixteen directions.
constexpr std::size_t large_fan = 16;
/// Facets that one thread looks at at a time.
constexpr std::size_t facets_per_block = 4096;
/// Facets that wait for another to cover them.
constexpr std::size_t max_waiting = 16;

} // namespace

std::vector<Interval> joined(std::vector<Interval> intervals, double merge) {
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.lo != b.lo ? a.lo < b.lo : a.hi < b.hi; });
    std::vector<Interval> result;
    for (const Interval& i : intervals) {
        if (!result.empty() && i.lo <= result.back().hi + merge)
            result.back().hi = std::max(result.back().hi, i.hi);
        else
            result.push_back(i);
    }
    return result;
}

/// How far each facet is moved, and the facets around each vertex: between their moves the cutter rolls.
class ContactDomain::Fans {
public:
    using Move = std::array<float, 2>; ///< (u, v); NaN: the facet asks for nothing

    Fans(const Mesh& mesh, LargeVector<Move> moves, const Progress& progress)
        : mesh_(mesh), moves_(std::move(moves)), start_(mesh.vertices.size() + 1, 0) {
        for (std::size_t f = 0; f < moves_.size(); ++f) {
            check(f, progress);
            if (!asks(f)) continue;
            for (const Index v : mesh_.facets[f])
                ++start_[v + 1];
        }
        join(progress);
    }

    bool asks(std::size_t facet) const { return moves_[facet][0] == moves_[facet][0]; }
    /// visit(u, v) for all places, from the facet's first vertex, that it asks for at its corners.
    template <class Visit>
    void each_corner(std::size_t facet, const DriveFrame& frame, Visit&& visit) const {
        const Move& own = moves_[facet];
        const Vec3& origin = mesh_.corner(facet, 0);
        for (const Index vertex : mesh_.facets[facet]) {
            const Vec3 p = mesh_.vertices[vertex] - origin;
            const double u = frame.u(p), v = frame.v(p);
            visit(u + own[0], v + own[1]);
            for (std::uint32_t i = start_[vertex]; i < start_[vertex + 1]; ++i) {
                const std::uint32_t f = fan_[i];
                if (f == no_index) break;
                const Move& move = moves_[f];
                if (move != own) visit(u + move[0], v + move[1]);
            }
        }
    }

    /// The least and the largest move around each vertex.
    struct Reach {
        Move lo{infinity_, infinity_}, hi{-infinity_, -infinity_};
        void add(const Move& move) {
            for (std::size_t k = 0; k < 2; ++k) {
                lo[k] = std::min(lo[k], move[k]);
                hi[k] = std::max(hi[k], move[k]);
            }
        }
    };
    LargeVector<Reach> reaches(const Progress& progress) const {
        LargeVector<Reach> reaches(mesh_.vertices.size());
        for (std::size_t f = 0; f < moves_.size(); ++f) {
            check(f, progress);
            if (!asks(f)) continue;
            for (const Index v : mesh_.facets[f])
                reaches[v].add(moves_[f]);
        }
        return reaches;
    }

private:
    static constexpr float infinity_ = std::numeric_limits<float>::infinity();

    static void check(std::size_t i, const Progress& progress) {
        if (i % pairs_per_check == 0) progress.check();
    }
    void join(const Progress& progress) {
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            check(v, progress);
            start_[v + 1] += start_[v];
        }
        fan_.resize(start_.back());
        LargeVector<std::uint32_t> next(start_.begin(), start_.end() - 1);
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            check(f, progress);
            if (!asks(f)) continue;
            for (const Index v : mesh_.facets[f])
                fan_[next[v]++] = std::uint32_t(f);
        }
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            check(v, progress);
            if (start_[v + 1] - start_[v] > large_fan) thin(start_[v], start_[v + 1]);
        }
    }
    /// Only the outermost moves of a large fan count; they are put first and the rest is cut off by an end
    /// marker, so that the facets of a fan do not each look at all the others.
    void thin(std::uint32_t from, std::uint32_t to) {
        std::vector<std::uint32_t> outermost;
        for (int k = 0; k < 16; ++k) {
            const double a = k * pi / 8, c = std::cos(a), s = std::sin(a);
            std::uint32_t best = fan_[from];
            for (std::uint32_t i = from; i < to; ++i) {
                const auto &o = moves_[fan_[i]], &b = moves_[best];
                if (c * o[0] + s * o[1] > c * b[0] + s * b[1]) best = fan_[i];
            }
            outermost.push_back(best);
        }
        std::sort(outermost.begin(), outermost.end());
        outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
        std::copy(outermost.begin(), outermost.end(), fan_.begin() + from);
        std::fill(fan_.begin() + from + std::ptrdiff_t(outermost.size()), fan_.begin() + to, no_index);
    }

    const Mesh& mesh_;
    LargeVector<Move> moves_;                ///< per facet
    LargeVector<std::uint32_t> start_, fan_; ///< facets around each vertex
};

namespace {

/// Turns the points into the corners of their convex hull, in order round it (Andrew's chains).
void to_hull(std::vector<Vec2>& points) {
    const auto before = [](const Vec2& a, const Vec2& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const std::size_t n = points.size();
    if (n < 3) return;
    // Behind the points, so that what has room for them once asks for no more.
    const auto add = [&](std::size_t i, std::size_t first) {
        const Vec2 p = points[i];
        while (points.size() >= first + 2) {
            const Vec2 a = points.back() - points[points.size() - 2], b = p - points.back();
            if (a.x() * b.y() - a.y() * b.x() > 0) break;
            points.pop_back();
        }
        points.push_back(p);
    };
    for (std::size_t i = 0; i < n; ++i)
        add(i, n);
    const std::size_t first = points.size() - 1;
    for (std::size_t i = n - 1; i-- > 0;)
        add(i, first);
    points.pop_back(); // the first once more
    points.erase(points.begin(), points.begin() + std::ptrdiff_t(n));
}

} // namespace

ContactDomain::ContactDomain(const Mesh& mesh, const DriveFrame& frame, const CutterCover& cover,
                             double allowance, const Progress& progress, std::size_t max_kept)
    : mesh_(mesh), frame_(frame) {
    const std::size_t n = mesh.facet_count();
    LargeVector<Fans::Move> moves(n, {std::numeric_limits<float>::quiet_NaN(), 0});
    lowest_tip_ = parallel_reduce(
        n, facets_per_block, infinity, progress.part(0, 0),
        [&](std::size_t begin, std::size_t end) {
            double lowest = infinity;
            for (std::size_t f = begin; f < end; ++f) {
                Vec3 normal = mesh.facet_normal(f);
                if (normal.z() < 0) normal = -normal;
                if (!(normal.z() >= tolerance::vertical_normal_z)) continue;
                const Vec3 move = cover.tip_offset(normal) + allowance * normal;
                moves[f] = {float(frame.u(move)), float(frame.v(move))};
                for (int k = 0; k < 3; ++k)
                    lowest = std::min(lowest, mesh.corner(f, k).z() + move.z());
            }
            return lowest;
        },
        [](double a, double b) { return std::min(a, b); });
    fans_ = std::make_shared<const Fans>(mesh, std::move(moves), progress);
    for (std::size_t f = 0; f < n; ++f)
        usable_ += fans_->asks(f);
    std::vector<FlatBox> boxes = boxes_of_facets(progress);
    if (n <= max_kept) {
        keep_outlines(progress);
        fans_.reset();
    }
    index_ = BoxRows(std::move(boxes), progress.part(0, 0));
}

std::vector<FlatBox> ContactDomain::boxes_of_facets(const Progress& progress) const {
    std::vector<FlatBox> boxes(mesh_.facet_count());
    const LargeVector<Fans::Reach> reaches = fans_->reaches(progress);
    parallel_for(boxes.size(), facets_per_block, progress.part(0, 0), [&](std::size_t f) {
        if (!fans_->asks(f)) return;
        const Vec2 first = first_vertex(f);
        Vec2 lo = Vec2::Constant(infinity), hi = -lo; // of its outline's corners, which are floats
        for (const Index vertex : mesh_.facets[f]) {
            const Vec3 p = mesh_.vertices[vertex] - mesh_.corner(f, 0);
            const Vec2 at(frame_.u(p), frame_.v(p));
            const Fans::Reach& reach = reaches[vertex];
            lo = lo.cwiseMin(Vec2(float(at.x() + reach.lo[0]), float(at.y() + reach.lo[1])));
            hi = hi.cwiseMax(Vec2(float(at.x() + reach.hi[0]), float(at.y() + reach.hi[1])));
        }
        boxes[f].u.add(first.x() + lo.x(), first.x() + hi.x());
        boxes[f].v.add(first.y() + lo.y(), first.y() + hi.y());
    });
    return boxes;
}

void ContactDomain::find_outline(std::size_t facet, std::vector<Vec2>& corners) const {
    corners.clear();
    fans_->each_corner(facet, frame_, [&](double u, double v) { corners.emplace_back(u, v); });
    to_hull(corners);
}

void ContactDomain::keep_outlines(const Progress& progress) {
    const std::size_t n = mesh_.facet_count(), blocks = (n + facets_per_block - 1) / facets_per_block;
    outline_start_.assign(n + 1, 0);
    std::vector<std::vector<Corner>> found(blocks);
    parallel_for(blocks, 1, progress.part(0, 0), [&](std::size_t block) {
        std::vector<Vec2> corners;
        for (std::size_t f = block * facets_per_block; f < std::min(n, (block + 1) * facets_per_block); ++f) {
            if (!fans_->asks(f)) continue;
            find_outline(f, corners);
            for (const Vec2& c : corners)
                found[block].push_back({float(c.x()), float(c.y())});
            outline_start_[f + 1] = std::uint32_t(corners.size());
        }
    });
    for (std::size_t f = 0; f < n; ++f)
        outline_start_[f + 1] += outline_start_[f];
    outlines_.reserve(outline_start_.back());
    for (std::vector<Corner>& block : found) {
        outlines_.insert(outlines_.end(), block.begin(), block.end());
        std::vector<Corner>().swap(block);
    }
}

/// Range of u of a facet that lies wholly in the strip; asked where outlines are not kept.
Interval ContactDomain::whole(std::size_t facet) const {
    const double first = first_vertex(facet).x();
    Interval range{infinity, -infinity};
    fans_->each_corner(facet, frame_, [&](double u, double) {
        range.lo = std::min(range.lo, first + float(u));
        range.hi = std::max(range.hi, first + float(u));
    });
    return range;
}

/// Range of u of a facet's outline within the strip: corners inside, and where the sides between them cross
/// those of the strip. Empty (lo > hi) where they do not meet.
Interval ContactDomain::clipped(std::size_t facet, double v0, double v1, Room& room) const {
    const Vec2 first = first_vertex(facet);
    const double low = v0 - first.y(), high = v1 - first.y();
    const Corner *begin = nullptr, *end = nullptr;
    if (fans_) {
        find_outline(facet, room.corners);
        room.outline.clear();
        for (const Vec2& c : room.corners)
            room.outline.push_back({float(c.x()), float(c.y())});
        begin = room.outline.data();
        end = begin + room.outline.size();
    } else {
        begin = outlines_.data() + outline_start_[facet];
        end = outlines_.data() + outline_start_[facet + 1];
    }
    Interval range{infinity, -infinity};
    const auto add = [&](double u) {
        range.lo = std::min(range.lo, u);
        range.hi = std::max(range.hi, u);
    };
    const Corner* a = end - 1;
    for (const Corner* b = begin; b < end; a = b++) {
        const double av = (*a)[1], bv = (*b)[1];
        if (bv >= low && bv <= high) add((*b)[0]);
        for (const double side : {low, high})
            if ((av < side) != (bv < side))
                add((*a)[0] + ((*b)[0] - double((*a)[0])) * ((side - av) / (bv - av)));
    }
    return {range.lo + first.x(), range.hi + first.x()};
}

std::vector<Interval> ContactDomain::strip(double v0, double v1, double merge, const Interval* within) const {
    // What ends just outside may join what begins inside.
    const double u0 = within ? within->lo - merge : -infinity, u1 = within ? within->hi + merge : infinity;
    std::vector<Interval> pieces;
    const auto is_covered = [&](const FloatInterval& u) {
        return !pieces.empty() && u.lo >= pieces.back().lo && u.hi <= pieces.back().hi;
    };
    // A fine part's facets overlap one another's ranges many times. Those that begin where all is covered up
    // to their beginning wait: the one of them whose box ends last most likely covers the others.
    struct Waiting {
        std::size_t facet;
        FlatBox box;
    };
    std::vector<Waiting> waiting;
    Room room;
    const auto take = [&](const Waiting& next) {
        const bool inside = double(next.box.v.lo) > v0 && double(next.box.v.hi) < v1;
        const Interval range = fans_ && inside ? whole(next.facet) : clipped(next.facet, v0, v1, room);
        if (!(range.lo <= range.hi)) return;
        if (!pieces.empty() && range.lo <= pieces.back().hi + merge && range.hi >= pieces.back().lo - merge)
            pieces.back() = {std::min(pieces.back().lo, range.lo), std::max(pieces.back().hi, range.hi)};
        else
            pieces.push_back(range);
    };
    const auto take_waiting = [&] {
        while (!waiting.empty()) {
            const auto last =
                std::max_element(waiting.begin(), waiting.end(),
                                 [](const Waiting& a, const Waiting& b) { return a.box.u.hi < b.box.u.hi; });
            take(*last);
            *last = waiting.back();
            waiting.pop_back();
            std::erase_if(waiting, [&](const Waiting& w) { return is_covered(w.box.u); });
        }
    };
    index_.visit(v0, v1, u0, u1, [&](std::size_t f, const FlatBox& box) {
        if (is_covered(box.u)) return;
        const bool is_apart = pieces.empty() || double(box.u.lo) > pieces.back().hi;
        if (!waiting.empty() && (is_apart || waiting.size() == max_waiting)) {
            take_waiting();
            if (is_covered(box.u)) return;
        }
        waiting.push_back({f, box});
    });
    take_waiting();
    return joined(std::move(pieces), merge);
}

} // namespace facetmill
