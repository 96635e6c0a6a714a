#include "core/strategy/finish3/gap_cusp.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Columns that a thread takes at a time.
constexpr std::size_t block_columns = 32;
/// From so many facets on it is worth to share out where there is something to cut.
constexpr std::size_t facets_shared = 100'000;
/// A lift that changes by more than this per unit sideways is looked at as a wall.
constexpr double wall_slope = 5;
/// Contacts of tips that move by less than this share of the distance between the tips stand still: an edge,
/// or nearly.
constexpr double still_share = 0.5;
/// Share of the allowed cusp; more than a line leaves on one flank a quarter of the step beside it.
constexpr double jump_share = 0.3;
/// Beside the place where the contact jumps from flank to flank the part is to be cut as far into the hollow
/// as the cutter that touches both leaves this share of the allowed cusp, as find_uncut has it.
constexpr double hollow_share = 0.25;
/// Halvings on the way into a hollow: to a hundredth of a percent of it.
constexpr int hollow_halvings = 14;
/// A flank whose normal rises by less has no surface that is known from above.
constexpr double steepest_hollow = 0.05;
/// Halvings between two such tips.
constexpr int deepest_between = 5;
bool inside(const std::vector<Interval>& intervals, double u, double slack) {
    for (const Interval& i : intervals)
        if (u >= i.lo - slack && u <= i.hi + slack) return true;
    return false;
}

/// What two lines leave where both leave the same, as far as two places tell: the first line leaves xa and xb
/// there, the second one ya and yb.
double crossing(double xa, double xb, double ya, double yb) {
    const double da = ya - xa, db = xb - yb;
    return da > 0 && db > 0 && da + db < infinity ? xa + (xb - xa) * da / (da + db) : 0;
}

/// The highest ridge between the rows of a column, from what the two lines leave at each.
double highest_ridge(const std::array<CuspField::Sample, 3>& s, const std::array<double, 3>& x,
                     const std::array<double, 3>& y) {
    double highest = 0;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        if (s[i].valid && s[i + 1].valid)
            highest = std::max(highest, crossing(x[i], x[i + 1], y[i], y[i + 1]));
    if (s[0].valid && s[1].valid)
        highest = std::max(highest, crossing(0, x[0], std::max(2 * y[0] - y[1], y[0]), y[0]));
    constexpr std::size_t l = 2;
    if (s[l].valid && s[l - 1].valid)
        highest = std::max(highest, crossing(x[l], std::max(2 * x[l] - x[l - 1], x[l]), y[l], 0));
    return highest;
}

std::array<double, 3> squared(const std::array<double, 3>& x) {
    return {x[0] * x[0], x[1] * x[1], x[2] * x[2]};
}

/// Just inside the ends of a range, so that there is something below.
double inset(const Interval& r) {
    return std::min(tolerance::border_inset, 0.1 * r.length());
}

} // namespace

GapCusp::GapCusp(const CuspField& field, const DriveLine* a, const DriveLine* b, double edge,
                 const Interval* within)
    : field_(field), in_(field.input()), a_(a), b_(b), v0_(a ? a->v : edge), v1_(b ? b->v : edge) {
    if (!(v1_ > v0_)) return;
    // Places are looked at within, and no farther beside it than rounding.
    const Interval near = within ? Interval{within->lo - in_.merge, within->hi + in_.merge} : Interval{};
    const auto line_at = [&](double v) { return in_.domain->line(v, in_.merge, within ? &near : nullptr); };
    std::vector<Interval> all;
    for (int i = 0; i < rows; ++i) {
        v_[i] = v0_ + 0.25 * (i + 1) * (v1_ - v0_);
        // At a border the outermost row lies on it, but for the rounding of the domain's ends.
        const double from_border = std::min(tolerance::border_inset, 0.01 * (v1_ - v0_));
        if (!a && i == 0) v_[i] = v0_ + from_border;
        if (!b && i == rows - 1) v_[i] = v1_ - from_border;
    }
    const bool large = in_.domain->usable_facets() > facets_shared;
    parallel_for(rows + 2, large ? 1 : rows + 2, Progress(), [&](std::size_t k) {
        if (k < rows) domain_[k] = line_at(v_[k]);
        if (k == rows && a) domain_a_ = line_at(a->v);
        if (k > rows && b) domain_b_ = line_at(b->v);
    });
    for (const std::vector<Interval>& row : domain_)
        all.insert(all.end(), row.begin(), row.end());
    place_columns(std::move(all), within);
}

