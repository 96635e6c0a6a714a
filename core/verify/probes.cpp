#include "core/verify/probes.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>

namespace facetmill {

namespace {

/// Angle between unit vectors.
double unit_angle(const Vec3& a, const Vec3& b) {
    return 2 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

// ---- BodySupport ----

BodySupport::BodySupport(const CutterProfile& cutter) {
    double angle = 0;
    for (const ProfilePiece& p : cutter.pieces()) {
        const double start = std::max(angle, p.angle_at_start());
        add(p.from, 0, angle, start);
        angle = std::max(start, p.angle_at_end());
        if (p.kind == ProfilePiece::Kind::arc) add(p.center, p.radius, start, angle);
    }
    add(cutter.pieces().back().to, 0, angle, pi);
    finish(cutter.max_radius(), 0, cutter.height());
}

BodySupport::BodySupport(const ToolSection& section) {
    add({section.radius, section.from}, 0, 0, 0.5 * pi);
    add({section.radius, section.to}, 0, 0.5 * pi, pi);
    finish(section.radius, section.from, section.to);
}

void BodySupport::add(const Vec2& center, double r, double from, double to) {
    // No more than an end of the one before or after, whose plane is the same.
    if (from == to) return;
    const auto at = [](double angle) { return Vec2(std::sin(angle), -std::cos(angle)); };
    features_.push_back({center, at(from), at(to), r});
}

void BodySupport::finish(double radius, double bottom, double top) {
    middle_ = bottom + std::min(radius, 0.5 * (top - bottom));
    reach_ = std::hypot(radius, std::max(std::abs(bottom), std::abs(top)));
}

BodySupport::Closest BodySupport::closest(const Vec3& point, const Vec3& axis) const {
    // The distance from a convex set is the largest over its supporting planes, and by symmetry over those
    // whose normal lies in the plane of point and axis.
    const double z = point.dot(axis);
    Closest found{infinity, Vec2(0, -1), 1, point - z * axis, 0};
    found.rho = found.across.norm();
    double most = -infinity;
    for (const Feature& f : features_) {
        const Vec2 d(found.rho - f.center.x(), z - f.center.y());
        if (cross(f.first, d) > 0 && cross(d, f.last) > 0) {
            const double length = d.norm();
            const bool nearest = length >= f.r; // the body's point next to one outside lies here
            if (!nearest && !(length - f.r > most)) continue;
            most = length - f.r;
            found.out = d;
            found.length = length;
            if (nearest) break;
        } else {
            const double a = f.first.dot(d), b = f.last.dot(d);
            if (!(std::max(a, b) - f.r > most)) continue;
            most = std::max(a, b) - f.r;
            found.out = a >= b ? f.first : f.last;
            found.length = 1;
        }
    }
    found.inside = -most;
    return found;
}

BodySupport::Plane BodySupport::Closest::plane(const Vec3& axis) const {
    if (rho > 0) {
        const double per = 1 / (length * rho);
        return {inside, (out.y() * rho * per) * axis + (out.x() * per) * across};
    }
    Vec3 n = (out.y() / length) * axis;
    if (out.x() != 0) n += (out.x() / length) * axis.unitOrthogonal();
    return {inside, n};
}

Vec3 BodySupport::support(const Vec3& direction, const Vec3& axis) const {
    const double up = direction.dot(axis);
    const Vec3 across = direction - up * axis;
    const double aside = across.norm();
    const Vec2 u(aside, up);
    double most = -infinity;
    Vec2 farthest(0, 0);
    for (const Feature& f : features_) {
        const bool round = cross(f.first, u) > 0 && cross(u, f.last) > 0;
        const Vec2 at = round ? Vec2(f.center + f.r * u)
                              : Vec2(f.center + f.r * (f.first.dot(u) >= f.last.dot(u) ? f.first : f.last));
        if (const double h = at.dot(u); h > most) {
            most = h;
            farthest = at;
        }
    }
    const Vec3 out = aside > 0 ? Vec3(across / aside) : axis.unitOrthogonal();
    return farthest.x() * out + farthest.y() * axis;
}

// ---- MotionTree ----

MotionTree::MotionTree(const VerifyProgram& program, const std::function<bool(MotionKind)>& counts,
                       const Progress& progress)
    : program_(&program), courses_(program, progress) {
    const auto& motions = program.motions->motions;
    std::vector<Node> leaves;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (i % 4096 == 0) progress.check();
        if (!counts(motions[i].kind)) continue;
        leaves.push_back(leaf(Index(i)));
        turns_ = turns_ || leaves.back().cone > 0;
    }
    if (leaves.empty()) return;
    nodes_.reserve(2 * leaves.size() - 1);
    lever_ = program.tool.cutter.height();
    for (const ToolSection& section : program.tool.sections)
        lever_ = std::max(lever_, section.to);
    lever_ *= 0.5;
    build(0, leaves.size(), leaves, progress);
}

/// Nothing is known of where the first motion comes from: it stands at its end.
const CutterLocation& MotionTree::from(Index motion) const {
    return program_->motions->motions[motion > 0 ? motion - 1 : 0].to;
}

MotionTree::Node MotionTree::leaf(Index motion) const {
    const CutterLocation &a = from(motion), &b = to(motion);
    Node node;
    node.motion = motion;
    Box3 box;
    box.add(a.tip);
    box.add(b.tip);
    if (a.axis == b.axis) {
        node.axis = a.axis;
    } else {
        node.axis = location_between(a, b, program_->turning, 0.5).axis;
        node.cone = std::max(unit_angle(a.axis, node.axis), unit_angle(b.axis, node.axis));
        if (program_->turning) { // arcs reach beyond their ends
            constexpr int pieces = 32;
            double sagitta = 0;
            CutterLocation before = a;
            for (int k = 1; k <= pieces; ++k) {
                const CutterLocation here = location_between(a, b, program_->turning, double(k) / pieces);
                const Vec3 middle = location_between(a, b, program_->turning, (k - 0.5) / pieces).tip;
                sagitta = std::max(sagitta, (middle - 0.5 * (before.tip + here.tip)).norm());
                box.add(here.tip);
                node.cone = std::max(node.cone, unit_angle(here.axis, node.axis));
                before = here;
            }
            box.lo.array() -= 2 * sagitta;
            box.hi.array() += 2 * sagitta;
            node.cone *= 1.05; // between the pieces' ends
        }
        if (courses_.differs(motion, AxisCourse::joint_linear)) {
            constexpr int looks = 16;
            double cone = 0;
            for (int k = 1; k < looks; ++k)
                cone = std::max(
                    cone, unit_angle(courses_.at(motion, AxisCourse::joint_linear, double(k) / looks).axis,
                                     node.axis));
            node.cone = std::max(node.cone, 1.1 * cone); // between them
        }
        node.cone += tolerance::level_angle;
    }
    node.lo = box.lo;
    node.hi = box.hi;
    node.size = (node.hi - node.lo).norm();
    return node;
}

/// Box of the tips, and a cone with all axes. From the leaves themselves: cones of cones would grow with
/// every level.
void MotionTree::bound(Node& node, const std::vector<Node>& leaves, std::size_t begin, std::size_t end) {
    const Node& first = leaves[begin];
    node.lo = first.lo;
    node.hi = first.hi;
    node.axis = first.axis;
    node.cone = first.cone;
    Vec3 sum = Vec3::Zero();
    bool same = true;
    for (std::size_t i = begin; i < end; ++i) {
        node.lo = node.lo.cwiseMin(leaves[i].lo);
        node.hi = node.hi.cwiseMax(leaves[i].hi);
        node.cone = std::max(node.cone, leaves[i].cone);
        same = same && leaves[i].axis == first.axis;
        sum += leaves[i].axis;
    }
    node.size = (node.hi - node.lo).norm();
    if (same) return;
    if (sum.norm() > tolerance::level_angle) node.axis = sum.normalized();
    node.cone = 0;
    for (std::size_t i = begin; i < end; ++i)
        node.cone = std::max(node.cone, unit_angle(leaves[i].axis, node.axis) + leaves[i].cone);
}

/// Halves by where the motions are farthest apart: their tips, or what their axes make of it.
Index MotionTree::build(std::size_t begin, std::size_t end, std::vector<Node>& leaves,
                        const Progress& progress) {
    const auto place = Index(nodes_.size());
    if (end - begin == 1) {
        nodes_.push_back(leaves[begin]);
        return place;
    }
    if (end - begin > 4096) progress.check();
    const auto key = [this](const Node& n, int k) {
        return k < 3 ? 0.5 * (n.lo[k] + n.hi[k]) : lever_ * n.axis[k - 3];
    };
    int widest = 0;
    double most = -1;
    for (int k = 0; k < (turns_ ? 6 : 3); ++k) {
        double lo = infinity, hi = -infinity;
        for (std::size_t i = begin; i < end; ++i) {
            const double x = key(leaves[i], k);
            lo = std::min(lo, x);
            hi = std::max(hi, x);
        }
        if (!(hi - lo > most)) continue;
        most = hi - lo;
        widest = k;
    }
    const std::size_t half = begin + (end - begin) / 2;
    const auto first = leaves.begin();
    std::nth_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(half), first + std::ptrdiff_t(end),
                     [&](const Node& a, const Node& b) {
                         const double x = key(a, widest), y = key(b, widest);
                         return x < y || (x == y && a.motion < b.motion);
                     });
    nodes_.emplace_back();
    bound(nodes_[place], leaves, begin, end);
    build(begin, half, leaves, progress);
    const Index right = build(half, end, leaves, progress);
    nodes_[place].right = right;
    return place;
}

// ---- MotionProbes ----

struct MotionProbes::Pose {
    double s0 = 0, s1 = 1;
    CutterLocation first, last;
};

MotionProbes::MotionProbes(TurnedBody body, BodySupport support, std::shared_ptr<const MotionTree> motions,
                           double bound)
    : body_(std::move(body)), support_(std::move(support)), tree_(std::move(motions)), bound_(bound),
      slack_(tree_->turns() ? std::max(bound, tolerance::probe_rounding) : tolerance::probe_rounding) {}

/// How far behind the nearest plane that the bodies of a node can have the line reaches: not above 0, nothing
/// is reached.
double MotionProbes::reaches(const MotionTree::Node& node, const Line& line) const {
    const Vec3 up = support_.middle() * node.axis;
    const double t = line.place(0.5 * (node.lo + node.hi) + up);
    const Vec3 x = line.at(t);
    const Vec3 tip = (x - up).cwiseMax(node.lo).cwiseMin(node.hi);
    const BodySupport::Closest closest = support_.closest(x - tip, node.axis);
    // A body that is turned by the cone's angle about its tip: so is the plane.
    const double stretch = line.far - line.near;
    const double turned =
        node.cone > 0 ? std::min(node.cone, 2.0) * ((x - tip).norm() + node.size + stretch) : 0;
    if (const double at_most = closest.inside + stretch + node.size + turned; !(at_most > 0)) return at_most;
    const BodySupport::Plane plane = closest.plane(node.axis);
    double most = line.max_inside(plane, t) + turned;
    for (int k = 0; k < 3; ++k)
        most += plane.normal[k] * ((plane.normal[k] > 0 ? node.hi[k] : node.lo[k]) - tip[k]);
    return most;
}

/// A plane between the body at a pose and the line's part, if they are apart and it is soon found; the
/// nearest one to the body from the line's point at t.
BodySupport::Plane MotionProbes::between(const CutterLocation& pose, const Line& line, double& t) const {
    const auto at = [&](double place) { return support_.nearest(line.at(place) - pose.tip, pose.axis); };
    t = line.place(pose.tip + support_.middle() * pose.axis);
    BodySupport::Plane plane = at(t);
    const auto done = [&] { return plane.inside >= 0 || line.max_inside(plane, t) <= 0; };
    if (done()) return plane;
    // The distance is convex along the line, its slope that of the plane: to where that is 0, by false
    // position.
    double from = t, to = t, slope = plane.normal.dot(line.n), from_slope = slope, to_slope = slope;
    t = slope > 0 ? line.near : line.far;
    for (int round = 0; round < 20; ++round) {
        plane = at(t);
        if (done()) break;
        slope = plane.normal.dot(line.n);
        if (round == 0) {
            if ((slope > 0) == (to_slope > 0))
                break; // the end is nearest, and its plane is between but for rounding
            (slope > 0 ? to : from) = t;
            (slope > 0 ? to_slope : from_slope) = slope;
        } else if (slope > 0) {
            to = t;
            to_slope = slope;
            from_slope *= 0.5; // so that no end stays for ever
        } else {
            from = t;
            from_slope = slope;
            to_slope *= 0.5;
        }
        const double next = from + (to - from) * (from_slope / (from_slope - to_slope));
        if (!(next > std::min(from, to) && next < std::max(from, to))) break;
        t = next;
    }
    return plane;
}

namespace {

/// What is left of a rectangle of places t on a line and shares s of a motion once half-planes are cut off.
class ShareRegion {
public:
    ShareRegion(double near, double far) {
        corners_[0] = {near, 0};
        corners_[1] = {far, 0};
        corners_[2] = {far, 1};
        corners_[3] = {near, 1};
        count_ = 4;
    }
    /// Keeps where value(t, s), which is linear, is above 0; false where that is nowhere.
    template <class Value>
    bool keep(const Value& value) {
        std::array<Vec2, max_corners> kept;
        std::size_t n = 0;
        double before = value(corners_[count_ - 1]);
        bool any = before > 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (n + 2 > kept.size()) return true; // made ragged by rounding: it stays as it was
            const double here = value(corners_[i]);
            const Vec2& last = corners_[i == 0 ? count_ - 1 : i - 1];
            if ((before > 0) != (here > 0))
                kept[n++] = last + before / (before - here) * (corners_[i] - last);
            if (here > 0) kept[n++] = corners_[i];
            any = any || here > 0;
            before = here;
        }
        if (!any) return false;
        corners_ = kept;
        count_ = n;
        return true;
    }
    Vec2 middle() const {
        Vec2 sum = Vec2::Zero();
        for (std::size_t i = 0; i < count_; ++i)
            sum += corners_[i];
        return sum / double(count_);
    }
    /// A half-plane cut off makes one corner more at most.
    static constexpr int max_cuts = 6;

private:
    static constexpr std::size_t max_corners = 4 + max_cuts + 1;
    std::array<Vec2, max_corners> corners_;
    std::size_t count_;
};

} // namespace

