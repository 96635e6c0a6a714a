#include "core/strategy/lathe/lathe_reach.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/surface/facet_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_block = 256, samples_per_check = 64, creases_per_block = 32,
                      facets_per_check = 8192;
/// Of the cutter's radius: samples are as far apart as hollows of the allowed depth are wide, within these.
constexpr double finest_share = 0.1, coarsest_share = 0.3;
/// More samples than that are not taken, one for every block of facets aside; of their spacing squared,
/// facets that are smaller share a sample.
constexpr double max_samples = 1e5, min_piece = 0.25;
/// Of what is allowed: a cutter that is so near touches; a fillet of so little takes nothing from the feed.
constexpr double touching = 0.02, min_fillet = 0.05;
/// Of the cutter's radius: distance of the places at which the cutter is lowered, once for all samples
/// around, and the last step of a search about a place. Of a block of samples, and of places.
constexpr double lattice_share = 1.0 / 8, last_step_share = 1.0 / 64;
constexpr double max_places = 1e6; ///< of the whole part; else they are farther apart
constexpr std::size_t doubtful_per_block = 64, stands_per_block = 64;
/// Directions of the search about a place; each round begins with a step of half the one before.
constexpr int directions = 8, max_moves = 40;
constexpr double golden_angle = 2.399963229728653;
/// Of a thorough search: places that it looks at, within so many radii of the cutter, and from how many of
/// the best it goes downhill; samples of a region that get one.
constexpr int spread = 96, best_starts = 3, max_again = 64;
constexpr double spread_share = 1.25;
/// Steps to the angle at which the cutter that touches a plane stands.
constexpr int angle_steps = 4;
/// Where between two turns a crease may lie, in advances; halvings of the advance that it allows, and the
/// least, as a share of that without it.
constexpr std::array<double, 3> shares{0.35, 0.5, 0.65};
constexpr int halvings = 6;
constexpr double smallest_share = 1.0 / 16;
/// Angles to either side at which the way out from a place is looked at.
constexpr int sights = 4;

struct Sample {
    double angle = 0, y = 0, area = 0, distance = 0; ///< where on the part; angle from 0 up to a turn
    double half = 0;                                 ///< of the side of the square that it stands for
    bool alone = false; ///< no other sample says how far what it stands for reaches
    bool sure = false;  ///< searched thoroughly
    Vec3 p = Vec3::Zero(), n = Vec3::Zero();
    LathePoint at; ///< the cutter where it came nearest
    UnreachedRegion::Why why = UnreachedRegion::Why::narrow;
};

struct Found {
    double area = 0, crease_cusp = 0;
    std::vector<Sample> doubtful; ///< not served where the cutter would touch the facet's plane
    std::vector<FeedLimit> limits;
};

/// Cells of the unrolled part are this many spacings wide: samples in neighbouring ones lie together.
constexpr double cell_spacings = 2;