void GapCusp::place_columns(std::vector<Interval> all, const Interval* within) {
    if (within) {
        for (Interval& r : all)
            r = {std::max(r.lo, within->lo), std::min(r.hi, within->hi)};
        std::erase_if(all, [](const Interval& r) { return !(r.lo <= r.hi); });
    }
    // The ends of every row, because a corner of the part may be narrower than the grid.
    for (const Interval& r : all)
        for (const double u : {r.lo + inset(r), r.hi - inset(r)})
            columns_.push_back({u, false});
    for (const Interval& r : joined(std::move(all), in_.merge)) {
        const auto n = std::size_t(std::ceil(r.length() / field_.spacing())) + 1;
        const double from = r.lo + inset(r), length = r.length() - 2 * inset(r);
        for (std::size_t i = 0; i < n; ++i)
            columns_.push_back({n == 1 ? from : from + length * (double(i) / double(n - 1)), i + 1 < n});
    }
}

std::vector<CuspAt> GapCusp::along(const Progress& progress) const {
    if (!(v1_ > v0_)) return {};
    std::vector<CuspAt> found(columns_.size());
    parallel_blocks(columns_.size(), block_columns, progress, [&](std::size_t begin, std::size_t end) {
        const std::vector<Found> block = look(begin, end, progress.part(0, 0));
        for (std::size_t c = begin; c < end; ++c)
            found[c] = {block[c - begin].u, block[c - begin].worst};
    });
    std::stable_sort(found.begin(), found.end(), [](const CuspAt& a, const CuspAt& b) { return a.u < b.u; });
    return found;
}

bool GapCusp::is_any_above(const Progress& progress) const {
    if (!(v1_ > v0_)) return false;
    // Mostly the rows alone tell.
    for (std::size_t begin = 0; begin < columns_.size(); begin += block_columns) {
        const std::size_t end = std::min(columns_.size(), begin + block_columns);
        const Block block = sampled(begin, end, progress);
        for (std::size_t c = begin; c < end; ++c)
            if (at_rows(c, block).worst > in_.cusp) return true;
    }
    return std::ranges::any_of(along(progress), [&](const CuspAt& c) { return c.cusp > in_.cusp; });
}

GapCusp::Block GapCusp::sampled(std::size_t begin, std::size_t end, const Progress& progress) const {
    if (end < columns_.size() && columns_[end - 1].joins_next) ++end;
    Block block;
    block.first = begin;
    block.samples.resize(end - begin);
    std::vector<Vec2> places;
    std::vector<Sample*> which;
    for (std::size_t c = begin; c < end; ++c)
        for (int i = 0; i < rows; ++i) {
            if (!inside(domain_[i], columns_[c].u, tolerance::contact_distance)) continue;
            places.emplace_back(columns_[c].u, v_[i]);
            which.push_back(&block.samples[c - begin][i]);
        }
    const std::vector<Sample> found = field_.samples(places, progress);
    for (std::size_t k = 0; k < found.size(); ++k)
        *which[k] = found[k];
    return block;
}

std::vector<GapCusp::Found> GapCusp::look(std::size_t begin, std::size_t end,
                                          const Progress& progress) const {
    Block block = sampled(begin, end, progress);
    std::vector<Found> columns(end - begin);
    for (std::size_t c = begin; c < end; ++c)
        columns[c - begin] = at_rows(c, block);
    look_between(pairs(columns, progress), columns, progress);
    for (std::size_t c = begin; c < end; ++c) {
        Found& found = columns[c - begin];
        if (!found.is_cut) continue;
        if (a_ && b_) look_at_ridges(found);
        look_at_walls(found, block);
        look_at_wall_ahead(found, c, block);
    }
    return columns;
}

