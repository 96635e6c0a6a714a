#include "core/strategy/finish3/left_stock.h"

#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/stock_before.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// How often passes are tried that something stood in the way of: each time what the others cut since is
/// gone, and mostly nothing is left for a third.
constexpr int max_rounds = 4;
/// How often others are asked for in the place of what is held up.
constexpr int instead_rounds = 2;
/// The cells in which shank and holder see what stands, and the points over those that a wall crosses, in
/// radii of the cutter: a touch of four thousandths is as large as several points.
constexpr double cell_share = 0.04, fine_share = 0.005;
/// Links no longer than so many radii may go over what is in their way.
constexpr double hop_radii = 6;
/// What stands nearer to the part than this share of the tolerance is cusps of this operation itself.
constexpr double skin_share = 0.05;

/// Passes shorter than so many radii are not cut from above; nor those that climb by more than this share of
/// their length, or are held up on less than this share of it, nor more than so often. Two of those lie
/// closer than flutes are long by this share.
constexpr double raised_radii = 2, raised_climb = 0.25, mostly_held = 0.25, raised_overlap = 0.05;
constexpr int max_raised = 24;

/// Follows one pass; cuts what it keeps.
class PassFollower {
public:
    /// `end`: where what was kept last ends.
    PassFollower(const Pass& pass, LeftStock& stock, double shortest, std::optional<Vec3>& end,
                 const Progress& progress)
        : pass_(pass), stock_(stock), shortest_(shortest), end_(end), progress_(progress) {}

    /// Ranges of its length on which nothing is touched.
    std::vector<Interval> run(std::span<const double> arc) {
        enter(pass_.cl.front().tip, 0);
        for (std::size_t i = 1; i < pass_.cl.size(); ++i) {
            progress_.check();
            const Vec3 &a = pass_.cl[i - 1].tip, &b = pass_.cl[i].tip;
            const bool is_free = std::min(a.z(), b.z()) >= stock_.free_height(a, b);
            const auto n =
                is_free ? std::size_t(1) : std::size_t(std::ceil((b - a).norm() / stock_.spacing())) + 1;
            for (std::size_t k = 1; k <= n; ++k) {
                const double t = double(k) / double(n);
                const Vec3 tip = a + t * (b - a);
                const double at = arc[i - 1] + t * (arc[i] - arc[i - 1]);
                if (is_free && inside_)
                    move(tip, at);
                else
                    enter(tip, at);
            }
        }
        leave();
        return std::move(ranges_);
    }
    /// How high a link to each of them has to be: -infinity on the surface, infinity where none is free.
    const std::vector<double>& link_heights() const { return link_heights_; }
    double lack() const { return lack_; }

private:
    void enter(const Vec3& tip, double at) {
        const double lack = stock_.lack(tip);
        lack_ = std::max(lack_, lack);
        if (lack > 0)
            leave();
        else if (inside_)
            move(tip, at);
        else {
            inside_ = true;
            ranges_.push_back({at, at});
            link_heights_.push_back(end_ ? link_height(*end_, tip) : -infinity);
            pending_.push_back({tip, tip});
            last_ = tip;
        }
    }
    void move(const Vec3& tip, double at) {
        ranges_.back().hi = at;
        pending_.push_back({last_, tip});
        last_ = tip;
        // What is too short is not cut after all.
        if (ranges_.back().length() >= shortest_) commit();
    }
    void leave() {
        if (inside_ && ranges_.back().length() < shortest_) {
            ranges_.pop_back();
            link_heights_.pop_back();
        } else if (inside_)
            end_ = last_;
        pending_.clear();
        inside_ = false;
    }
    /// Links on the surface are nowhere lower than the lower of their ends; straight up from one end, and
    /// down to the other, bodies that touch nothing there touch nothing.
    double link_height(const Vec3& from, const Vec3& to) {
        const double low = std::min(from.z(), to.z());
        const Vec3 a(from.x(), from.y(), low), b(to.x(), to.y(), low);
        if (low >= stock_.free_height(a, b)) return -infinity;
        const auto n = std::size_t(std::ceil((b - a).norm() / stock_.spacing())) + 1;
        const bool is_far = (b - a).norm() > stock_.hop();
        double height = low;
        for (std::size_t k = 0; k <= n; ++k) {
            progress_.check();
            const Vec3 at = a + double(k) / double(n) * (b - a);
            height += stock_.lack(Vec3(at.x(), at.y(), height));
            if (is_far && height > low) return infinity;
        }
        return height > low ? height + stock_.spacing() : -infinity;
    }
    void commit() {
        for (const auto& [a, b] : pending_)
            stock_.cut(a, b);
        pending_.clear();
    }