/// How deep a place of the line lies in the body at a share of a straight motion is concave over both: a
/// supporting plane bounds it everywhere, and leaves a smaller region to look into. False where one is soon
/// found to be empty.
bool MotionProbes::may_reach(Index motion, const Line& line) const {
    const CutterLocation &a = tree_->from(motion), &b = tree_->to(motion);
    const Vec3 up = support_.middle() * b.axis, route = b.tip - a.tip;
    const double square = route.squaredNorm(), t = line.place(0.5 * (a.tip + b.tip) + up);
    Vec2 at(t, square > 0 ? std::clamp((line.at(t) - up - a.tip).dot(route) / square, 0.0, 1.0) : 0.0);
    ShareRegion region(line.near, line.far);
    for (int cut = 0; cut < ShareRegion::max_cuts; ++cut) {
        const BodySupport::Plane plane = support_.nearest(line.at(at.x()) - a.tip - at.y() * route, b.axis);
        const Vec2 change(-plane.normal.dot(line.n), plane.normal.dot(route));
        const double inside = plane.inside - change.dot(at);
        if (!region.keep([&](const Vec2& x) { return inside + change.dot(x); })) return false;
        if (plane.inside > 0) return true;
        at = region.middle();
    }
    return true;
}

const SweepRays& RecentSweeps::of(const TurnedBody& body, Index motion, const StraightMove& move,
                                  const Vec3& direction) {
    auto& kept = kept_[motion % kept_.size()];
    if (!kept || kept->motion != motion || kept->body != &body || kept->direction != direction)
        kept.emplace(Sweep{&body, motion, direction, SweepRays(body, move, direction)});
    return kept->rays;
}