GapCusp::Found GapCusp::at_rows(std::size_t column, const Block& block) const {
    Found found;
    found.u = columns_[column].u;
    found.s = block.at(column);
    found.a = field_.near(a_, found.u);
    found.b = field_.near(b_, found.u);
    for (int i = 0; i < rows; ++i) {
        const Sample& s = found.s[i];
        if (!s.valid) continue;
        const double ta = field_.entry(found.a, s.point, s.normal);
        const double tb = field_.entry(found.b, s.point, s.normal);
        found.worst = std::max(found.worst, std::min(ta, tb));
        found.x[i] = std::sqrt(ta);
        found.y[i] = std::sqrt(tb);
    }
    for (int i = 0; i + 1 < rows; ++i)
        found.still |=
            found.s[i].valid && found.s[i + 1].valid
            && (found.s[i + 1].point - found.s[i].point).norm() < still_share * (v_[i + 1] - v_[i]);
    found.is_cut = found.worst < infinity;
    return found;
}

/// The contact jumps in a hollow hardly wider than the cutter, and stands still on a convex edge; then the
/// surface lies between the outermost rows and the lines.
std::vector<GapCusp::Pair> GapCusp::pairs(const std::vector<Found>& columns, const Progress& progress) const {
    std::vector<Pair> all;
    std::vector<Vec2> places; // on the lines beside
    std::vector<std::size_t> asks;
    const auto is_met = [](const Sample& a, const Sample& b, double gap) {
        return a.valid && b.valid && (b.point - a.point).norm() > gap;
    };
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const Found& found = columns[c];
        // A sharp rim's contact jumps from side to side on any hollow surface.
        if (!found.is_cut || found.worst > in_.cusp || (field_.sharp() && !found.still)) continue;
        const double gap = (found.still ? in_.look.edge_gap : in_.look.jump_gap) * field_.level_step();
        for (int i = 0; i + 1 < rows; ++i)
            if (is_met(found.s[i], found.s[i + 1], gap))
                all.push_back({c, v_[i], v_[i + 1], found.s[i], found.s[i + 1], gap, deepest_between});
        // So it does where the contact jumps between them, and the line leaves more than on a flank.
        const auto beside_line = [&](const DriveLine* line, const std::vector<Interval>& domain, double root,
                                     double v, int row) {
            if (!line || !(found.still || root * root > jump_share * in_.cusp)) return;
            if (!found.s[row].valid || !inside(domain, found.u, tolerance::contact_distance)) return;
            asks.push_back(all.size());
            places.emplace_back(found.u, v);
            Pair pair{c, v, v_[row], {}, found.s[row], gap, deepest_between};
            if (row > 0) {
                std::swap(pair.v0, pair.v1);
                std::swap(pair.s0, pair.s1);
            }
            all.push_back(pair);
        };
        beside_line(a_, domain_a_, found.x[0], v0_, 0);
        beside_line(b_, domain_b_, found.y[rows - 1], v1_, rows - 1);
    }
    const std::vector<Sample> on_lines = field_.samples(places, progress);
    for (std::size_t k = 0; k < asks.size(); ++k) {
        Pair& pair = all[asks[k]];
        (pair.v0 == places[k].y() ? pair.s0 : pair.s1) = on_lines[k];
    }
    std::erase_if(all, [&](const Pair& p) { return !is_met(p.s0, p.s1, p.gap); });
    return all;
}

/// Halving by halving: the places of one are asked together.
void GapCusp::look_between(std::vector<Pair> pairs, std::vector<Found>& columns,
                           const Progress& progress) const {
    while (!pairs.empty()) {
        std::vector<Pair> open;
        std::vector<Vec2> places;
        for (const Pair& pair : pairs) {
            Found& found = columns[pair.found];
            if (found.worst > in_.cusp || !((pair.s1.point - pair.s0.point).norm() > pair.gap)) continue;
            if (pair.depth == 0) {
                found.worst = std::max(found.worst, at_jump(pair, found));
                continue;
            }
            open.push_back(pair);
            places.emplace_back(found.u, 0.5 * (pair.v0 + pair.v1));
        }
        const std::vector<Sample> middles = field_.samples(places, progress);
        pairs.clear();
        for (std::size_t i = 0; i < open.size(); ++i) {
            const Pair& pair = open[i];
            const Sample& s = middles[i];
            if (!s.valid) continue;
            Found& found = columns[pair.found];
            const double v = places[i].y();
            // The nearer line mostly says enough.
            const bool a_first = v - v0_ < v1_ - v;
            const double first = field_.entry(a_first ? found.a : found.b, s.point, s.normal);
            if (first > found.worst)
                found.worst =
                    std::max(found.worst,
                             std::min(first, field_.entry(a_first ? found.b : found.a, s.point, s.normal)));
            if (found.worst > in_.cusp) continue;
            pairs.push_back({pair.found, pair.v0, v, pair.s0, s, pair.gap, pair.depth - 1});
            pairs.push_back({pair.found, v, pair.v1, s, pair.s1, pair.gap, pair.depth - 1});
        }
    }
}

