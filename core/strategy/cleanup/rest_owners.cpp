#include "core/strategy/cleanup/rest_owners.h"

#include <numeric>

namespace facetmill {

namespace {

constexpr std::size_t owners_per_check = 2048;

class Sharing {
public:
    Sharing(double tolerance, std::size_t curves, const RestFacets& rest, const RestGaps& gaps)
        : tolerance_(tolerance), rest_(rest), gaps_(gaps) {
        out_.of.assign(rest.facets.size(), -1);
        out_.count = int(curves);
    }

    RestOwners run(const Progress& progress) {
        own_by_points(progress);
        gather_by_points();
        // What has no valley above it belongs to the valley beside it,
        for (std::size_t i = 0; i < in_.size(); ++i)
            if (in_[i] && out_.of[i] >= 0) queue_.push_back(std::uint32_t(i));
        spread(0, progress);
        // and what is beside none is a hollow.
        for (std::size_t i = 0; i < in_.size(); ++i) {
            if (!in_[i] || out_.of[i] >= 0) continue;
            out_.of[i] = out_.count++;
            queue_.push_back(std::uint32_t(i));
            spread(queue_.size() - 1, progress);
        }
        return std::move(out_);
    }

private:
    /// A facet is in a band if more than the tolerance is left at a corner, and belongs to the valley of the
    /// corner at which most is.
    void own_by_points(const Progress& progress) {
        in_.assign(rest_.facets.size(), 0);
        for (std::size_t i = 0; i < rest_.facets.size(); ++i) {
            if (i % owners_per_check == 0) progress.check();
            double most = 0;
            for (const Index c : rest_.facets[i].corner) {
                in_[i] = in_[i] || gaps_.gap[c] > tolerance_;
                if (gaps_.curve[c] >= 0 && gaps_.gap[c] > most) {
                    most = gaps_.gap[c];
                    out_.of[i] = gaps_.curve[c];
                }
            }
        }
        for (std::size_t i = 0; i < in_.size(); ++i)
            if (!in_[i]) out_.of[i] = -1;
    }

    void gather_by_points() {
        first_.assign(rest_.points.size() + 1, 0);
        for (std::size_t i = 0; i < in_.size(); ++i)
            if (in_[i])
                for (const Index c : rest_.facets[i].corner)
                    ++first_[c + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        at_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < in_.size(); ++i)
            if (in_[i])
                for (const Index c : rest_.facets[i].corner)
                    at_[next[c]++] = std::uint32_t(i);
    }

    /// From the queue's facets on to those without an owner beside them.
    void spread(std::size_t begin, const Progress& progress) {
        for (std::size_t q = begin; q < queue_.size(); ++q) {
            if (q % owners_per_check == 0) progress.check();
            const std::uint32_t from = queue_[q];
            for (const Index c : rest_.facets[from].corner)
                for (std::uint32_t k = first_[c]; k < first_[c + 1]; ++k)
                    if (const std::uint32_t o = at_[k]; out_.of[o] < 0 && gaps_.gap[c] > tolerance_) {
                        out_.of[o] = out_.of[from];
                        queue_.push_back(o);
                    }
        }
    }

    double tolerance_;
    const RestFacets& rest_;
    const RestGaps& gaps_;
    std::vector<char> in_;             ///< facets in a band
    std::vector<std::uint32_t> first_; ///< the facets in a band at point c: at_[first_[c]] and on
    std::vector<std::uint32_t> at_, queue_;
    RestOwners out_;
};

} // namespace

RestOwners share_out(double tolerance, std::size_t curves, const RestFacets& rest, const RestGaps& gaps,
                     const Progress& progress) {
    return Sharing(tolerance, curves, rest, gaps).run(progress);
}

} // namespace facetmill