    const Pass& pass_;
    LeftStock& stock_;
    double shortest_;
    std::optional<Vec3>& end_;
    const Progress& progress_;
    std::vector<Interval> ranges_;
    std::vector<double> link_heights_;
    std::vector<std::pair<Vec3, Vec3>> pending_;
    Vec3 last_ = Vec3::Zero();
    bool inside_ = false;
    double lack_ = 0;
};

} // namespace

std::vector<LeftStock::Body> LeftStock::bodies_of(const Tool& tool) {
    std::vector<Body> bodies;
    double base = tool.flute_length;
    const auto add = [&](double diameter, double length) {
        if (diameter > 0 && length > 0) bodies.push_back({0.5 * diameter, base});
        base += std::max(length, 0.0);
    };
    add(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& s : tool.holder)
        add(s.diameter, s.length);
    return bodies;
}

double LeftStock::widest_of(const std::vector<Body>& bodies) {
    double widest = 0;
    for (const Body& body : bodies)
        widest = std::max(widest, body.radius);
    return widest;
}

LeftStock::LeftStock(const PlanContext& context, double cell, double fine, double skin, const Box3& tips,
                     const Progress& progress)
    : bodies_(bodies_of(context.tool)), lowest_base_(bodies_.empty() ? infinity : bodies_.front().base),
      widest_(widest_of(bodies_)), near_{tips.lo - Vec3(widest_, widest_, 0),
                                         tips.hi + Vec3(widest_, widest_, 0)},
      field_(stock_before(context, cell, progress, tips.lo.z() + lowest_base_, near_)),
      cutter_(CutterProfile(context.tool.cutter())), hop_(hop_radii * cutter_.radius()),
      fine_(context, field_, cutter_, fine, skin, tips.lo.z() + lowest_base_, near_) {}

double LeftStock::lack(const Vec3& tip) {
    double lack = 0;
    const Vec2 p = tip.head<2>();
    for (const Body& body : bodies_) {
        const double base = tip.z() + body.base;
        if (base + lack >= field_.no_higher()) continue; // mostly the holder
        field_.each_above(p, body.radius, base + lack, [&](std::size_t cell, double top) {
            if (top > base + lack) lack += fine_.over(cell, p, body.radius, base + lack);
        });
    }
    return lack;
}

double LeftStock::free_height(const Vec3& a, const Vec3& b) const {
    if (bodies_.empty()) return -infinity;
    const double floor = std::min(a.z(), b.z()) + lowest_base_;
    if (floor >= field_.no_higher()) return floor - lowest_base_;
    return field_.highest_near(a.head<2>(), b.head<2>(), widest_, floor) - lowest_base_;
}

std::vector<Pass> LeftStock::raised(const Pass& pass) {
    if (pass.cl.size() < 2) return {};
    const std::vector<double> arc = arc_lengths(pass);
    const double length = arc.back();
    double low = infinity, high = -infinity;
    for (const CutterLocation& c : pass.cl) {
        low = std::min(low, c.tip.z());
        high = std::max(high, c.tip.z());
    }
    // A ball is as wide as its shank only from its middle on.
    const double step = (1 - raised_overlap) * (lowest_base_ - cutter_.above(cutter_.radius()));
    const double over = std::ceil((field_.no_higher() - low - lowest_base_) / step);
    if (length < raised_radii * cutter_.radius() || high - low > raised_climb * length || !(step > 0)
        || !(over > 0 && over <= max_raised))
        return {};
    const double looks = std::ceil(length / cutter_.radius());
    double held = 0;
    for (double k = 0; k <= looks; ++k)
        if (lack(place_on(pass, arc, k / looks * length)) > 0) ++held;
    if (held < mostly_held * (looks + 1)) return {};
    std::vector<Pass> all;
    for (double k = over; k > 0; --k) {
        Pass& copy = all.emplace_back(pass);
        for (CutterLocation& c : copy.cl)
            c.tip.z() += k * step;
        for (CutterContact& c : copy.cc)
            c.point.z() += k * step;
    }
    return all;
}

namespace {

/// Follows passes one after the other, where the tool ends in between.
class PassesFollowed {
public:
    PassesFollowed(LeftStock& stock, double shortest, const ContactAt& contact, const Progress& progress)
        : stock_(stock), shortest_(shortest), contact_(contact), progress_(progress) {}

    /// What is held up of them.
    std::vector<Pass> follow(std::vector<Pass> passes) {
        std::vector<Pass> held;
        for (Pass& pass : passes) {
            progress_.check();
            if (pass.cl.empty()) continue;
            const std::vector<double> arc = arc_lengths(pass);
            PassFollower follower(pass, stock_, std::min(shortest_, arc.back()), end_, progress_);
            const std::vector<Interval> ranges = follower.run(arc);
            lack = std::max(lack, follower.lack());
            if (ranges.size() == 1 && ranges[0].lo <= 0 && ranges[0].hi >= arc.back()) {
                keep(std::move(pass), follower.link_heights()[0]);
                continue;
            }
            std::vector<Pass> pieces = pieces_of(pass, arc, ranges, contact_);
            for (std::size_t k = 0; k < pieces.size(); ++k)
                keep(std::move(pieces[k]), follower.link_heights()[k]);
            for (Pass& piece : pieces_of(pass, arc, gaps_between(ranges, arc.back()), contact_))
                held.push_back(std::move(piece));
        }
        return held;
    }

