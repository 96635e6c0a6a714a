#include "core/strategy/tilt/axis_tilt.h"

#include "core/base/tolerances.h"
#include "core/strategy/five_axis/even_motion.h"
#include "core/strategy/five_axis/posture_path.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Axes are chosen every so many radii of the cutter.
constexpr double knot_share = 0.5;
constexpr std::size_t max_knots = 4000;
/// The grid of axes: steps of inclination, and how many around.
constexpr double tilt_step = pi / 36;
constexpr int azimuths = 16;
/// An axis turns by no more between two knots.
constexpr double max_tilt_turn = pi / 4.5;
/// Weights of inclination, turn and raise (as a share of the largest), squared.
constexpr double tilt_weight = 0.1, turn_weight = 1, raise_weight = 0.05;
/// A motion that is not clear is halved so often, then left out.
constexpr int max_tilt_divisions = 6;
constexpr std::size_t locations_per_look = 256;
/// Shares of the chord tolerance: how far a ball's middle may leave its way as the axis turns about a tip
/// that moves straight, and how far machines may differ on a motion.
constexpr double bulge_share = 0.25, even_tilt_share = 0.25;

class Tilter {
public:
    Tilter(const TiltInput& input, const Pass& pass)
        : in_(input), pass_(pass), radius_(input.whole->cutter().max_radius()),
          ball_(ball_radius(input.whole->cutter())) {}

    TiltedPass run(const Progress& progress) {
        if (!is_held(progress)) {
            result_.passes.push_back(pass_);
            result_.kept.push_back({0, length_of(pass_)});
            return std::move(result_);
        }
        divide();
        make_axes();
        choose(progress);
        join(progress);
        return std::move(result_);
    }

private:
    struct Knot {
        std::size_t cl = 0; ///< location of the pass
        double length = 0;  ///< along the pass up to there
        int axis = -1;      ///< the one chosen; -1: none is free
    };

    /// Shank or holder, where one is in the part or in what stands.
    ToolBody body_at(const CutterLocation& at) {
        const ToolContact c = in_.whole->contact_above({at.tip, at.axis}, in_.chord, hint_);
        if (c.body == ToolBody::shank || c.body == ToolBody::holder) return c.body;
        return in_.stock && in_.stock->may_hold(at) ? ToolBody::holder : ToolBody::none;
    }

    static double length_of(const Pass& pass) {
        double length = 0;
        for (std::size_t k = 1; k < pass.cl.size(); ++k)
            length += (pass.cl[k].tip - pass.cl[k - 1].tip).norm();
        return length;
    }

    /// Whether shank or holder touch anywhere along the upright pass.
    bool is_held(const Progress& progress) {
        for (std::size_t k = 0; k < pass_.cl.size(); ++k) {
            if (k % locations_per_look == 0) progress.check();
            if (body_at(pass_.cl[k]) != ToolBody::none) return true;
            if (k == 0 || !(in_.look_step < infinity)) continue;
            const Vec3 &a = pass_.cl[k - 1].tip, &b = pass_.cl[k].tip;
            const auto parts = std::size_t((b - a).norm() / in_.look_step) + 1;
            for (std::size_t i = 1; i < parts; ++i)
                if (body_at({a + double(i) / double(parts) * (b - a), Vec3::UnitZ()}) != ToolBody::none)
                    return true;
        }
        return false;
    }

    /// Long moves get locations between, at which the axis may turn.
    void divide() {
        const double step = std::max(knot_share * radius_, length_of(pass_) / double(max_knots));
        Pass divided = pass_;
        divided.cl.clear();
        divided.cc.clear();
        put_in_.clear();
        for (std::size_t k = 0; k < pass_.cl.size(); ++k) {
            if (k > 0) {
                const CutterContact &a = pass_.cc[k - 1], &b = pass_.cc[k];
                const Vec3 &from = pass_.cl[k - 1].tip, &to = pass_.cl[k].tip;
                const auto parts = std::size_t((to - from).norm() / step) + 1;
                for (std::size_t i = 1; i < parts; ++i) {
                    const double t = double(i) / double(parts);
                    const Vec3 normal = (1 - t) * a.normal + t * b.normal;
                    put_in_.push_back(1);
                    divided.cl.push_back({from + t * (to - from), Vec3::UnitZ()});
                    divided.cc.push_back({a.point + t * (b.point - a.point),
                                          normal.norm() > 0 ? normal.normalized() : a.normal});
                }
            }
            put_in_.push_back(0);
            divided.cl.push_back(pass_.cl[k]);
            divided.cc.push_back(pass_.cc[k]);
        }
        pass_ = std::move(divided);
    }