namespace {

bool accept(const Stretch& s, Index motion, double slack, LineProbe& probe) {
    if (s.empty() || !(s.lo < probe.value) || s.hi < std::min(0.0, probe.value) - slack) return false;
    probe = {s.lo, motion};
    return true;
}

} // namespace

bool MotionProbes::ask(Index motion, Line& line, LineProbe& probe, RecentSweeps* recent) const {
    const CutterLocation &a = tree_->from(motion), &b = tree_->to(motion);
    if (a.axis != b.axis) return ask_turning(motion, line, probe);
    if (!may_reach(motion, line)) return false;
    const StraightMove move{a.tip, b.tip, b.axis};
    const Stretch s =
        recent ? recent->of(body_, motion, move, line.n)(line.p) : SweepRays(body_, move, line.n)(line.p);
    if (!accept(s, motion, slack_, probe)) return false;
    line.set(probe.value, slack_);
    return true;
}

/// How a motion's part changes the pose at its middle. At share 1/2 + sigma of the part the tip has moved by
/// sigma `route` and the axis turned by 2 sigma `half` about `about`; both to within an error of second
/// order, which is measured at the middle.
class MotionProbes::TurnedPart {
public:
    TurnedPart(const Pose& part, const CutterLocation& middle, const Vec3& x)
        : middle_(middle), route_(part.last.tip - part.first.tip) {
        const Vec3 sum = part.first.axis + part.last.axis, turn = part.first.axis.cross(part.last.axis);
        const double sine = turn.norm();
        half_ = 0.5 * std::atan2(sine, part.first.axis.dot(part.last.axis));
        about_ = sine > 0 ? Vec3(turn / sine) : Vec3(Vec3::Zero());
        bulge_ = 1.1 * (middle.tip - 0.5 * (part.first.tip + part.last.tip)).norm();
        lever_ = (middle.tip - x).norm() + 0.5 * route_.norm() + bulge_;
        wobble_ = small() ? 1.1 * (middle.axis - sum.normalized()).norm() : pi;
    }
    /// Few degrees: then `swing` and `rest` say how far a plane comes.
    bool small() const { return half_ < 0.4; }
    double travel() const { return 0.5 * route_.norm() + bulge_; }
    /// No point within `more` of x moves farther against the body.
    double size(double more) const { return travel() + (half_ + wobble_) * (lever_ + more); }
    /// By first order, how far a plane through the pose comes towards a point.
    double swing(const Vec3& normal, const Vec3& point) const {
        return std::abs(0.5 * normal.dot(route_) + half_ * about_.cross(normal).dot(middle_.tip - point));
    }
    /// What is left beyond first order, for points within `more` of x.
    double rest(double more) const {
        const double lever = lever_ + more;
        return 0.5 * half_ * half_ * lever + 0.5 * half_ * route_.norm() + bulge_ + wobble_ * lever;
    }

private:
    const CutterLocation& middle_;
    Vec3 route_, about_;
    double half_ = 0, bulge_ = 0, lever_ = 0, wobble_ = 0;
};

