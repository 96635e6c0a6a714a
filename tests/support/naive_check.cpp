#include "tests/support/naive_check.h"

#include "core/base/parallel.h"
#include "tests/support/naive_grid.h"

#include <map>
#include <set>

namespace facetmill::test {

namespace {

/// The cutter's outline, distances to which are depths.
class Body {
public:
    explicit Body(const AptCutter& cutter)
        : profile_(cutter), radius_(profile_.max_radius()), height_(profile_.height()) {}
    double radius() const { return radius_; }
    double height() const { return height_; }
    bool holds(double rho_square, double z) const {
        if (z < 0 || z > height_ || rho_square > radius_ * radius_) return false;
        const double rho = std::sqrt(rho_square);
        return z >= profile_.height_at(rho) && rho <= profile_.radius_at(z);
    }
    /// How deep a point is that it holds.
    double depth(double rho, double z) const {
        double least = height_ - z;
        for (const ProfilePiece& piece : profile_.pieces())
            least = std::min(least, distance(piece, Vec2(rho, z)));
        return least;
    }

private:
    static double distance(const ProfilePiece& piece, const Vec2& p) {
        const double ends = std::min((p - piece.from).norm(), (p - piece.to).norm());
        if (piece.kind == ProfilePiece::Kind::line) {
            const Vec2 d = piece.to - piece.from;
            const double t = (p - piece.from).dot(d) / d.squaredNorm();
            return t > 0 && t < 1 ? (p - piece.from - t * d).norm() : ends;
        }
        const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
        const Vec2 a = piece.from - piece.center, b = piece.to - piece.center, q = p - piece.center;
        return cross(a, q) >= 0 && cross(q, b) >= 0 ? std::abs(piece.radius - q.norm()) : ends;
    }
    CutterProfile profile_;
    double radius_, height_;
};

struct Pose {
    Vec3 tip, axis;
    std::uint32_t program = 0;
    bool cuts = false;
};

/// Where a tool may be between two locations, and how far the axis has turned.
Vec3 axis_between(const Vec3& a, const Vec3& b, double s, AxisCourse course) {
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (course == AxisCourse::normalized_linear || angle < 1e-9) return ((1 - s) * a + s * b).normalized();
    return ((std::sin((1 - s) * angle) * a + std::sin(s * angle) * b) / std::sin(angle)).normalized();
}

Vec3 turned(const Vec3& v, const Vec3& about, double angle) {
    return std::cos(angle) * v + std::sin(angle) * about.cross(v)
           + (1 - std::cos(angle)) * about.dot(v) * about;
}

/// The pose between two locations where the part turns: the way that is left when the turn is taken back, and
/// as much of the turn.
CutterLocation location_between(const CutterLocation& a, const CutterLocation& b, double s, double turn,
                                const TurningAxis& about) {
    const Vec3 from = a.tip - about.point, to = turned(Vec3(b.tip - about.point), about.direction, -turn);
    return {about.point + turned(Vec3(from + s * (to - from)), about.direction, s * turn),
            turned(a.axis, about.direction, s * turn)};
}
/// How far the axis turns about a line from one location to the next.
double turn_between(const CutterLocation& a, const CutterLocation& b, const TurningAxis& about) {
    const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(about.direction) * about.direction); };
    const Vec3 from = across(a.axis), to = across(b.axis);
    return std::atan2(about.direction.dot(from.cross(to)), from.dot(to));
}

class Check {
public:
    Check(const Mesh& part, std::span<const NaiveProgram> programs, const NaiveOptions& options)
        : part_(part), facets_(part), options_(options), programs_(programs) {
        for (const NaiveProgram& p : programs) {
            bodies_.emplace_back(p.cutter);
            radius_ = std::max(radius_, bodies_.back().radius());
            least_radius_ = std::min(least_radius_, bodies_.back().radius());
        }
        for (std::size_t i = 0; i < programs.size(); ++i)
            add_poses(i);
        sample();
    }