    void make_axes() {
        axes_.push_back(Vec3::UnitZ());
        for (int ring = 1; ring * tilt_step < in_.limit + tilt_step - tolerance::level_angle; ++ring) {
            const double tilt = std::min(ring * tilt_step, in_.limit);
            for (int k = 0; k < azimuths; ++k) {
                const double a = 2 * pi * k / azimuths;
                axes_.emplace_back(std::sin(tilt) * std::cos(a), std::sin(tilt) * std::sin(a),
                                   std::cos(tilt));
            }
        }
        for (const Vec3& a : axes_) {
            tilts_.push_back(std::acos(std::min(a.z(), 1.0)));
            for (const Vec3& b : axes_) {
                const double turn = std::acos(std::clamp(a.dot(b), -1.0, 1.0));
                turns_.push_back(turn > max_tilt_turn ? infinity : turn_weight * turn * turn);
            }
        }
    }

    /// Where the tool stands with this axis at a place of the pass, drawn out; false where it cannot.
    bool stand(std::size_t k, const Vec3& axis, CutterLocation& at, double& raise) {
        if (in_.ball_only && !touches_with_ball(pass_.cc[k].normal, axis)) return false;
        if (!turned_about_contact(in_.whole->cutter(), pass_.cc[k], pass_.cl[k].tip, axis, at)) return false;
        raise = std::max(0.0, in_.whole->lift({at.tip, at.axis}, hint_));
        if (raise > in_.raise) return false;
        at.tip += raise * axis;
        if (in_.machine && !in_.machine->reaches({at.tip, at.axis})) return false;
        return !in_.stock || !in_.stock->may_hold(at);
    }

    /// A tapered end has a ball only up to where its cone begins. An upright tool stands as it was planned.
    bool touches_with_ball(const Vec3& normal, const Vec3& axis) const {
        if (ball_ == radius_ || axis == Vec3::UnitZ()) return true;
        const double lowest = std::sin(in_.whole->cutter().cutter().beta) + tolerance::level_angle;
        return normal.z() >= lowest && normal.dot(axis) >= lowest;
    }

    void place_knots() {
        const std::size_t n = pass_.cl.size();
        std::vector<double> length(n, 0);
        for (std::size_t k = 1; k < n; ++k)
            length[k] = length[k - 1] + (pass_.cl[k].tip - pass_.cl[k - 1].tip).norm();
        const double step = std::max(knot_share * radius_, length.back() / double(max_knots));
        for (std::size_t k = 0; k < n; ++k)
            if (k == 0 || k + 1 == n || length[k] - knots_.back().length >= step)
                knots_.push_back({k, length[k], -1});
    }

    /// The cheapest sequence of free axes along a run of knots, as far as it is known.
    struct Search {
        std::vector<double> cost;           ///< cost of the cheapest that ends with each axis
        std::vector<std::vector<int>> from; ///< the axis before, for each knot and axis
        std::size_t begin = 0;              ///< first knot of the run
    };

    /// Dynamic programming over runs of knots, at each of which an axis is free that those before can turn
    /// to.
    void choose(const Progress& progress) {
        place_knots();
        Search search{std::vector<double>(axes_.size(), 0),
                      std::vector<std::vector<int>>(knots_.size(), std::vector<int>(axes_.size(), -1)), 0};
        for (std::size_t i = 0; i < knots_.size();) {
            progress.check();
            if (go_on(i, search)) {
                ++i;
                continue;
            }
            // Nothing turns to what is free here: what follows begins anew, here or, where nothing is free at
            // all, at the next.
            if (i > search.begin)
                choose_best(search, i);
            else
                ++i;
            search.begin = i;
        }
        choose_best(search, knots_.size());
    }

    /// Takes knot i on to the run; false where no axis is free there that those before can turn to.
    bool go_on(std::size_t i, Search& search) {
        std::vector<double> next(axes_.size(), infinity);
        bool any = false;
        for (std::size_t a = 0; a < axes_.size(); ++a) {
            CutterLocation at;
            double raise = 0;
            if (!stand(knots_[i].cl, axes_[a], at, raise)) continue;
            const double tilt = tilts_[a];
            const double own =
                tilt_weight * tilt * tilt + raise_weight * (raise / in_.raise) * (raise / in_.raise);
            next[a] = (i == search.begin ? 0 : cheapest_before(i, a, search)) + own;
            any = any || next[a] < infinity;
        }
        if (any) search.cost = std::move(next);
        return any;
    }

    /// Cost of the cheapest sequence that can turn to axis a at knot i.
    double cheapest_before(std::size_t i, std::size_t a, Search& search) const {
        double before = infinity;
        for (std::size_t b = 0; b < axes_.size(); ++b) {
            if (!(search.cost[b] < before)) continue;
            const double sum = search.cost[b] + turns_[a * axes_.size() + b];
            if (sum >= before) continue;
            before = sum;
            search.from[i][a] = int(b);
        }
        return before;
    }