double GapCusp::at_jump(const Pair& pair, const Found& found) const {
    const Sample &s0 = pair.s0, &s1 = pair.s1;
    // Half-way: where both cutters leave the same, as far as the two places tell.
    const auto left = [&](const CuspField::Near& line, const Sample& s) {
        return field_.entry(line, s.point, s.normal);
    };
    const double a0 = left(found.a, s0), a1 = left(found.a, s1), b0 = left(found.b, s0),
                 b1 = left(found.b, s1);
    const double d0 = b0 - a0, d1 = a1 - b1;
    const double between = d0 > 0 && d1 > 0 && d0 + d1 < infinity ? a0 + (a1 - a0) * d0 / (d0 + d1) : 0;
    return field_.sharp() ? between : std::max(between, hollow(s0, s1, found, 0.5 * (pair.v0 + pair.v1)));
}

/// The cusp's ridge lies where both cutters leave the same. Beside a round cutter what is left grows with the
/// square of the distance, so roots run linearly; beside a sharp rim it grows with the distance.
void GapCusp::look_at_ridges(Found& found) const {
    const double root = highest_ridge(found.s, found.x, found.y);
    found.worst = std::max(found.worst, root * root);
    if (!field_.sharp()) return;
    found.worst = std::max(found.worst, highest_ridge(found.s, squared(found.x), squared(found.y)));
}

void GapCusp::look_at_walls(Found& found, Block& block) const {
    const double u = found.u;
    const auto& s = found.s;
    for (int i = 0; i + 1 < rows; ++i)
        if (s[i].valid && s[i + 1].valid
            && std::abs(s[i].tip_z - s[i + 1].tip_z) > std::max(wall_slope * (v_[i + 1] - v_[i]), in_.cusp))
            found.worst = std::max(found.worst, wall(Vec2(u, v_[i]), Vec2(u, v_[i + 1]), s[i].tip_z,
                                                     s[i + 1].tip_z, block.hints[i]));
    // Outermost rows against the lines themselves.
    const auto to_line = [&](const DriveLine* line, const std::vector<Interval>& on_line, int row) {
        if (!line || !s[row].valid || !inside(on_line, u, tolerance::contact_distance)) return;
        const double z = field_.height_on(*line, u);
        if (std::abs(z - s[row].tip_z) > std::max(wall_slope * std::abs(v_[row] - line->v), in_.cusp))
            found.worst = std::max(
                found.worst, wall(Vec2(u, line->v), Vec2(u, v_[row]), z, s[row].tip_z, block.hints[row]));
    };
    to_line(a_, domain_a_, 0);
    to_line(b_, domain_b_, rows - 1);
}

/// A wall across the passes, between this column and the next.
void GapCusp::look_at_wall_ahead(Found& found, std::size_t column, Block& block) const {
    const Sample& s = found.s[1];
    if (!s.valid || !columns_[column].joins_next) return;
    const double next = columns_[column + 1].u;
    if (!inside(domain_[1], next, tolerance::contact_distance)) return;
    const Sample& ahead = block.at(column + 1)[1];
    const double z = ahead.valid ? ahead.tip_z : in_.floor;
    if (std::abs(z - s.tip_z) > std::max(wall_slope * (next - found.u), in_.cusp))
        found.worst =
            std::max(found.worst, wall(Vec2(found.u, v_[1]), Vec2(next, v_[1]), s.tip_z, z, block.hints[1]));
}