    NaiveResult run(const Progress& progress) {
        mark_to_cut(progress.part(0, 0.1));
        spread_poses();
        parallel_blocks(result_.samples.size(), 64, progress.part(0.1, 0.8),
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i)
                                look(result_.samples[i], i);
                        });
        result_.program_gouges.assign(programs_.size(), 0);
        for (std::size_t i = 0; i < result_.samples.size(); ++i) {
            const NaiveSample& s = result_.samples[i];
            if (s.depth > result_.gouge_max) {
                result_.gouge_max = s.depth;
                result_.gouge_at = s.point;
            }
            double& of_program = result_.program_gouges[gouged_by_[i]];
            of_program = std::max(of_program, s.depth);
            if (!s.to_cut) continue;
            result_.area_to_cut += s.weight;
            if (s.uncut) result_.uncut_area += s.weight;
        }
        measure_air(progress.part(0.8, 1.0));
        result_.poses = poses_.size();
        return std::move(result_);
    }

private:
    template <class Visit>
    void each_pose(std::size_t program, double share, const Visit& visit) const {
        const auto& motions = programs_[program].motions;
        const Body& body = bodies_[program];
        const double step = share * body.radius(), reach = body.height() + body.radius();
        const auto& about = programs_[program].turning;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            const CutterLocation &a = motions[i > 0 ? i - 1 : 0].to, &b = motions[i].to;
            const double turn = std::atan2(a.axis.cross(b.axis).norm(), a.axis.dot(b.axis));
            const double swing = about && turn > 0 ? turn_between(a, b, *about) : 0;
            const double arm = swing != 0 ? (a.tip - about->point).norm() : 0;
            const double way = (b.tip - a.tip).norm() + std::max(turn, std::abs(swing)) * (reach + arm);
            const int pieces = std::max(1, int(std::ceil(way / step)));
            CutterLocation last = a;
            for (int k = 1; k <= pieces; ++k) {
                const double s = double(k) / pieces;
                CutterLocation at{a.tip + s * (b.tip - a.tip), b.axis};
                if (swing != 0)
                    at = location_between(a, b, s, swing, *about);
                else if (turn != 0)
                    at.axis = axis_between(a.axis, b.axis, s, options_.course);
                visit(i, at.tip, at.axis, (at.tip - last.tip).norm());
                last = at;
            }
        }
    }
    void add_poses(std::size_t program) {
        each_pose(program, options_.pose_share,
                  [&](std::size_t number, const Vec3& tip, const Vec3& axis, double) {
                      const Motion& motion = programs_[program].motions[number];
                      poses_.push_back({tip, axis, std::uint32_t(program), motion.kind != MotionKind::rapid});
                      if (motion.kind == MotionKind::rapid) return;
                      constexpr double apart = 0.996; // five degrees
                      if (std::none_of(axes_.begin(), axes_.end(),
                                       [&](const Vec3& a) { return a.dot(axis) > apart; }))
                          axes_.push_back(axis);
                  });
    }

    void sample() {
        for (std::size_t f = 0; f < part_.facet_count(); ++f) {
            const Vec3 n = part_.facet_normal(f);
            if (n.isZero(0)) continue;
            int longest = 0;
            std::array<double, 3> edge;
            for (int k = 0; k < 3; ++k) {
                edge[std::size_t(k)] = (part_.corner(f, (k + 1) % 3) - part_.corner(f, k)).norm();
                if (edge[std::size_t(k)] > edge[std::size_t(longest)]) longest = k;
            }
            const Vec3 a = part_.corner(f, longest), b = part_.corner(f, (longest + 1) % 3),
                       c = part_.corner(f, (longest + 2) % 3);
            const double area = 0.5 * part_.facet_cross(f).norm(), length = edge[std::size_t(longest)];
            const int columns = int(length / options_.spacing) + 1,
                      rows = int(2 * area / length / options_.spacing) + 1;
            double weight = 0;
            for (int j = 0; j < rows; ++j)
                weight += (1 - (j + 0.5) / rows) * columns;
            for (int j = 0; j < rows; ++j)
                for (int i = 0; i < columns; ++i) {
                    const double t = (j + 0.5) / rows, s = (i + 0.5) / columns;
                    result_.samples.push_back(
                        {a + t * (c - a) + s * (1 - t) * (b - a), n, area * (1 - t) / weight});
                }
            for (int k = 0; k < 3; ++k) {
                const int steps = int(edge[std::size_t(k)] / options_.spacing) + 1;
                for (int i = 0; i < steps; ++i)
                    result_.samples.push_back(
                        {part_.corner(f, k)
                             + double(i) / steps * (part_.corner(f, (k + 1) % 3) - part_.corner(f, k)),
                         n, 0});
            }
        }
    }

    /// Points along edges with one facet, by squares.
    std::map<std::pair<int, int>, std::vector<Vec3>> border_points() const {
        std::map<std::pair<Index, Index>, int> count;
        for (const Facet& f : part_.facets)
            for (std::size_t k = 0; k < 3; ++k)
                ++count[std::minmax(f[k], f[(k + 1) % 3])];
        std::map<std::pair<int, int>, std::vector<Vec3>> points;
        for (const auto& [e, n] : count) {
            if (n != 1) continue;
            const Vec3 &a = part_.vertices[e.first], &b = part_.vertices[e.second];
            const int steps = int((b - a).norm() / (0.25 * radius_)) + 1;
            for (int i = 0; i <= steps; ++i) {
                const Vec3 p = a + double(i) / steps * (b - a);
                points[square(p)].push_back(p);
            }
        }
        return points;
    }
    std::pair<int, int> square(const Vec3& p) const {
        return {int(std::floor(p.x() / radius_)), int(std::floor(p.y() / radius_))};
    }
    /// Whether no edge is run through twice in the same direction: then all facets have the same outside.
    bool wound_alike() const {
        std::set<std::pair<Index, Index>> run;
        for (const Facet& f : part_.facets)
            for (std::size_t k = 0; k < 3; ++k)
                if (!run.insert({f[k], f[(k + 1) % 3]}).second) return false;
        return true;
    }
    /// Whether a tool axis sees the sample on its front (1) or its back (-1).
    bool seen(const NaiveSample& s, double side) const {
        constexpr double upright = 1e-3;
        const double start = 1e-6 * part_.box().size().norm();
        return std::any_of(axes_.begin(), axes_.end(), [&](const Vec3& axis) {
            return side * axis.dot(s.normal) > upright && facets_.open(s.point, axis, start);
        });
    }
    /// Where facets are wound alike only the side counts of which more is seen: through its open ends an axis
    /// may look into a hollow part.
    void mark_to_cut(const Progress& progress) {
        const auto border = border_points();
        constexpr std::uint8_t front = 1, back = 2;
        std::vector<std::uint8_t> sides(result_.samples.size(), 0);
        parallel_blocks(result_.samples.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const NaiveSample& s = result_.samples[i];
                if (s.weight == 0 || near_border(s.point, border)) continue;
                sides[i] = std::uint8_t((seen(s, 1) ? front : 0) | (seen(s, -1) ? back : 0));
            }
        });
        std::uint8_t counts = front | back;
        if (wound_alike()) {
            double of_front = 0, of_back = 0;
            for (std::size_t i = 0; i < sides.size(); ++i) {
                if (sides[i] & front) of_front += result_.samples[i].weight;
                if (sides[i] & back) of_back += result_.samples[i].weight;
            }
            counts = of_front >= of_back ? front : back;
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            NaiveSample& s = result_.samples[i];
            s.to_cut = (sides[i] & counts) != 0;
            if (s.to_cut && (sides[i] & counts & front) == 0) s.normal = -s.normal;
        }
    }
    bool near_border(const Vec3& p, const std::map<std::pair<int, int>, std::vector<Vec3>>& border) const {
        const auto [x, y] = square(p);
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const auto at = border.find({x + i, y + j});
                if (at == border.end()) continue;
                for (const Vec3& q : at->second)
                    if ((p - q).norm() < radius_) return true;
            }
        return false;
    }

    /// Poses by the squares of the XY plane that their bodies reach.
    void spread_poses() {
        squares_ = part_.box();
        squares_.lo.array() -= 1e-6;
        nx_ = std::size_t(squares_.size().x() / radius_) + 1;
        ny_ = std::size_t(squares_.size().y() / radius_) + 1;
        by_square_.assign(nx_ * ny_, {});
        const double margin = 2 * options_.tolerance;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            const Pose& pose = poses_[i];
            const Body& body = bodies_[pose.program];
            Box3 box;
            box.add(pose.tip);
            box.add(Vec3(pose.tip + body.height() * pose.axis));
            box.lo.array() -= body.radius() + margin;
            box.hi.array() += body.radius() + margin;
            if ((box.hi.array() < squares_.lo.array()).any() || (box.lo.array() > squares_.hi.array()).any())
                continue;
            for (std::size_t y = row(box.lo.y(), 1, ny_); y <= row(box.hi.y(), 1, ny_); ++y)
                for (std::size_t x = row(box.lo.x(), 0, nx_); x <= row(box.hi.x(), 0, nx_); ++x)
                    by_square_[y * nx_ + x].push_back(std::uint32_t(i));
        }
        gouged_by_.assign(result_.samples.size(), 0);
    }
    std::size_t row(double v, int k, std::size_t n) const {
        return std::min(std::size_t(std::max(0.0, (v - squares_.lo[k]) / radius_)), n - 1);
    }
    const std::vector<std::uint32_t>& poses_at(const Vec3& p) const {
        return by_square_[row(p.y(), 1, ny_) * nx_ + row(p.x(), 0, nx_)];
    }

    static constexpr int steps_to_uncut = 17; // of an eighth of the tolerance, and the sample itself
    void look(NaiveSample& s, std::size_t number) {
        const double step = options_.tolerance / 8, far = 2 * options_.tolerance;
        int removed = steps_to_uncut; // the first step that is
        for (const std::uint32_t k : poses_at(s.point)) {
            const Pose& pose = poses_[k];
            const Body& body = bodies_[pose.program];
            const Vec3 d = s.point - pose.tip;
            const double z = d.dot(pose.axis), square_all = d.squaredNorm(), rho_square = square_all - z * z;
            if (z < -far || z > body.height() + far
                || rho_square > (body.radius() + far) * (body.radius() + far))
                continue;
            if (body.holds(rho_square, z)) {
                const double depth = body.depth(std::sqrt(std::max(0.0, rho_square)), z);
                if (depth > s.depth) {
                    s.depth = depth;
                    gouged_by_[number] = pose.program;
                }
                if (pose.cuts) removed = 0;
            }
            if (!s.to_cut || !pose.cuts) continue;
            const double along = s.normal.dot(pose.axis), dn = d.dot(s.normal);
            for (int i = 1; i < removed; ++i) {
                const double t = i * step, zt = z + t * along;
                if (body.holds(square_all + 2 * t * dn + t * t - zt * zt, zt)) removed = i;
            }
        }
        if (s.to_cut && removed == steps_to_uncut) s.uncut = stands(s);
    }
    bool in_stock(const Vec3& p) const {
        if ((p.array() < options_.stock.lo.array() - 1e-6).any()
            || (p.array() > options_.stock.hi.array() + 1e-6).any())
            return false;
        if (options_.round_axis < 0) return true;
        Vec3 off = p - 0.5 * (options_.stock.lo + options_.stock.hi);
        off[options_.round_axis] = 0;
        return off.norm() <= options_.stock_radius + 1e-6;
    }
    /// A sample above which nothing is removed up to twice the tolerance: on goes the walk, until it is
    /// that far from all of the part, or in the open.
    bool stands(const NaiveSample& s) const {
        if (!in_stock(s.point)) return true;
        const double far = 2 * options_.tolerance, last = 40 * far;
        for (double t = far; t < last; t += 0.125 * far) {
            const Vec3 q = s.point + t * s.normal;
            if (!in_stock(q) || cut_at(q)) return false;
            if (facets_.farther_than(q, 0.999 * far)) return true;
        }
        return false;
    }
    bool cut_at(const Vec3& q) const {
        for (const std::uint32_t k : poses_at(q)) {
            const Pose& pose = poses_[k];
            const Vec3 d = q - pose.tip;
            const double z = d.dot(pose.axis);
            if (pose.cuts && bodies_[pose.program].holds(d.squaredNorm() - z * z, z)) return true;
        }
        return false;
    }

    /// Points of the stock a quarter of the smallest radius apart, taken away as the tools come.
    void measure_air(const Progress& progress) {
        const Box3& box = options_.stock;
        size_ = 0.25 * least_radius_;
        constexpr double most = 2e7;
        size_ = std::max(size_, std::cbrt(box.size().prod() / most));
        for (int k = 0; k < 3; ++k)
            n_[std::size_t(k)] = int(box.size()[k] / size_) + 1;
        cubes_.assign(at(n_[0] - 1, n_[1] - 1, n_[2] - 1) + 1, 0);
        for (int z = 0; z < n_[2]; ++z)
            for (int y = 0; y < n_[1]; ++y)
                for (int x = 0; x < n_[0]; ++x)
                    cubes_[at(x, y, z)] = in_stock(box.lo + size_ * Vec3(x, y, z)) ? 1 : 0;
        tops_.assign(std::size_t(n_[0]) * std::size_t(n_[1]), n_[2] - 1);
        for (const NaiveSample& s : result_.samples) {
            std::array<int, 3> c;
            for (int k = 0; k < 3; ++k)
                c[std::size_t(k)] =
                    std::clamp(int((s.point[k] - box.lo[k]) / size_ + 0.5), 0, n_[std::size_t(k)] - 1);
            cubes_[at(c[0], c[1], c[2])] |= 2;
        }
        result_.program_feed.assign(programs_.size(), 0);
        result_.program_air.assign(programs_.size(), 0);
        for (std::size_t p = 0; p < programs_.size(); ++p)
            each_pose(p, 0.25, [&](std::size_t i, const Vec3& tip, const Vec3& axis, double length) {
                if ((++looked_ & 0xFFF) == 0) progress.check();
                for (const NaiveBarrel& b : programs_[p].barrels)
                    touch(b, tip, axis, p, i);
                if (programs_[p].motions[i].kind == MotionKind::rapid) return;
                const auto kind = std::size_t(programs_[p].motions[i].kind);
                result_.feed_length += length;
                result_.feed_by_kind[kind] += length;
                result_.program_feed[p] += length;
                if (take_away(bodies_[p], tip, axis)) return;
                result_.air_length += length;
                result_.air_by_kind[kind] += length;
                result_.program_air[p] += length;
            });
    }
    /// The points that a cylinder on the axis may reach: from one number to the other in x, y and z.
    std::array<std::array<int, 3>, 2> around(const Vec3& low, const Vec3& high, double wide) const {
        std::array<std::array<int, 3>, 2> range;
        for (int k = 0; k < 3; ++k) {
            const double lo = std::min(low[k], high[k]) - wide - options_.stock.lo[k],
                         hi = std::max(low[k], high[k]) + wide - options_.stock.lo[k];
            range[0][std::size_t(k)] =
                int(std::clamp(std::ceil(lo / size_), 0.0, double(n_[std::size_t(k)])));
            range[1][std::size_t(k)] =
                int(std::clamp(std::floor(hi / size_), -1.0, double(n_[std::size_t(k)] - 1)));
        }
        return range;
    }
    /// Takes away what the cutter holds; false where it is in the air.
    bool take_away(const Body& body, const Vec3& tip, const Vec3& axis) {
        const double near = size_, wide = body.radius() + near;
        const auto [lo, hi] = around(tip, tip + body.height() * axis, wide);
        bool busy = false;
        for (int z = lo[2]; z <= hi[2]; ++z)
            for (int y = lo[1]; y <= hi[1]; ++y)
                for (int x = lo[0]; x <= hi[0]; ++x) {
                    std::uint8_t& cube = cubes_[at(x, y, z)];
                    if (cube == 0 || (busy && cube == 2)) continue;
                    const Vec3 d = options_.stock.lo + size_ * Vec3(x, y, z) - tip;
                    const double h = d.dot(axis), square = d.squaredNorm() - h * h;
                    if (h < -near || h > body.height() + near || square > wide * wide) continue;
                    busy = true;
                    if ((cube & 1) != 0 && body.holds(square, h)) cube &= 2;
                }
        return busy;
    }
    /// Points of the stock in a shank or holder. Each column is looked at no higher than what is left of it.
    void touch(const NaiveBarrel& barrel, const Vec3& tip, const Vec3& axis, std::size_t program,
               std::size_t motion) {
        // Poses apart leave cusps of a 128th of the cutter's radius on walls that its flutes have cut.
        const double rounding = 0.02 * bodies_[program].radius(), radius = barrel.radius - rounding;
        const auto [lo, hi] = around(tip + barrel.from * axis, tip + barrel.to * axis, radius);
        for (int y = lo[1]; y <= hi[1]; ++y)
            for (int x = lo[0]; x <= hi[0]; ++x) {
                int& top = tops_[std::size_t(y) * std::size_t(n_[0]) + std::size_t(x)];
                while (top >= 0 && (cubes_[at(x, y, top)] & 1) == 0)
                    --top;
                for (int z = std::min(hi[2], top); z >= lo[2]; --z) {
                    if ((cubes_[at(x, y, z)] & 1) == 0) continue;
                    const Vec3 p = options_.stock.lo + size_ * Vec3(x, y, z), d = p - tip;
                    const double h = d.dot(axis), square = d.squaredNorm() - h * h;
                    if (h < barrel.from || h > barrel.to || square > radius * radius) continue;
                    const double depth = std::min(
                        {h - barrel.from, barrel.to - h, barrel.radius - std::sqrt(std::max(0.0, square))});
                    if (depth <= std::max(rounding, result_.touch_max)) continue;
                    result_.touch_max = depth;
                    result_.touch_at = p;
                    result_.touch_program = program;
                    result_.touch_motion = motion;
                }
            }
    }
    std::size_t at(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(n_[1]) + std::size_t(y)) * std::size_t(n_[0]) + std::size_t(x);
    }

    const Mesh& part_;
    NaiveFacets facets_;
    NaiveOptions options_;
    std::span<const NaiveProgram> programs_;
    std::vector<Body> bodies_;
    double radius_ = 0, least_radius_ = infinity;
    std::vector<Pose> poses_;
    std::vector<Vec3> axes_;
    Box3 squares_;
    std::size_t nx_ = 1, ny_ = 1, looked_ = 0;
    /// Points of the stock, `size_` apart. 1: it is left; 2: a sample of the part is in the cube about it.
    std::vector<std::uint8_t> cubes_;
    std::vector<int> tops_; ///< nothing is left above this in a column of them
    std::array<int, 3> n_{1, 1, 1};
    double size_ = 1;
    std::vector<std::vector<std::uint32_t>> by_square_;
    std::vector<std::uint32_t> gouged_by_;
    NaiveResult result_;
};

} // namespace

NaiveResult naive_check(const Mesh& part, std::span<const NaiveProgram> programs, const NaiveOptions& options,
                        const Progress& progress) {
    return Check(part, programs, options).run(progress);
}

} // namespace facetmill::test