    /// The axes of the run that ends before a knot.
    void choose_best(const Search& search, std::size_t end) {
        if (end == search.begin) return;
        const auto cheapest = std::min_element(search.cost.begin(), search.cost.end());
        int axis = *cheapest < infinity ? int(cheapest - search.cost.begin()) : -1;
        for (std::size_t i = end; i-- > search.begin && axis >= 0;) {
            knots_[i].axis = axis;
            axis = search.from[i][std::size_t(axis)];
        }
    }

    /// Ends the stretch that is being made.
    void cut() {
        if (run_.cl.size() > 1) {
            drop_idle();
            for (const CutterLocation& at : run_.cl)
                result_.largest = std::max(result_.largest, std::acos(std::min(at.axis.z(), 1.0)));
            result_.passes.push_back(in_.machine ? evened(run_) : run_);
            result_.kept.push_back(run_range_);
        }
        run_.cl.clear();
        run_.cc.clear();
        run_idle_.clear();
    }

    /// Takes out again what was put in where the axis does not turn.
    void drop_idle() {
        const auto same = [](const Vec3& a, const Vec3& b) {
            return (a - b).norm() < tolerance::figure_rounding;
        };
        std::size_t kept = 1;
        for (std::size_t i = 1; i < run_.cl.size(); ++i) {
            const Vec3& axis = run_.cl[i].axis;
            if (run_idle_[i] && i + 1 < run_.cl.size() && same(run_.cl[kept - 1].axis, axis)
                && same(axis, run_.cl[i + 1].axis))
                continue;
            run_.cl[kept] = run_.cl[i];
            run_.cc[kept++] = run_.cc[i];
        }
        run_.cl.resize(kept);
        run_.cc.resize(kept);
    }

    /// With further locations on its motions, which stay as they were checked.
    Pass evened(const Pass& run) const {
        const EvenMotion motion(*in_.machine, radius_, even_tilt_share * in_.chord);
        Pass all = run;
        all.cl.clear();
        all.cc.clear();
        for (std::size_t i = 0; i < run.cl.size(); ++i) {
            if (i > 0)
                for (const double t : motion.cuts(run.cl[i - 1], run.cl[i])) {
                    all.cl.push_back(location_on_route(run.cl[i - 1], run.cl[i], t));
                    all.cc.push_back(run.cc[i]);
                }
            all.cl.push_back(run.cl[i]);
            all.cc.push_back(run.cc[i]);
        }
        return all;
    }

