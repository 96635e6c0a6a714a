#include "core/gouge/vector_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/revolved_body.h"
#include "core/gouge/vector_elements.h"
#include "core/gouge/vector_tree.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Axes of the body in part coordinates: z the tool axis, x towards the direction, which has no y.
struct Frame {
    Mat3 axes; ///< rows
    Vec3 tip;
    LiftVector w;

    explicit Frame(const Posture& posture) : tip(posture.tip) {
        const Vec3 z = posture.axis.normalized(), v = posture.direction.normalized();
        w.wz = z.dot(v);
        Vec3 y = z.cross(v);
        w.wx = y.norm();
        // Where v is the axis but for rounding, y is that rounding: made to lie across the axis again.
        if (w.wx > 0) y = y / w.wx - z.dot(y / w.wx) * z;
        if (!(y.norm() > 0.5)) {
            int least = 0;
            for (int i = 1; i < 3; ++i)
                if (std::abs(z[i]) < std::abs(z[least])) least = i;
            y = z.cross(Vec3::Unit(least));
        }
        y.normalize();
        axes.row(0) = y.cross(z);
        axes.row(1) = y;
        axes.row(2) = z;
    }
    Vec3 to_body(const Vec3& p) const { return axes * (p - tip); }
};

bool is_posture(const Posture& p) {
    const auto unit = [](const Vec3& v) { return std::abs(v.norm() - 1) <= tolerance::unit_axis; };
    return p.tip.allFinite() && unit(p.axis) && unit(p.direction);
}

struct Best {
    VectorContact contact;
    Index leaf = no_index;
};

class Query {
public:
    Query(const VectorTree& tree, const Posture& posture) : tree_(tree), frame_(posture) {}

    void set_body(const RevolvedBody& body, unsigned number) {
        body_ = &body;
        number_ = number;
        const Vec3 w = frame_.w.vec(), across(frame_.w.wz, 0, -frame_.w.wx);
        // No lift is above (max m . q + extent(-m)) / (m . w), for any m with m . w > 0; and with m . w = 0
        // nothing is touched where that is negative.
        count_ = 0;
        const auto add = [&](const Vec3& m, double climb) { bounds_[count_++] = bound(m, climb); };
        for (const Vec3& m : {across, Vec3(-across), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY())})
            add(m, 0);
        add(w, 1);
        // Aslant, for the round of the body below: what is near its rim is promised less.
        for (const Vec3& m : {across, Vec3(-across), Vec3(Vec3::UnitY()), Vec3(-Vec3::UnitY())})
            add((w + m).normalized(), std::sqrt(0.5));
        if (frame_.w.wz != 0) add(Vec3(0, 0, std::copysign(1.0, frame_.w.wz)), std::abs(frame_.w.wz));
        if (frame_.w.wx > 0) add(Vec3::UnitX(), frame_.w.wx);
        first_of_contact_ = next_of_contact_ = count_;
        size_ = body.max_radius() + std::max(std::abs(body.bottom()), std::abs(body.top()))
                + frame_.tip.cwiseAbs().maxCoeff();
    }

    void test_leaf(Index leaf) {
        tree_.facets(leaf, [&](Index facet, const Vec3& a, const Vec3& b, const Vec3& c) {
            if (promise(a, b, c) <= best_.contact.lift) return;
            int feature = 0;
            const VectorElement e = vector_facet_lift(*body_, frame_.w, frame_.to_body(a), frame_.to_body(b),
                                                      frame_.to_body(c), best_.contact.lift, feature);
            if (!(e.lift > best_.contact.lift)) return;
            VectorContact& contact = best_.contact;
            contact.lift = e.lift;
            contact.facet = facet;
            contact.point = frame_.axes.transpose() * e.point + frame_.tip;
            contact.feature = static_cast<VectorContact::Feature>(feature);
            contact.body = number_;
            contact.piece = e.piece;
            best_.leaf = leaf;
            add_contact(e);
        });
    }

    /// The whole tree, nearest promise first.
    void run() {
        struct Entry {
            double bound;
            Index child;
        };
        // As in AxialLift: seven siblings wait on every level.
        std::array<Entry, VectorTree::width * 16> stack;
        std::size_t depth = 0;
        stack[depth++] = {infinity, 0};
        while (depth > 0) {
            const Entry top = stack[--depth];
            if (top.bound <= best_.contact.lift) continue;
            if (VectorTree::is_leaf(top.child)) {
                test_leaf(top.child);
                continue;
            }
            const std::size_t from = depth;
            tree_.children(top.child, [&](Index child, const Vec3& middle, const Vec3& half) {
                const double bound = promise(middle, half);
                if (bound <= best_.contact.lift) return;
                std::size_t at = depth++;
                while (at > from && stack[at - 1].bound > bound) {
                    stack[at] = stack[at - 1];
                    --at;
                }
                stack[at] = {bound, child};
            });
        }
    }

    const Best& best() const { return best_; }