bool MotionProbes::ask_turning(Index motion, Line& line, LineProbe& probe) const {
    const auto at = [&](double s) {
        return location_between(tree_->from(motion), tree_->to(motion), tree_->program().turning, s);
    };
    std::array<Pose, 64> open; // halving ends long before that depth
    std::size_t n = 0;
    open[n++] = {0, 1, tree_->from(motion), tree_->to(motion)};
    bool lowered = false;
    while (n > 0) {
        const Pose part = open[--n];
        const double s = 0.5 * (part.s0 + part.s1);
        const CutterLocation middle = at(s);
        double t;
        const BodySupport::Plane plane = between(middle, line, t);
        const Vec3 x = line.at(t);

        const TurnedPart turned(part, middle, x);
        const double stretch = line.far - line.near;
        if (turned.small()) {
            const double slope = plane.normal.dot(line.n);
            double most = -infinity;
            for (double end : {line.near, line.far})
                most = std::max(most,
                                plane.inside - slope * (end - t) + turned.swing(plane.normal, line.at(end)));
            if (!(most + turned.rest(stretch) > 0)) continue;
        } else if ((x - middle.tip).norm() - stretch > support_.reach() + turned.travel()) {
            continue;
        }
        if (line.max_inside(plane, t) > 0) {
            const Mat3 frame = to_tool_frame(middle.axis);
            if (accept(body_.along(frame * (line.p - middle.tip), frame * line.n), motion, slack_, probe)) {
                line.set(probe.value, slack_);
                lowered = true;
            }
        }
        if (turned.size(line.far - line.near) <= bound_ || n + 2 > open.size()) continue;
        open[n++] = {part.s0, s, part.first, middle};
        open[n++] = {s, part.s1, middle, part.last};
    }
    return lowered;
}