class Search {
public:
    Search(const LatheCommon& s, const LatheField& field, const PlanContext& context, const LatheRange& range,
           double allowed, const ReachFeed& feed)
        : field_(field), frame_(field.frame()), mesh_(*context.part), range_(range), allowed_(allowed),
          feed_(feed), named_from_(s.start.is_number()), named_to_(s.stop.is_number()),
          needle_(context.contact,
                  CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height))) {
        const double radius = field.cover().radius();
        double area = 0;
        from_ = infinity;
        to_ = -infinity;
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            area += 0.5 * mesh_.facet_cross(f).norm();
            for (int k = 0; k < 3; ++k) {
                from_ = std::min(from_, frame_.along(mesh_.corner(f, k)));
                to_ = std::max(to_, frame_.along(mesh_.corner(f, k)));
            }
        }
        spacing_ =
            std::clamp(std::sqrt(2 * radius * allowed), finest_share * radius, coarsest_share * radius);
        spacing_ = std::max({spacing_, std::sqrt(area / max_samples), tolerance::smallest_extent});
    }

    double spacing() const { return spacing_; }

    Found facets(const Progress& progress) const {
        return parallel_reduce(
            mesh_.facet_count(), facets_per_block, Found(), progress,
            [&](std::size_t begin, std::size_t end) {
                Found found;
                LatheField::Hint hint;
                std::size_t looked = 0;
                double carried = 0; // area of facets too small for a sample each
                for (std::size_t f = begin; f < end; ++f) {
                    const Vec3 n = mesh_.facet_normal(f);
                    if (n == Vec3::Zero() || is_end(f, n)) continue;
                    const FacetRows rows(mesh_, f, spacing_);
                    found.area += rows.area();
                    const double whole = carried + rows.area();
                    carried = 0;
                    if (whole < min_piece * spacing_ * spacing_ && f + 1 < end) {
                        carried = whole;
                        continue;
                    }
                    const double scale = rows.area() > 0 ? whole / rows.area() : 0;
                    for (std::size_t row = 0; row < rows.rows(); ++row)
                        for (std::size_t column = 0; column < rows.columns(row); ++column) {
                            if (++looked % samples_per_check == 0) progress.check();
                            sample(rows.point(row, column), n, scale * rows.weight(row), false, hint,
                                   found.doubtful);
                        }
                }
                return found;
            },
            joined);
    }

    Found creases(const Progress& progress) const {
        const std::vector<Crease> all = find_creases(progress);
        // Where creases meet more stays than in their middles: creases filed under their ends.
        const std::size_t corners = mesh_.vertices.size();
        std::vector<std::size_t> first(corners + 1, 0);
        for (const Crease& c : all)
            for (const Index v : c.ends)
                ++first[v + 1];
        std::vector<Index> ends; // corners with creases
        for (std::size_t v = 0; v < corners; ++v) {
            if (first[v + 1] > 0) ends.push_back(Index(v));
            first[v + 1] += first[v];
        }
        progress.check();
        std::vector<std::size_t> meeting(2 * all.size()), next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const Index v : all[i].ends)
                meeting[next[v]++] = i;
        return parallel_reduce(
            all.size() + ends.size(), creases_per_block, Found(), progress,
            [&](std::size_t begin, std::size_t end) {
                Found found;
                LatheField::Hint hint;
                std::vector<Vec3> normals;
                for (std::size_t i = begin; i < end; ++i) {
                    if (i < all.size()) {
                        const Vec3 &a = mesh_.vertices[all[i].ends[0]], &b = mesh_.vertices[all[i].ends[1]];
                        const auto pieces = std::size_t((b - a).norm() / spacing_) + 1;
                        const double length = (b - a).norm() / double(pieces);
                        for (std::size_t k = 0; k < pieces; ++k)
                            hollow(a + (double(k) + 0.5) / double(pieces) * (b - a), all[i].normal, length,
                                   hint, found, progress);
                        continue;
                    }
                    const Index v = ends[i - all.size()];
                    normals.clear();
                    for (std::size_t k = first[v]; k < first[v + 1]; ++k)
                        for (const Vec3& n : all[meeting[k]].normal)
                            if (std::find(normals.begin(), normals.end(), n) == normals.end())
                                normals.push_back(n);
                    hollow(mesh_.vertices[v], normals, 0, hint, found, progress);
                }
                return found;
            },
            joined);
    }

    /// Leaves of samples without an area, which only say how far the cutter stays away, the farthest in every
    /// piece of the part as large as a sample's: in a fine mesh they lie much closer than those of facets.
    void thin_out(std::vector<Sample>& samples) const {
        std::map<std::array<std::int64_t, 2>, std::size_t> farthest;
        const auto piece = [&](const Sample& s) {
            return std::array<std::int64_t, 2>{std::int64_t(s.angle * away_of(s.p) / spacing_),
                                               std::int64_t(std::floor(s.y / spacing_))};
        };
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (samples[i].area > 0) continue;
            const auto [at, is_new] = farthest.try_emplace(piece(samples[i]), i);
            if (!is_new && samples[i].distance > samples[at->second].distance) at->second = i;
        }
        std::size_t left = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (samples[i].area > 0 || farthest.at(piece(samples[i])) == i)
                std::swap(samples[left++], samples[i]);
        samples.resize(left);
    }

    /// Those of the samples that no place serves, each with the distance at the best and the reason.
    std::vector<Sample> unreached(std::vector<Sample> doubtful, const Progress& progress) const {
        const Lattice lattice = lattice_around(doubtful, progress.part(0, 0.3));
        std::vector<char> served(doubtful.size(), 0);
        parallel_blocks(doubtful.size(), doubtful_per_block, progress.part(0.3, 1),
                        [&](std::size_t begin, std::size_t end) {
                            LatheField::Hint hint;
                            for (std::size_t i = begin; i < end; ++i)
                                served[i] = serve(doubtful[i], lattice, hint, progress);
                        });
        std::size_t left = 0;
        for (std::size_t i = 0; i < doubtful.size(); ++i)
            if (!served[i]) std::swap(doubtful[left++], doubtful[i]);
        doubtful.resize(left);
        return doubtful;
    }

    /// Looks for a better place than the sample has, from places all around it: downhill alone may end in a
    /// dip that is not the deepest. False where one serves it after all.
    bool search_again(Sample& s, LatheField::Hint& hint, const Progress& progress) const {
        const LathePlace straight = straight_over(s.p);
        const double radius = field_.cover().radius(), away = away_of(s.p);
        std::vector<std::pair<double, LathePlace>> starts;
        for (int k = 0; k < spread; ++k) {
            const double out = spread_share * radius * std::sqrt((k + 0.5) / spread);
            const LathePlace place{straight.angle + out * std::cos(k * golden_angle) / away,
                                   straight.y + out * std::sin(k * golden_angle)};
            const Rest here = rest(stand(place, hint), s.p, s.n);
            if (here.height <= allowed_) return false;
            starts.emplace_back(here.distance, place);
        }
        std::stable_sort(starts.begin(), starts.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        starts.resize(best_starts);
        starts.emplace_back(0, straight);
        for (const auto& [unused, start] : starts) {
            const Nearest found = nearest_from(start, 0.5 * radius, s.p, s.n, hint, progress);
            if (found.height <= allowed_) return false;
            s.distance = std::min(s.distance, found.distance - field_.allowance());
        }
        s.sure = true;
        return true;
    }

private:
    /// An edge between two facets with these normals, towards the tool, that is hollow.
    struct Crease {
        std::array<Index, 2> ends;
        std::array<Vec3, 2> normal;
    };

    /// A facet's edge: its higher corner, the facet, and the facet's third corner.
    struct Half {
        Index high, facet, across;
    };

    static Found joined(Found a, const Found& b) {
        a.area += b.area;
        a.doubtful.insert(a.doubtful.end(), b.doubtful.begin(), b.doubtful.end());
        a.limits.insert(a.limits.end(), b.limits.begin(), b.limits.end());
        a.crease_cusp = std::max(a.crease_cusp, b.crease_cusp);
        return a;
    }

    /// Lies in an end of the part and faces along the axis.
    bool is_end(std::size_t f, const Vec3& n) const {
        if (std::abs(n.dot(frame_.axis().direction)) < 1 - tolerance::level_angle) return false;
        const double slack = tolerance::same_shape * (to_ - from_);
        const double y = frame_.along(mesh_.corner(f, 0));
        return y < from_ + slack || y > to_ - slack;
    }

    std::vector<Crease> find_creases(const Progress& progress) const {
        // Filed under their lower corner.
        const std::size_t facets = mesh_.facet_count(), corners = mesh_.vertices.size();
        std::vector<std::size_t> first(corners + 1, 0);
        for (std::size_t f = 0; f < facets; ++f)
            for (std::size_t k = 0; k < 3; ++k)
                ++first[std::min(mesh_.facets[f][k], mesh_.facets[f][(k + 1) % 3]) + 1];
        for (std::size_t v = 0; v < corners; ++v)
            first[v + 1] += first[v];
        std::vector<Half> halves(3 * facets);
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for (std::size_t f = 0; f < facets; ++f) {
            if (f % facets_per_check == 0) progress.check();
            const Facet& v = mesh_.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = v[k], b = v[(k + 1) % 3];
                halves[next[std::min(a, b)]++] = {std::max(a, b), Index(f), v[(k + 2) % 3]};
            }
        }
        // The fillet of the largest ball that could be in the cutter.
        const double least = 1 + min_fillet * allowed_ / field_.cover().radius();
        std::vector<Crease> creases;
        for (std::size_t v = 0; v < corners; ++v) {
            if (v % facets_per_check == 0) progress.check();
            const auto begin = halves.begin() + std::ptrdiff_t(first[v]),
                       end = halves.begin() + std::ptrdiff_t(first[v + 1]);
            std::stable_sort(begin, end, [](const Half& a, const Half& b) { return a.high < b.high; });
            for (auto h = begin; h != end && h + 1 != end; ++h)
                if (h->high == (h + 1)->high) add_crease(Index(v), *h, *(h + 1), least, creases);
        }
        return creases;
    }

    void add_crease(Index low, const Half& h, const Half& other, double least,
                    std::vector<Crease>& creases) const {
        const Vec3 &a = mesh_.vertices[low], &b = mesh_.vertices[h.high];
        const Vec3 middle = 0.5 * (a + b), r = frame_.radial(angle_of(middle));
        std::array<Vec3, 2> n{mesh_.facet_normal(h.facet), mesh_.facet_normal(other.facet)};
        if (is_end(h.facet, n[0]) || is_end(other.facet, n[1])) return;
        for (Vec3& v : n)
            if (v.dot(r) < 0) v = -v;
        const double half_cosine = std::sqrt(std::max(0.5 * (1 + n[0].dot(n[1])), 0.0));
        if (half_cosine * least >= 1) return;
        if (!(n[0].dot(mesh_.vertices[other.across] - a) > 0)) return; // bulges
        creases.push_back({{low, h.high}, n});
    }

    /// Where the cutter stands that touches the plane through p with normal n; over p where it cannot.
    LathePlace place_over(const Vec3& p, const Vec3& n) const {
        const Vec3& d = frame_.axis().direction;
        LathePlace place{angle_of(p), 0};
        Vec3 tip = p;
        for (int k = 0; k < angle_steps; ++k) {
            const Vec3 a = frame_.tool_axis(place.angle), x = d.cross(a).normalized(), up = a.cross(x);
            const Vec3 local(n.dot(x), n.dot(up), n.dot(a));
            tip = p;
            if (local.z() >= tolerance::vertical_normal_z) {
                const Vec3 off = field_.cover().tip_offset(local);
                tip += field_.allowance() * n + off.x() * x + off.y() * up + off.z() * a;
            }
            const double rho = frame_.away(tip);
            if (!(rho > std::abs(frame_.offset()))) break;
            // Beside the centre line by the offset.
            place.angle = angle_of(tip) - std::asin(frame_.offset() / rho);
        }
        place.y = frame_.along(tip)
                  - std::tan(frame_.tilt()) * (tip - frame_.axis().point).dot(frame_.radial(place.angle));
        return place;
    }

    double angle_of(const Vec3& p) const {
        const Vec3 v = p - frame_.axis().point;
        return std::atan2(v.dot(frame_.axis().direction.cross(frame_.zero())), v.dot(frame_.zero()));
    }

    /// The cutter lowered at a place, or where the range ends before it, and its frame.
    struct Stand {
        LathePoint at;
        Vec3 tip = Vec3::Zero(), x = Vec3::Zero(), y = Vec3::Zero(), axis = Vec3::Zero();
        Vec3 local(const Vec3& v) const { return {v.dot(x), v.dot(y), v.dot(axis)}; }
    };
    Stand stand(LathePlace place, LatheField::Hint& hint) const {
        place.y = std::clamp(place.y, range_.from, range_.to);
        const LathePoint at = field_.point(place, hint);
        const CutterLocation tool = frame_.at(place, at.u);
        const Vec3 x = frame_.axis().direction.cross(tool.axis).normalized();
        return {at, tool.tip, x, tool.axis.cross(x), tool.axis};
    }

    /// What a cutter leaves over p along n, and how far it is from p.
    struct Rest {
        double height = infinity, distance = infinity; ///< above what the allowance leaves; from p
    };
    Rest rest(const Stand& tool, const Vec3& p, const Vec3& n) const {
        Rest r;
        const CutterCover& cover = field_.cover();
        r.distance = cover.distance(tool.local(p - tool.tip));
        const Vec3 normal = tool.local(n);
        if (normal.z() >= 0)
            r.height = cover.ray_entry(tool.local(p + field_.allowance() * n - tool.tip), normal,
                                       Vec3::Zero(), 2 * cover.radius());
        // A cutter that touches p may be passed by its own tangent. Behind a wall whose normal points the
        // other way, as those of bores do, it has not been at p at all.
        r.height = r.distance <= field_.allowance() + touching * allowed_
                       ? 0
                       : std::max(r.height, r.distance - field_.allowance());
        return r;
    }

    /// The place whose tool axis runs through p, or beside it where p is nearer to the turning axis than the
    /// offset.
    LathePlace straight_over(const Vec3& p) const {
        const double rho = frame_.away(p), offset = frame_.offset();
        const double angle =
            angle_of(p)
            - (rho > std::abs(offset) ? std::asin(offset / rho) : std::copysign(0.5 * pi, offset));
        const double out = (p - frame_.axis().point).dot(frame_.radial(angle));
        return {angle, frame_.along(p) - std::tan(frame_.tilt()) * out};
    }

    /// The place, of those that a search from `place` downhill in the distance comes to, that serves p, or
    /// that is nearest to it.
    struct Nearest : Rest {
        LathePoint at;
    };
    Nearest nearest_from(LathePlace place, double step, const Vec3& p, const Vec3& n, LatheField::Hint& hint,
                         const Progress& progress) const {
        const auto at = [&](const LathePlace& q) {
            const Stand tool = stand(q, hint);
            return Nearest{rest(tool, p, n), tool.at};
        };
        Nearest best = at(place);
        if (best.height <= allowed_) return best;
        const double away = away_of(p), last = last_step_share * field_.cover().radius();
        double first = 0;
        for (; step > 0.75 * last; step *= 0.5, first += golden_angle) {
            progress.check();
            bool moved = true;
            for (int moves = 0; moved && moves < max_moves; ++moves) {
                moved = false;
                for (int k = 0; k < directions; ++k) {
                    const double route = first + 2 * pi * k / directions;
                    const LathePlace next{place.angle + step * std::cos(route) / away,
                                          place.y + step * std::sin(route)};
                    const Nearest here = at(next);
                    if (here.height <= allowed_) return here;
                    if (here.distance >= best.distance - tolerance::contact_distance) continue;
                    best = here;
                    place = next;
                    moved = true;
                    break;
                }
            }
        }
        return best;
    }

    /// Radius at which a step to the side of the tool turns the part by step / radius.
    double away_of(const Vec3& p) const { return std::max(frame_.away(p), 0.5 * field_.cover().radius()); }

    /// The cutter lowered on an even grid over the unrolled part, as far as samples lie below.
    struct Lattice {
        std::int64_t around = 0, along = 0;
        double turn = 0, step = 0, from = 0; ///< between neighbours, radians and mm; y of the first
        std::vector<std::uint32_t> slot;     ///< of a place, in `stands`
        std::vector<Stand> stands;

        /// Calls visit(place's number) for all places that are less than `radius` beside the place.
        template <class Visit>
        void near(const LathePlace& place, double radius, double away, Visit&& visit) const {
            const auto lowest = std::int64_t(std::ceil((place.y - radius - from) / step)),
                       highest = std::int64_t(std::floor((place.y + radius - from) / step));
            for (std::int64_t j = std::max<std::int64_t>(lowest, 0); j <= std::min(highest, along - 1); ++j) {
                const double dy = from + double(j) * step - place.y;
                const double side = std::sqrt(std::max(radius * radius - dy * dy, 0.0)) / away;
                const auto left = std::int64_t(std::ceil((place.angle - side) / turn));
                auto right = std::int64_t(std::floor((place.angle + side) / turn));
                right = std::min(right, left + around - 1);
                for (std::int64_t i = left; i <= right; ++i)
                    visit(std::size_t(j * around + ((i % around) + around) % around));
            }
        }
    };

    Lattice lattice_around(std::span<const Sample> samples, const Progress& progress) const {
        Lattice lattice;
        if (samples.empty()) return lattice;
        constexpr std::uint32_t none = ~std::uint32_t(0), wanted = none - 1;
        const double radius = field_.cover().radius(), outside = std::max(field_.part_radius(), radius);
        const double step = std::max(lattice_share * radius,
                                     std::sqrt(2 * pi * outside * (range_.to - range_.from) / max_places));
        lattice.around = std::int64_t(2 * pi * outside / step) + 1;
        lattice.along = std::int64_t((range_.to - range_.from) / step) + 2;
        lattice.turn = 2 * pi / double(lattice.around);
        lattice.step =
            std::max((range_.to - range_.from) / double(lattice.along - 1), tolerance::smallest_extent);
        lattice.from = range_.from;
        lattice.slot.assign(std::size_t(lattice.around * lattice.along), none);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (i % samples_per_check == 0) progress.check();
            lattice.near(straight_over(samples[i].p), radius, away_of(samples[i].p),
                         [&](std::size_t k) { lattice.slot[k] = wanted; });
        }
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < lattice.slot.size(); ++k) {
            if (lattice.slot[k] == none) continue;
            lattice.slot[k] = std::uint32_t(places.size());
            places.push_back(k);
        }
        lattice.stands.resize(places.size());
        parallel_blocks(places.size(), stands_per_block, progress, [&](std::size_t begin, std::size_t end) {
            LatheField::Hint hint;
            for (std::size_t i = begin; i < end; ++i) {
                const auto k = std::int64_t(places[i]);
                lattice.stands[i] = stand({double(k % lattice.around) * lattice.turn,
                                           lattice.from + double(k / lattice.around) * lattice.step},
                                          hint);
            }
        });
        return lattice;
    }

    /// Whether any place serves the sample; if not, its best place, distance and reason are set.
    bool serve(Sample& s, const Lattice& lattice, LatheField::Hint& hint, const Progress& progress) const {
        progress.check();
        const LathePlace straight = straight_over(s.p);
        const CutterCover& cover = field_.cover();
        Nearest best{Rest{infinity, s.distance}, s.at};
        bool served = false;
        lattice.near(straight, cover.radius(), away_of(s.p), [&](std::size_t k) {
            if (served) return;
            const Stand& tool = lattice.stands[lattice.slot[k]];
            const double distance = cover.distance(tool.local(s.p - tool.tip));
            // What is left along the normal is no less than the distance tells.
            if (distance <= field_.allowance() + allowed_) served = rest(tool, s.p, s.n).height <= allowed_;
            if (distance < best.distance) best = {Rest{infinity, distance}, tool.at};
        });
        if (served) return true;
        best = nearest_from(best.at.place, 0.5 * lattice.step, s.p, s.n, hint, progress);
        if (best.height <= allowed_) return true;
        // Straight over it the cutter is no farther than the part's outside.
        const Stand above = stand(straight, hint);
        if (const Nearest here{rest(above, s.p, s.n), above.at}; here.distance < best.distance) best = here;
        if (best.height <= allowed_) return true;
        s.at = best.at;
        s.distance = best.distance - field_.allowance();
        s.why = reason(s.p, s.n, best.at);
        return false;
    }

    /// Adds p to `doubtful` where the cutter that would touch the facet's plane there does not serve it.
    void sample(const Vec3& p, const Vec3& facet_normal, double area, bool alone, LatheField::Hint& hint,
                std::vector<Sample>& doubtful) const {
        const double along = frame_.along(p);
        if ((named_from_ && along < range_.from) || (named_to_ && along > range_.to)) return;
        // Either side of a facet may be out, as the winding of a scan says nothing.
        const Vec3 n = facet_normal.dot(frame_.radial(angle_of(p))) < 0 ? Vec3(-facet_normal) : facet_normal;
        const LathePlace place = place_over(p, n);
        if ((named_from_ && place.y < range_.from) || (named_to_ && place.y > range_.to)) return;
        const Stand tool = stand(place, hint);
        const Rest here = rest(tool, p, n);
        if (here.height <= allowed_) return;
        Sample s;
        s.p = p;
        s.n = n;
        s.angle = angle_of(p);
        if (s.angle < 0) s.angle += 2 * pi;
        s.y = along;
        s.area = area;
        s.half = std::max(std::min({0.5 * std::sqrt(area), along - from_, to_ - along}), 0.0);
        s.alone = alone;
        s.distance = here.distance;
        s.at = tool.at;
        doubtful.push_back(s);
    }

    UnreachedRegion::Why reason(const Vec3& p, const Vec3& n, const LathePoint& at) const {
        using Why = UnreachedRegion::Why;
        const bool beyond = at.place.y <= range_.from || at.place.y >= range_.to;
        if (at.held == LathePoint::HeldBy::zone || (beyond && range_.held_back > 0)) return Why::held;
        if (is_covered(p, n)) return Why::covered;
        if (at.held == LathePoint::HeldBy::core) return Why::core;
        return at.held == LathePoint::HeldBy::shaft ? Why::shaft : Why::narrow;
    }

    /// Along the tool's axis, at no angle at which the cutter could be over p, the way out is free.
    bool is_covered(const Vec3& p, const Vec3& n) const {
        const double radius = field_.cover().radius(), rho = std::max(frame_.away(p), radius);
        // Beside a wall that is upright to the tool its one side is open.
        const Vec3 beside = 10 * tolerance::needle_diameter * n;
        for (int k = -sights; k <= sights; ++k) {
            const Vec3 axis = frame_.tool_axis(angle_of(p) + std::asin(radius * k / (sights * rho)));
            for (const double side : {1.0, -1.0})
                if (needle_.lift({p + side * beside, axis}) <= field_.allowance() + allowed_) return false;
        }
        return true;
    }

    /// A place of a hollow edge of which it stands for `length`, or (0) where such edges meet; normals of the
    /// facets beside it.
    void hollow(const Vec3& p, std::span<const Vec3> normals, double length, LatheField::Hint& hint,
                Found& found, const Progress& progress) const {
        progress.check();
        const double along = frame_.along(p), radius = field_.cover().radius();
        if ((named_from_ && along < range_.from) || (named_to_ && along > range_.to)) return;
        Vec3 middle = Vec3::Zero();
        for (const Vec3& n : normals)
            middle += n;
        const LathePlace place = place_over(p, middle.normalized());
        if (place.y < range_.from || place.y > range_.to) return;
        const Stand over = stand(place, hint);
        double rests = 0;
        for (const Vec3& n : normals)
            rests = std::max(rests, rest(over, p, n).height);
        if (rests <= min_fillet * allowed_) return;
        if (rests > allowed_) {
            // A ball leaves h (s) = (w - s)^2 / 2r at the distance s from where it leaves h (0): more than is
            // allowed up to this. Where samples of facets are farther apart they would miss it; where not, it
            // is here that the cutter stays farthest away.
            const double wide = std::sqrt(2 * radius) * (std::sqrt(rests) - std::sqrt(allowed_));
            const bool missed = wide < 0.5 * spacing_;
            const double area = !missed ? 0 : length > 0 ? 2 * wide * length : pi * wide * wide;
            sample(p, normals[0], area, missed, hint, found.doubtful);
            return;
        }
        // Of two cutters, an advance apart, that pass it to both sides the nearer one leaves what stays.
        const double at = feed_.across_turns ? place.y : std::remainder(place.angle - pi, 2 * pi) + pi;
        const auto left = [&](double advance) {
            double most = 0;
            for (const double share : shares) {
                std::array<LathePlace, 2> places{place, place};
                (feed_.across_turns ? places[0].y : places[0].angle) -= share * advance;
                (feed_.across_turns ? places[1].y : places[1].angle) += (1 - share) * advance;
                const Stand before = stand(places[0], hint), after = stand(places[1], hint);
                for (const Vec3& n : normals) {
                    const double first = rest(before, p, n).height;
                    if (first > most) most = std::max(most, std::min(first, rest(after, p, n).height));
                }
            }
            return most;
        };
        const double wanted = feed_.advance(at), leaves = left(wanted);
        found.crease_cusp = std::max(found.crease_cusp, leaves);
        if (leaves <= allowed_) return;
        double good = 0, bad = wanted;
        for (int k = 0; k < halvings; ++k) {
            const double mid = 0.5 * (good + bad);
            (left(mid) <= allowed_ ? good : bad) = mid;
        }
        found.limits.push_back({at, std::max(good, smallest_share * wanted)});
    }

    const LatheField& field_;
    const LatheFrame& frame_;
    const Mesh& mesh_;
    LatheRange range_;
    double allowed_, spacing_ = 1, from_ = 0, to_ = 0;
    const ReachFeed& feed_;
    bool named_from_, named_to_;
    ToolLift needle_;
};