private:
    struct Bound {
        Vec3 m, absolute; ///< part coordinates, unit
        double extent, climb;
    };

    Bound bound(const Vec3& m, double climb) const {
        const Vec3 in_part = frame_.axes.transpose() * m;
        return {in_part, in_part.cwiseAbs(), body_->extent(-m), climb};
    }

    /// The body's tangent plane at a contact parts it from all that lies behind: it bounds what else there
    /// is, most of it below that contact where the mesh is convex. The last few are kept.
    void add_contact(const VectorElement& e) {
        const Vec3 w = frame_.w.vec(), m = -body_->normal(e.piece, e.point - e.lift * w);
        const double climb = m.dot(w);
        if (!(climb > tolerance::edge_on)) return;
        bounds_[next_of_contact_++] = bound(m, climb);
        count_ = std::max(count_, next_of_contact_);
        if (next_of_contact_ == bounds_.size()) next_of_contact_ = first_of_contact_;
    }

    /// No lift of anything in the box is higher.
    double promise(const Vec3& box_middle, const Vec3& half) const {
        const Vec3 middle = box_middle - frame_.tip;
        const double slack =
            tolerance::bound_slack * (size_ + box_middle.cwiseAbs().maxCoeff() + half.cwiseAbs().maxCoeff());
        return min_bound(slack, [&](const Bound& b) { return b.m.dot(middle) + b.absolute.dot(half); });
    }
    /// The same for a facet by its corners.
    double promise(const Vec3& a, const Vec3& b, const Vec3& c) const {
        const Vec3 p = a - frame_.tip, q = b - frame_.tip, r = c - frame_.tip;
        const double slack =
            tolerance::bound_slack
            * (size_ + p.cwiseAbs().maxCoeff() + q.cwiseAbs().maxCoeff() + r.cwiseAbs().maxCoeff());
        return min_bound(slack, [&](const Bound& bound) {
            return std::max({bound.m.dot(p), bound.m.dot(q), bound.m.dot(r)});
        });
    }
    /// `most(bound)`: the largest m . q there.
    template <class Most>
    double min_bound(double slack, Most&& most) const {
        double least = infinity;
        for (std::size_t i = 0; i < count_; ++i) {
            const Bound& b = bounds_[i];
            const double over = most(b) + b.extent + slack;
            if (b.climb > 0)
                least = std::min(least, (over + tolerance::bound_slack * std::abs(over)) / b.climb);
            else if (over < 0)
                return -infinity;
        }
        return least;
    }

    const VectorTree& tree_;
    Frame frame_;
    const RevolvedBody* body_ = nullptr;
    unsigned number_ = 0;
    std::array<Bound, 15> bounds_;
    std::size_t count_ = 0, first_of_contact_ = 0, next_of_contact_ = 0;
    double size_ = 0;
    Best best_;
};

/// All bodies of the tool; `first_leaf` is asked before the rest.
Best ask(const VectorTree& tree, const std::vector<RevolvedBody>& bodies, const Posture& posture,
         Index first_leaf = no_index) {
    Best best;
    if (!is_posture(posture)) {
        best.contact.lift = std::numeric_limits<double>::quiet_NaN();
        return best;
    }
    if (tree.empty()) return best;
    Query query(tree, posture);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        query.set_body(bodies[i], unsigned(i));
        if (first_leaf != no_index) query.test_leaf(first_leaf);
        query.run();
    }
    return query.best();
}

} // namespace

VectorLift::VectorLift(ContactIndexPtr index, const CutterProfile& cutter,
                       std::span<const BodySection> sections, double allowance)
    : index_(std::move(index)), tree_(std::make_unique<const VectorTree>(*index_)) {
    bodies_.emplace_back(cutter.grown(allowance), -allowance);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const BodySection& s = sections[i];
        if (!(s.radius > 0) || !(s.to > s.from) || !std::isfinite(s.from))
            throw Error(ErrorCode::out_of_range, "section[" + std::to_string(i) + "]",
                        "has no positive radius and length", "correct shank and holder");
        const CutterProfile cylinder(AptCutter::flat(2 * s.radius, s.to - s.from));
        bodies_.emplace_back(cylinder.grown(allowance), s.from - allowance);
    }
}

VectorLift::~VectorLift() = default;

double VectorLift::lift(const Posture& posture) const {
    return ask(*tree_, bodies_, posture).contact.lift;
}

VectorContact VectorLift::contact(const Posture& posture) const {
    return ask(*tree_, bodies_, posture).contact;
}

void VectorLift::lift(std::span<const Posture> postures, std::span<double> lifts,
                      const Progress& progress) const {
    if (postures.size() != lifts.size())
        throw Error(ErrorCode::internal, "VectorLift", "as many lifts as postures are needed", "report this");
    constexpr std::size_t postures_per_block = 64;
    parallel_blocks(postures.size(), postures_per_block, progress, [&](std::size_t begin, std::size_t end) {
        // A neighbour's blocking facets are a good first guess; the result is the same.
        Index last_leaf = no_index;
        for (std::size_t i = begin; i < end; ++i) {
            const Best best = ask(*tree_, bodies_, postures[i], last_leaf);
            if (best.leaf != no_index) last_leaf = best.leaf;
            lifts[i] = best.contact.lift;
        }
    });
}

} // namespace facetmill