/// Nodes that are still to be asked, the most promising first.
class MotionProbes::OpenNodes {
public:
    /// most(node) for those to begin with: asked if it is above `least`.
    template <class Most>
    OpenNodes(std::span<const Index> among, double least, const Most& most) {
        for (const Index node : among)
            if (const double m = most(node); m > least) open_[count_++] = {node, m};
        std::sort(open_.begin(), open_.begin() + std::ptrdiff_t(count_),
                  [](const Open& a, const Open& b) { return a.most < b.most; });
    }
    bool empty() const { return count_ == 0; }
    Open take() { return open_[--count_]; }
    void add_children(Open a, Open b, double least) {
        if (a.most > b.most) std::swap(a, b);
        if (a.most > least) open_[count_++] = a;
        if (b.most > least) open_[count_++] = b;
    }

private:
    std::array<Open, 128 + max_near> open_; // two a level, and the tree halves
    std::size_t count_ = 0;
};

std::vector<Index> MotionProbes::near(const Vec3& center, double radius, double depth) const {
    const auto& nodes = tree_->nodes_;
    const double least = depth - radius - tolerance::probe_rounding;
    std::vector<Index> leaves, level, next;
    const auto look = [&](std::vector<Index>& list, Index node) {
        if (max_depth(nodes[node], center, least) > least)
            (nodes[node].right == 0 ? leaves : list).push_back(node);
    };
    if (!nodes.empty()) look(level, 0);
    while (!level.empty()) {
        const std::size_t leaves_before = leaves.size();
        next.clear();
        for (const Index node : level) {
            look(next, node + 1);
            look(next, nodes[node].right);
        }
        if (next.size() + leaves.size() > max_near) {
            leaves.resize(leaves_before);
            break;
        }
        std::swap(level, next);
    }
    leaves.insert(leaves.end(), level.begin(), level.end());
    return leaves;
}