/// Samples of one reason that lie together, on a grid over the unrolled part that closes around it.
class Regions {
public:
    /// The samples that a region's distance comes from are searched for again, and left out if served.
    Regions(const Search& search, std::vector<Sample>& samples, double cell, double radius)
        : search_(search), samples_(samples), cell_(cell), radius_(radius),
          around_(std::max<std::int64_t>(3, std::int64_t(2 * pi * radius / cell))) {}

    std::vector<UnreachedRegion> find(const Progress& progress) {
        std::vector<std::size_t> parent(samples_.size());
        std::iota(parent.begin(), parent.end(), std::size_t(0));
        const auto root = [&](std::size_t i) {
            while (parent[i] != i)
                i = parent[i] = parent[parent[i]];
            return i;
        };
        using Key = std::array<std::int64_t, 3>;
        std::map<Key, std::size_t> cells; // to the first sample in each
        const auto key = [&](const Sample& s) {
            return Key{std::int64_t(s.why),
                       std::min(std::int64_t(s.angle / (2 * pi) * double(around_)), around_ - 1),
                       std::int64_t(std::floor(s.y / cell_))};
        };
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const auto [at, is_new] = cells.try_emplace(key(samples_[i]), i);
            if (!is_new) parent[root(i)] = root(at->second);
        }
        for (const auto& [k, i] : cells)
            for (const std::int64_t a : {-1, 0, 1})
                for (const std::int64_t b : {-1, 0, 1}) {
                    const auto other = cells.find({k[0], (k[1] + a + around_) % around_, k[2] + b});
                    if (other != cells.end()) parent[root(i)] = root(other->second);
                }
        std::map<std::size_t, std::vector<std::size_t>> members;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            members[root(i)].push_back(i);
        std::vector<UnreachedRegion> regions;
        for (auto& [unused, of] : members) {
            make_sure(of, progress);
            if (of.empty()) continue;
            if (UnreachedRegion r = region(of); r.area > 0) regions.push_back(std::move(r));
        }
        std::stable_sort(regions.begin(), regions.end(),
                         [](const UnreachedRegion& a, const UnreachedRegion& b) { return a.area > b.area; });
        return regions;
    }

