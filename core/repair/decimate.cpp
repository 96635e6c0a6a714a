// Decimated within a bound: edges go in the order of the error that they leave (decimator.h). Every vertex
// that went is kept with the facet that it lies nearest to, and must stay within the bound of it; at the end
// the distance of the two surfaces is measured both ways, and where it is larger than the bound the vertices
// are held, and what was done there is done again.
#include "core/base/parallel.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/facet_boxes.h"
#include "core/repair/decimator.h"
#include "core/repair/deviation.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <cmath>

namespace facetmill::detail {

namespace {

constexpr int max_attempts = 8;
/// Share of the bound that the vertices that went may use at the first attempt, and of that at each further
/// one: places between them are somewhat farther away.
constexpr double first_share = 0.8, further_share = 0.8;
/// To this share of the bound the deviation is measured.
constexpr double measured_share = 0.02;
constexpr std::size_t facets_at_once = 4096;

/// How far source and result lie apart, measured again only where the result has become another one.
class Measured {
public:
    Measured(const Mesh& source, const DeviationIndex& surface, double bound)
        : source_(source), surface_(surface), bound_(bound), beyond_(source.facet_count(), 0) {}

    /// Marks the vertices of the source at places that lie beyond the bound of the result, and back; says
    /// whether there are any.
    bool mark_beyond(const std::shared_ptr<const Mesh>& result, std::vector<char>& marked,
                     const Progress& progress);
    /// No place of one that was found within the bound lies farther from the other, mm.
    double deviation() const { return deviation_; }

private:
    std::vector<char> known_forward(const Mesh& result, const Progress& progress) const;
    std::vector<char> known_backward(const Mesh& result, const Progress& progress) const;
    void mark(Index f, std::vector<char>& marked) const {
        for (const Index v : source_.facets[f])
            marked[v] = 1;
    }

    const Mesh& source_;
    const DeviationIndex& surface_;
    double bound_, deviation_ = 0;
    std::shared_ptr<const Mesh> before_; ///< the result before
    std::vector<char> beyond_;           ///< per facet of the source: it was beyond the bound of that
    std::vector<char> beyond_back_;      ///< per facet of that: it was beyond the bound of the source
};

/// Facets of the source that need no look: the result has them, or all of the result that was within the
/// bound of them is still there.
std::vector<char> Measured::known_forward(const Mesh& result, const Progress& progress) const {
    std::vector<char> known = facets_in_both(source_, result, progress);
    if (!before_) return known;
    const std::vector<char> stays = facets_in_both(*before_, result, progress);
    std::vector<Box3> lost;
    for (std::size_t f = 0; f < stays.size(); ++f) {
        if (stays[f]) continue;
        Box3 box;
        for (int k = 0; k < 3; ++k)
            box.add(before_->corner(f, k));
        box.lo.array() -= bound_;
        box.hi.array() += bound_;
        lost.push_back(box);
    }
    const BoxTree tree(std::move(lost), progress);
    parallel_for(known.size(), facets_at_once, progress, [&](std::size_t f) {
        if (known[f] || beyond_[f]) return;
        Box3 box;
        for (int k = 0; k < 3; ++k)
            box.add(source_.corner(f, k));
        bool near = false;
        tree.each(
            [&](const Box3& b) {
                return !near && (b.lo.array() <= box.hi.array()).all()
                       && (b.hi.array() >= box.lo.array()).all();
            },
            [&](std::size_t) { near = true; });
        known[f] = !near;
    });
    return known;
}

/// Facets of the result that need no look: the source has them, or they were within the bound before.
std::vector<char> Measured::known_backward(const Mesh& result, const Progress& progress) const {
    std::vector<char> known = facets_in_both(result, source_, progress);
    if (!before_) return known;
    Mesh good;
    good.vertices = before_->vertices;
    for (std::size_t f = 0; f < before_->facet_count(); ++f)
        if (!beyond_back_[f]) good.facets.push_back(before_->facets[f]);
    const std::vector<char> again = facets_in_both(result, good, progress);
    for (std::size_t f = 0; f < known.size(); ++f)
        known[f] = known[f] || again[f];
    return known;
}

bool Measured::mark_beyond(const std::shared_ptr<const Mesh>& result, std::vector<char>& marked,
                           const Progress& progress) {
    const double accuracy = measured_share * bound_;
    bool any = false;
    double within = 0;
    const std::vector<char> forward = known_forward(*result, progress.part(0, 0.05)),
                            backward = known_backward(*result, progress.part(0.05, 0.1));
    {
        const DeviationIndex index(*result, progress.part(0.1, 0.15), bound_);
        std::fill(beyond_.begin(), beyond_.end(), 0);
        for (const Index f :
             facets_beyond(source_, index, bound_, accuracy, forward, within, progress.part(0.15, 0.6))) {
            beyond_[f] = 1;
            mark(f, marked);
            any = true;
        }
        deviation_ = std::max(deviation_, std::min(within, bound_));
    }
    beyond_back_.assign(result->facet_count(), 0);
    for (const Index f :
         facets_beyond(*result, surface_, bound_, accuracy, backward, within, progress.part(0.6, 1))) {
        beyond_back_[f] = 1;
        const Vec3 &a = result->corner(f, 0), &b = result->corner(f, 1), &c = result->corner(f, 2);
        for (const Vec3& p :
             {a, b, c, Vec3((a + b + c) / 3), Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)})
            mark(surface_.nearest_facet(p), marked);
        any = true;
    }
    deviation_ = std::max(deviation_, std::min(within, bound_));
    before_ = result;
    return any;
}

} // namespace

StepResult decimate(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    StepResult result;
    const auto least = std::max(std::size_t(std::llround(step.share * double(mesh.facet_count()))),
                                std::size_t(step.facets));
    std::vector<char> held(mesh.vertices.size(), 0);
    double share = first_share;
    const DeviationIndex surface(mesh, progress.part(0, 0.05), step.bound);
    Measured measured(mesh, surface, step.bound);
    DecimationLog log;
    std::vector<char> held_now;
    for (int attempt = 0; attempt < max_attempts; ++attempt, share *= further_share) {
        const double from = 1 - std::pow(0.5, attempt), to = 1 - std::pow(0.5, attempt + 1);
        const Progress part = progress.part(from, to);
        std::shared_ptr<Mesh> after;
        std::size_t left_out = 0;
        {
            Decimator decimator(mesh, surface, held, part.part(0, 0.15));
            left_out = decimator.left_out();
            if (attempt > 0) decimator.repeat(log, held_now, part.part(0.15, 0.25));
            decimator.run(share * step.bound, std::max(least, left_out) - left_out, part.part(0.25, 0.6));
            after = decimator.result(part);
            log = decimator.take_log();
        }
        if (after->facet_count() == mesh.facet_count()) break;
        std::vector<char> marked(held.size(), 0);
        if (measured.mark_beyond(after, marked, part.part(0.6, 1))) {
            held_now.assign(held.size(), 0);
            for (std::size_t v = 0; v < held.size(); ++v) {
                held_now[v] = marked[v] && !held[v];
                held[v] = held[v] || marked[v];
            }
            continue;
        }
        result.displacement = measured.deviation();
        result.tell("facets_removed", mesh.facet_count() - after->facet_count());
        result.tell_any("attempts", std::size_t(attempt) + 1);
        result.tell_any("facets_in_no_sheet", left_out);
        result.mesh = std::move(after);
        return result;
    }
    result.tell("facets_removed", 0);
    return result;
}

} // namespace facetmill::detail