    /// The same, what is mostly held up from above.
    std::vector<Pass> follow_from_above(const std::vector<Pass>& passes) {
        std::vector<Pass> held;
        for (const Pass& pass : passes) {
            follow(stock_.raised(pass));
            for (Pass& piece : follow({pass}))
                held.push_back(std::move(piece));
        }
        return held;
    }

    /// Where the tool is after what was kept last.
    const std::optional<Vec3>& end() const { return end_; }

    std::vector<Pass> kept;
    double lack = 0;

private:
    void keep(Pass pass, double link_height) {
        pass.from_above = link_height == infinity;
        pass.entry.clear();
        if (std::isfinite(link_height)) {
            CutterLocation over = pass.cl.front();
            over.tip.z() = std::max(over.tip.z(), link_height);
            pass.entry.push_back(over);
        }
        kept.push_back(std::move(pass));
    }

    LeftStock& stock_;
    double shortest_;
    const ContactAt& contact_;
    const Progress& progress_;
    std::optional<Vec3> end_;
};

double length_of(std::span<const Pass> passes) {
    double sum = 0;
    for (const Pass& pass : passes)
        if (!pass.cl.empty()) sum += arc_lengths(pass).back();
    return sum;
}

} // namespace

ClearOfStock keep_clear_of_stock(std::vector<Pass> passes, LeftStock& stock, double shortest,
                                 const ContactAt& contact, const Progress& progress,
                                 const PassesInstead& instead) {
    PassesFollowed followed(stock, shortest, contact, progress);
    for (int round = 0; round < max_rounds && !passes.empty(); ++round) {
        followed.lack = 0;
        const std::size_t kept_before = followed.kept.size();
        passes =
            round == 0 && instead ? followed.follow_from_above(passes) : followed.follow(std::move(passes));
        if (followed.kept.size() == kept_before) break;
    }
    ClearOfStock result;
    result.lack = followed.lack;
    result.left_length = length_of(passes);
    const std::size_t own = followed.kept.size();
    std::vector<Pass> held = passes;
    for (int round = 0; instead && round < instead_rounds; ++round) {
        held = followed.follow(instead(held, followed.end()));
    }
    if (instead) {
        const double beside = length_of(std::span(followed.kept).subspan(own));
        // What was cut beside them may have been all that stood in their way.
        passes = followed.follow(std::move(passes));
        result.left_length = std::max(0.0, std::min(result.left_length - beside, length_of(passes)));
    }
    result.left = std::move(passes);
    result.kept = std::move(followed.kept);
    return result;
}

std::optional<ClearOfStock> keep_clear_of_left_stock(std::vector<Pass>& passes, const PlanContext& context,
                                                     double radius, double tolerance,
                                                     const ContactAt& contact, const Progress& progress,
                                                     const PassesInstead& instead) {
    // Nothing is known of a stock: nothing is asked.
    if (context.stock.box.empty() && context.earlier.empty()) return std::nullopt;
    Box3 tips;
    for (const Pass& p : passes)
        for (const CutterLocation& c : p.cl)
            tips.add(c.tip);
    if (tips.lo.z() + context.tool.flute_length >= context.stock_box.hi.z()) return std::nullopt;
    // Others in their place may lie anywhere.
    if (instead) tips = {Vec3(-infinity, -infinity, tips.lo.z()), Vec3::Constant(infinity)};
    LeftStock stock(context, cell_share * radius, fine_share * radius, skin_share * tolerance, tips,
                    progress);
    ClearOfStock clear =
        keep_clear_of_stock(std::move(passes), stock, shortest_piece * radius, contact, progress, instead);
    passes = std::move(clear.kept);
    return clear;
}

std::string beside_stock_warning(const ClearOfStock& clear, const PlanContext& context) {
    const PlanText text{context.unit, context.to_setup};
    return "shank or holder would come into what stands of the stock beside " + text(clear.left_length)
           + " of the passes, which are left out: flutes of " + text(context.tool.flute_length + clear.lack)
           + " instead of " + text(context.tool.flute_length) + ", or roughing closer, would reach it";
}

void refuse_beside_stock(const std::string& operation, const ClearOfStock& clear,
                         const PlanContext& context) {
    throw Error(ErrorCode::empty_result, operation,
                "shank or holder would come into the stock wherever the cutter could cut",
                "rough before it, or use flutes that are "
                    + PlanText{context.unit, context.to_setup}(clear.lack) + " longer");
}

} // namespace facetmill