private:
    /// Until the farthest has been searched thoroughly.
    void make_sure(std::vector<std::size_t>& of, const Progress& progress) const {
        LatheField::Hint hint;
        for (int k = 0; k < max_again && !of.empty(); ++k) {
            progress.check();
            const auto farthest = std::max_element(of.begin(), of.end(), [&](std::size_t a, std::size_t b) {
                return samples_[a].distance < samples_[b].distance;
            });
            if (samples_[*farthest].sure) return;
            if (!search_.search_again(samples_[*farthest], hint, progress)) of.erase(farthest);
        }
    }

    UnreachedRegion region(const std::vector<std::size_t>& of) const {
        UnreachedRegion r;
        r.why = samples_[of.front()].why;
        r.from = infinity;
        r.to = -infinity;
        std::vector<double> angles;
        for (const std::size_t i : of) {
            const Sample& s = samples_[i];
            r.area += s.area;
            r.distance = std::max(r.distance, s.distance);
            const double half = s.alone || of.size() == 1 ? s.half : 0;
            r.from = std::min(r.from, s.y - half);
            r.to = std::max(r.to, s.y + half);
            angles.push_back(s.angle);
            if (half > 0)
                for (const double to : {s.angle - half / radius_, s.angle + half / radius_})
                    angles.push_back(to - 2 * pi * std::floor(to / (2 * pi)));
        }
        // Round the part but for the widest gap; a gap no wider than the grid can tell is none.
        std::sort(angles.begin(), angles.end());
        double widest = angles.front() + 2 * pi - angles.back();
        r.angle_from = angles.front();
        r.angle_to = angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i)
            if (angles[i] - angles[i - 1] > widest) {
                widest = angles[i] - angles[i - 1];
                r.angle_from = angles[i];
                r.angle_to = angles[i - 1] + 2 * pi;
            }
        if (widest <= 4 * pi / double(around_)) {
            r.angle_from = 0;
            r.angle_to = 2 * pi;
        }
        return r;
    }

    const Search& search_;
    std::vector<Sample>& samples_;
    double cell_, radius_;
    std::int64_t around_;
};

} // namespace

LatheReach lathe_reach(const LatheCommon& settings, const LatheField& field, const PlanContext& context,
                       const LatheRange& range, double allowed, const ReachFeed& feed,
                       const Progress& progress) {
    const Search search(settings, field, context, range, allowed, feed);
    Found found = search.facets(progress.part(0, 0.3));
    Found creases = search.creases(progress.part(0.3, 0.5));
    search.thin_out(creases.doubtful);
    found.doubtful.insert(found.doubtful.end(), creases.doubtful.begin(), creases.doubtful.end());
    std::vector<Sample> out = search.unreached(std::move(found.doubtful), progress.part(0.5, 0.95));
    LatheReach reach;
    reach.area = found.area;
    reach.limits = std::move(creases.limits);
    reach.crease_cusp = creases.crease_cusp;
    reach.regions = Regions(search, out, cell_spacings * search.spacing(),
                            std::max(field.part_radius(), tolerance::smallest_extent))
                        .find(progress.part(0.95, 1));
    return reach;
}

} // namespace facetmill
