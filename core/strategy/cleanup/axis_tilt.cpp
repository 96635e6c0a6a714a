#include "core/strategy/cleanup/axis_tilt.h"

#include "core/base/tolerances.h"
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

class Tilter {
public:
    Tilter(const TiltInput& input, const Pass& pass)
        : in_(input), pass_(pass), radius_(input.whole->cutter().max_radius()) {}

    TiltedPass run(const Progress& progress) {
        bool held = false;
        for (std::size_t k = 0; k < pass_.cl.size() && !held; ++k) {
            if (k % 256 == 0) progress.check();
            held = body_at(pass_.cl[k]) != ToolBody::none;
        }
        if (!held) {
            result_.passes.push_back(pass_);
            return std::move(result_);
        }
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

    /// Shank or holder, where one is in the part.
    ToolBody body_at(const CutterLocation& at) {
        const ToolContact c = in_.whole->contact_above({at.tip, at.axis}, in_.chord, hint_);
        return c.body == ToolBody::shank || c.body == ToolBody::holder ? c.body : ToolBody::none;
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
    }

    /// Where the tool stands with this axis at a place of the pass, drawn out; false where it cannot.
    bool stand(std::size_t k, const Vec3& axis, CutterLocation& at, double& raise) {
        if (!turned_about_contact(in_.whole->cutter(), pass_.cc[k], pass_.cl[k].tip, axis, at)) return false;
        raise = std::max(0.0, in_.whole->lift({at.tip, at.axis}, hint_));
        if (raise > in_.raise) return false;
        at.tip += raise * axis;
        return true;
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
            const double tilt = std::acos(std::min(axes_[a].z(), 1.0));
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
            const double turn = std::acos(std::clamp(axes_[a].dot(axes_[b]), -1.0, 1.0));
            if (turn > max_tilt_turn) continue;
            const double sum = search.cost[b] + turn_weight * turn * turn;
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
        if (run_.cl.size() > 1) result_.passes.push_back(run_);
        run_.cl.clear();
        run_.cc.clear();
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

    void join(const Knot& a, const Knot& b) {
        const CutterLocation from{Vec3::Zero(), axes_[std::size_t(a.axis)]},
            to{Vec3::Zero(), axes_[std::size_t(b.axis)]};
        double length = a.length;
        for (std::size_t k = a.cl; k <= b.cl; ++k) {
            if (k > a.cl) length += (pass_.cl[k].tip - pass_.cl[k - 1].tip).norm();
            if (k == a.cl && !run_.cl.empty()) continue; // the end of the stretch before
            const double t =
                b.length > a.length ? std::min((length - a.length) / (b.length - a.length), 1.0) : 1;
            CutterLocation at;
            double raise = 0;
            if (!stand(k, location_on_route(from, to, t).axis, at, raise)) {
                if (k > 0) result_.lost += (pass_.cl[k].tip - pass_.cl[k - 1].tip).norm();
                if (result_.by == ToolBody::none) result_.by = body_at(pass_.cl[k]);
                cut();
                continue;
            }
            if (!run_.cl.empty() && !between(CutterLocation(run_.cl.back()), at, pass_.cc[k], 0)) {
                result_.lost += (at.tip - run_.cl.back().tip).norm();
                cut();
            }
            run_.cl.push_back(at);
            run_.cc.push_back(pass_.cc[k]);
            result_.largest = std::max(result_.largest, std::acos(std::min(at.axis.z(), 1.0)));
        }
    }

    /// Puts in what stands between two locations; false where the motion between them is not clear.
    bool between(const CutterLocation& a, const CutterLocation& b, const CutterContact& cc, int divisions) {
        if (keeps_clear_between(*in_.whole, a, b, looking_step(radius_, in_.chord),
                                in_.looked_share * in_.chord, hint_))
            return true;
        if (divisions == max_tilt_divisions) return false;
        CutterLocation middle = location_on_route(a, b, 0.5);
        const double lift = in_.whole->lift({middle.tip, middle.axis}, hint_);
        if (lift > in_.raise) return false;
        if (lift > 0) middle.tip += lift * middle.axis;
        const std::size_t size = run_.cl.size();
        if (between(a, middle, cc, divisions + 1)) {
            run_.cl.push_back(middle);
            run_.cc.push_back(cc);
            if (between(middle, b, cc, divisions + 1)) return true;
        }
        run_.cl.resize(size);
        run_.cc.resize(size);
        return false;
    }

    const TiltInput& in_;
    const Pass& pass_;
    double radius_;
    ToolLift::Hint hint_;
    std::vector<Vec3> axes_;
    std::vector<Knot> knots_;
    Pass run_; ///< the stretch that is being made
    TiltedPass result_;
};

} // namespace

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