bool MotionProbes::lower(const Vec3& p, const Vec3& n, Index hint, LineProbe& probe,
                         std::span<const Index> among, RecentSweeps* recent) const {
    const auto& nodes = tree_->nodes_;
    if (nodes.empty()) return false;
    Line line{p, n};
    line.set(probe.value, slack_);
    bool lowered = hint != no_index && ask(hint, line, probe, recent);
    OpenNodes open(among, 0, [&](Index node) { return reaches(nodes[node], line); });
    bool stale = false; // what is open was judged by a higher value
    while (!open.empty()) {
        const Open top = open.take();
        const MotionTree::Node& node = nodes[top.node];
        if (stale && !(reaches(node, line) > 0)) continue;
        if (node.right == 0) {
            if (node.motion != hint && ask(node.motion, line, probe, recent)) lowered = stale = true;
            continue;
        }
        open.add_children({top.node + 1, reaches(nodes[top.node + 1], line)},
                          {node.right, reaches(nodes[node.right], line)}, 0);
    }
    return lowered;
}

// ---- depths of points ----

/// The most that p can lie inside the body in any motion of a node; roughly where that is not above `least`.
double MotionProbes::max_depth(const MotionTree::Node& node, const Vec3& p, double least) const {
    const Vec3 up = support_.middle() * node.axis;
    const Vec3 tip = (p - up).cwiseMax(node.lo).cwiseMin(node.hi);
    const BodySupport::Closest closest = support_.closest(p - tip, node.axis);
    const double turned = node.cone > 0 ? std::min(node.cone, 2.0) * ((p - tip).norm() + node.size) : 0;
    if (const double at_most = closest.inside + node.size + turned; !(at_most > least)) return at_most;
    const BodySupport::Plane plane = closest.plane(node.axis);
    double most = plane.inside + turned;
    for (int k = 0; k < 3; ++k)
        most += plane.normal[k] * ((plane.normal[k] > 0 ? node.hi[k] : node.lo[k]) - tip[k]);
    return most;
}