double GapCusp::wall(Vec2 from, Vec2 to, double z_from, double z_to, LiftHint& hint) const {
    // Halve towards the middle height: on a steep wall this ends at a contact halfway down, at a jump on its
    // two sides.
    const double middle = 0.5 * (z_from + z_to), shortest = cusp_detail(in_.cusp);
    while ((to - from).norm() > shortest) {
        const Vec2 mid = 0.5 * (from + to);
        const Vec2 xy = in_.frame.xy(mid.x(), mid.y());
        const double z = field_.lift().tip_z(xy, hint);
        const bool with_from = (z > middle) == (z_from > middle);
        (with_from ? from : to) = mid;
        (with_from ? z_from : z_to) = z;
    }
    const bool from_high = z_from > z_to;
    const Vec2 high = from_high ? from : to;
    Sample top = field_.sample(high.x(), high.y(), hint);
    if (!top.valid) return 0;
    double worst = left_at(high.x(), top);
    if (std::abs(z_from - z_to) < wall_slope * shortest) return worst;
    const Vec2 xy = in_.frame.xy(high.x(), high.y());
    Vec2 side = xy - Vec2(top.point.x(), top.point.y());
    if (!(side.norm() > 0.5 * in_.cover->radius())) return worst; // not the cutter's side that touches
    side.normalize();
    top.point = Vec3(xy.x(), xy.y(), middle + in_.cover->shoulder())
                - in_.cover->radius() * Vec3(side.x(), side.y(), 0);
    top.normal = Vec3(side.x(), side.y(), 0);
    return std::max(worst, left_at(high.x(), top));
}

double GapCusp::hollow(const Sample& s0, const Sample& s1, const Found& found, double v) const {
    const Vec3 apart = s1.point - s0.point;
    if (!((s1.normal - s0.normal).dot(apart) < 0)) return 0; // a ridge
    const Vec2 xy = in_.frame.xy(found.u, v);
    const Vec3 seat(xy.x(), xy.y(), std::max(s0.tip_z, s1.tip_z));
    // A hollow that runs across the columns lies elsewhere half-way to the next.
    const Vec3 bottom = s0.normal.cross(s1.normal);
    const double du = std::abs(bottom.head<2>().dot(in_.frame.along)),
                 dv = std::abs(bottom.head<2>().dot(in_.frame.across));
    const double beside = du > 0 ? field_.spacing() * dv / du : infinity;
    return std::max(hollow_flank(s0, apart, seat, found, v, beside),
                    hollow_flank(s1, -apart, seat, found, v, beside));
}

double GapCusp::hollow_flank(const Sample& s, Vec3 inward, const Vec3& seat, const Found& found, double v,
                             double beside) const {
    inward -= inward.dot(s.normal) * s.normal;
    const double length = inward.norm();
    if (!(length > 0)) return 0;
    inward /= length;
    const auto entry_at = [&](double w) {
        return in_.cover->ray_entry(s.point + w * inward, s.normal, seat, 2 * in_.cover->radius());
    };
    double lo = 0, hi = length;
    for (int i = 0; i < hollow_halvings; ++i) {
        const double mid = 0.5 * (lo + hi);
        (entry_at(mid) <= hollow_share * in_.cusp ? lo : hi) = mid;
    }
    // On the part, which may be round.
    Vec3 p = s.point + lo * inward;
    if (s.normal.z() > steepest_hollow) {
        const double z = field_.surface_z(p.x(), p.y()) + in_.allowance / s.normal.z();
        if (z > p.z()) p.z() = z;
    }
    const double by_a = field_.entry(found.a, p, s.normal), by_b = field_.entry(found.b, p, s.normal);
    const double worst = std::min(by_a, by_b);
    if (!a_ || !b_ || !(by_a < infinity && by_b < infinity)) return worst;
    // What a line leaves grows with its distance from the place, from what the cutter there leaves.
    const double least = hollow_share * in_.cusp;
    const double rise_a = (by_a - least) / (v - a_->v), rise_b = (by_b - least) / (b_->v - v);
    if (!(rise_a > 0 && rise_b > 0)) return worst;
    const double at = std::clamp((rise_a * a_->v + rise_b * b_->v) / (rise_a + rise_b),
                                 std::max(a_->v, v - beside), std::min(b_->v, v + beside));
    return std::max(worst, least + std::min(rise_a * (at - a_->v), rise_b * (b_->v - at)));
}

} // namespace facetmill