    /// The pass with the axes that were chosen, turning evenly from knot to knot.
    void join(const Progress& progress) {
        run_ = pass_;
        run_.cl.clear();
        run_.cc.clear();
        for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
            progress.check();
            const Knot &a = knots_[i], &b = knots_[i + 1];
            const bool sure = a.axis >= 0 && b.axis >= 0
                              && axes_[std::size_t(a.axis)].dot(axes_[std::size_t(b.axis)])
                                     >= std::cos(max_tilt_turn) - tolerance::level_angle;
            if (sure) {
                join(a, b);
                continue;
            }
            result_.lost += b.length - a.length;
            if (result_.by == ToolBody::none) result_.by = body_at(pass_.cl[a.axis < 0 ? a.cl : b.cl]);
            cut();
        }
        cut();
    }

    /// How an axis turns between two knots: evenly; where that is not free, in the first half or in the
    /// second.
    enum class Turn { even, early, late };
    static double turned(Turn turn, double share) {
        if (turn == Turn::even) return share;
        return std::clamp(turn == Turn::early ? 2 * share : 2 * share - 1, 0.0, 1.0);
    }

    void join(const Knot& a, const Knot& b) {
        for (const Turn turn : {Turn::even, Turn::early, Turn::late})
            if (join(a, b, turn, true)) return;
        join(a, b, Turn::even, false);
    }

    /// `whole`: all of it or nothing; else what is not free is left out.
    bool join(const Knot& a, const Knot& b, Turn turn, bool whole) {
        const CutterLocation from{Vec3::Zero(), axes_[std::size_t(a.axis)]},
            to{Vec3::Zero(), axes_[std::size_t(b.axis)]};
        const std::size_t before = run_.cl.size();
        const Interval range = run_range_;
        double length = a.length;
        for (std::size_t k = a.cl; k <= b.cl; ++k) {
            if (k > a.cl) length += (pass_.cl[k].tip - pass_.cl[k - 1].tip).norm();
            if (k == a.cl && !run_.cl.empty()) continue; // the end of the stretch before
            const double t =
                b.length > a.length ? std::min((length - a.length) / (b.length - a.length), 1.0) : 1;
            CutterLocation at;
            double raise = 0;
            const bool stands = stand(k, location_on_route(from, to, turned(turn, t)).axis, at, raise),
                       free = stands
                              && (run_.cl.empty()
                                  || between(CutterLocation(run_.cl.back()), at, pass_.cc[k], 0));
            if (!free && whole) {
                shorten(before);
                run_range_ = range;
                return false;
            }
            if (!free) {
                if (k > 0) result_.lost += (pass_.cl[k].tip - pass_.cl[k - 1].tip).norm();
                if (result_.by == ToolBody::none) result_.by = body_at(pass_.cl[k]);
                cut();
            }
            if (stands) add(k, at, length, raise);
        }
        return true;
    }

    void add(std::size_t k, const CutterLocation& at, double length, double raise) {
        if (run_.cl.empty()) run_range_.lo = length;
        run_range_.hi = length;
        run_.cl.push_back(at);
        run_.cc.push_back(pass_.cc[k]);
        // Drawn out of something, it is on no straight line any more.
        run_idle_.push_back(char(put_in_[k] && raise == 0));
    }
    void shorten(std::size_t size) {
        run_.cl.resize(size);
        run_.cc.resize(size);
        run_idle_.resize(size);
    }

    /// Puts in what stands between two locations; false where the motion between them is not clear.
    bool between(const CutterLocation& a, const CutterLocation& b, const CutterContact& cc, int divisions) {
        if (!bulges(a, b)
            && keeps_clear_between(*in_.whole, a, b, looking_step(radius_, in_.chord),
                                   in_.looked_share * in_.chord, hint_))
            return true;
        if (divisions == max_tilt_divisions) return false;
        CutterLocation middle = location_on_route(a, b, 0.5);
        // The middle of a ball stays on its way.
        if (ball_ > 0) middle.tip += ball_ * (0.5 * (a.axis + b.axis) - middle.axis);
        const double lift = in_.whole->lift({middle.tip, middle.axis}, hint_);
        if (lift > in_.raise) return false;
        if (lift > 0) middle.tip += lift * middle.axis;
        const std::size_t size = run_.cl.size();
        if (between(a, middle, cc, divisions + 1)) {
            run_.cl.push_back(middle);
            run_.cc.push_back(cc);
            run_idle_.push_back(0);
            if (between(middle, b, cc, divisions + 1)) return true;
        }
        shorten(size);
        return false;
    }

    /// Whether a ball's middle leaves its way where the tip moves straight and the axis turns.
    bool bulges(const CutterLocation& a, const CutterLocation& b) const {
        const double half =
            std::sqrt(std::max(0.0, 0.5 * (1 + a.axis.dot(b.axis)))); // cosine of half the turn
        return ball_ * (1 - half) > bulge_share * in_.chord;
    }

    const TiltInput& in_;
    Pass pass_;
    std::vector<char> put_in_; ///< locations of the pass that it had not
    double radius_, ball_;
    ToolLift::Hint hint_;
    std::vector<Vec3> axes_;
    std::vector<double> tilts_, turns_; ///< of each from +Z; what a turn from one to another costs
    std::vector<Knot> knots_;
    Pass run_;                   ///< the stretch that is being made
    std::vector<char> run_idle_; ///< locations that it does without where the axis stays as it is
    Interval run_range_;         ///< of the pass's length
    TiltedPass result_;
};

} // namespace

double body_step(const Tool& tool, double chord) {
    double thinnest = tool.shank_length > 0 ? tool.shank_diameter : infinity;
    for (const HolderSection& s : tool.holder)
        thinnest = std::min(thinnest, s.diameter);
    return std::sqrt(4 * thinnest * chord);
}

double ball_radius(const CutterProfile& cutter) {
    return cutter.cutter().e == 0 ? cutter.cutter().r : 0;
}

bool turned_about_contact(const CutterProfile& cutter, const CutterContact& contact, const Vec3& tip,
                          const Vec3& axis, CutterLocation& turned) {
    turned.axis = axis;
    const double r = cutter.cutter().r;
    if (r == cutter.max_radius()) {
        // A ball touches planes of every slope at the same distance from its middle.
        turned.tip = tip + r * (Vec3::UnitZ() - axis);
        return true;
    }
    const Vec3& n = contact.normal;
    turned.tip = tip;
    if (axis == Vec3::UnitZ()) return true;
    if (!(n.z() > tolerance::vertical_normal_z) || !(n.dot(axis) > tolerance::vertical_normal_z))
        return false;
    turned.tip += tip_at_contact(cutter, contact.point, n, axis)
                  - tip_at_contact(cutter, contact.point, n, Vec3::UnitZ());
    return true;
}

TiltedPass tilted_where_held(const TiltInput& input, const Pass& pass, const Progress& progress) {
    if (pass.cl.size() < 2) return {};
    return Tilter(input, pass).run(progress);
}

} // namespace facetmill