/// Along a straight motion the depth is a concave function of the share s, and the supporting plane at a
/// share gives its tangent: the largest depth lies below where two tangents meet.
bool MotionProbes::ask_depth(Index motion, const Vec3& p, DepthProbe& probe) const {
    const CutterLocation &a = tree_->from(motion), &b = tree_->to(motion);
    if (a.axis != b.axis) {
        bool deeper = ask_depth_turning(motion, AxisCourse::great_circle, p, probe);
        for (const AxisCourse course : AxisCourses::others)
            if (tree_->courses_.differs(motion, course))
                deeper = ask_depth_turning(motion, course, p, probe) || deeper;
        return deeper;
    }
    const Vec3 route = b.tip - a.tip, from = p - a.tip;
    const double square = route.squaredNorm();
    struct Tangent {
        double s, depth, slope;
        double at(double share) const { return depth + slope * (share - s); }
    };
    const auto look = [&](double s) {
        const BodySupport::Plane plane = support_.nearest(from - s * route, b.axis);
        return Tangent{s, plane.inside, plane.normal.dot(route)};
    };
    bool deeper = false;
    const auto take = [&](const Tangent& t) {
        if (!(t.depth > probe.depth)) return;
        probe = {t.depth, motion, AxisCourse::great_circle};
        deeper = true;
    };
    double s =
        square > 0 ? std::clamp((from - support_.middle() * b.axis).dot(route) / square, 0.0, 1.0) : 0.0;
    Tangent here = look(s);
    if (std::max(here.at(0), here.at(1)) <= probe.depth) return false;
    take(here);
    std::optional<Tangent> rising, falling;
    constexpr int max_looks = 100; // halves at least every second time
    for (int look_count = 0; look_count < max_looks && here.slope != 0; ++look_count) {
        (here.slope > 0 ? rising : falling) = here;
        const double lo = rising ? rising->s : 0, hi = falling ? falling->s : 1;
        double bound = rising ? rising->at(hi) : falling->at(lo);
        double next = rising ? hi : lo; // the end of the motion, not yet looked at
        if (rising && falling) {
            next = (falling->at(0) - rising->at(0)) / (rising->slope - falling->slope);
            bound = rising->at(next);
            if (look_count % 2 == 1 || !(next > lo && next < hi)) next = 0.5 * (lo + hi);
        }
        if (bound <= probe.depth + tolerance::probe_rounding || !(hi > lo)) break;
        here = look(next);
        take(here);
        if (next == 0 && here.slope <= 0) break;
        if (next == 1 && here.slope >= 0) break;
    }
    return deeper;
}

bool MotionProbes::ask_depth_turning(Index motion, AxisCourse course, const Vec3& p,
                                     DepthProbe& probe) const {
    const auto at = [&](double s) { return tree_->courses_.at(motion, course, s); };
    std::array<Pose, 64> open; // halving ends long before that depth
    std::size_t n = 0;
    if (course == AxisCourse::joint_linear) {
        // What a part's middle says of it holds for parts that bend one way.
        constexpr int parts = 4;
        for (int k = 0; k < parts; ++k) {
            const double s0 = double(k) / parts, s1 = double(k + 1) / parts;
            open[n++] = {s0, s1, at(s0), at(s1)};
        }
    } else {
        open[n++] = {0, 1, tree_->from(motion), tree_->to(motion)};
    }
    bool deeper = false;
    while (n > 0) {
        const Pose part = open[--n];
        const double s = 0.5 * (part.s0 + part.s1);
        const CutterLocation middle = at(s);
        const BodySupport::Plane plane = support_.nearest(p - middle.tip, middle.axis);
        const TurnedPart turned(part, middle, p);
        const double comes = turned.small() ? turned.swing(plane.normal, p) + turned.rest(0) : turned.size(0);
        if (!(plane.inside + comes > probe.depth)) continue;
        if (plane.inside > probe.depth) {
            probe = {plane.inside, motion, course};
            deeper = true;
        }
        if (turned.size(0) <= bound_ || n + 2 > open.size()) continue;
        open[n++] = {part.s0, s, part.first, middle};
        open[n++] = {s, part.s1, middle, part.last};
    }
    return deeper;
}

Index MotionProbes::first_as_deep(const Vec3& p, const DepthProbe& probe) const {
    const auto& motions = tree_->program().motions->motions;
    Index first = probe.motion;
    while (first > 0
           && (motions[first - 1].kind == MotionKind::rapid) == (motions[first].kind == MotionKind::rapid)) {
        DepthProbe before{probe.depth - 2 * slack_ - tolerance::probe_rounding, no_index};
        if (!ask_depth(first - 1, p, before)) break;
        --first;
    }
    return first;
}

bool MotionProbes::deepen(const Vec3& p, Index hint, DepthProbe& probe, std::span<const Index> among) const {
    const auto& nodes = tree_->nodes_;
    if (nodes.empty()) return false;
    bool deeper = hint != no_index && ask_depth(hint, p, probe);
    const auto most = [&](Index node) { return max_depth(nodes[node], p, probe.depth); };
    OpenNodes open(among, probe.depth, most);
    while (!open.empty()) {
        const Open top = open.take();
        if (!(top.most > probe.depth)) continue;
        const MotionTree::Node& node = nodes[top.node];
        if (node.right == 0) {
            if (node.motion != hint) deeper = ask_depth(node.motion, p, probe) || deeper;
            continue;
        }
        open.add_children({top.node + 1, most(top.node + 1)}, {node.right, most(node.right)}, probe.depth);
    }
    return deeper;
}

} // namespace facetmill
