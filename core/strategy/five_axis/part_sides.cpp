#include "core/strategy/five_axis/part_sides.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/outward.h"
#include "core/mesh/refine.h"
#include "core/strategy/five_axis/part_tops.h"
#include "core/strategy/five_axis/ring_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace facetmill {

namespace {

/// Facets that face up less than this ask for another side.
const double steep_z = std::cos(radians(75));
/// They do so from this share of all that can be reached on.
constexpr double steep_share = 0.02;
/// And facets that only leads above the limits reach, from this one on: an edge that turns under is a matter
/// of the setup that has the part turned over.
constexpr double far_share = 0.1;
/// A view serves facets whose normals lie this near to it; more views are taken as long as they add this
/// share of the surface.
const double served_cos = std::cos(radians(40));
constexpr double worth_a_view = 0.01;
/// A facet goes over to the view of its neighbours where its own is better by no more than this, and to that
/// of a piece around it where it is not steeper to it than the angle.
constexpr double little_better = 0.15;
const double crossing_cos = std::cos(radians(70));
constexpr int smoothing_rounds = 6;
/// In squares of the cutter's radius: what is smaller joins the piece beside it; holes in what can be reached
/// are filled when they are smaller, since only clean-up can say more about them.
constexpr double min_piece = 16, min_hole = 16;
/// Of what stays alone after that, pieces below this are left out.
constexpr double crumb = 0.25;
/// Larger facets are divided before they are judged, in radii of the cutter.
constexpr double longest_edge = 4;
constexpr std::size_t max_facets = 4'000'000, facets_per_block = 64;
/// By how much normals at contact points may differ from those of the facets of a piece.
const double normals_differ = radians(5);
/// Across an edge that is sharper than this no piece goes on.
const double sharp_cos = std::cos(radians(50));

constexpr Index nowhere = no_index;

/// Views that are tried: up, and rings about it.
std::vector<Vec3> view_candidates() {
    std::vector<Vec3> all{Vec3::UnitZ()};
    for (const double tilt : {30.0, 60.0, 90.0, 120.0})
        for (int k = 0; k < 12; ++k) {
            const double around = radians(30.0 * k);
            all.emplace_back(std::sin(radians(tilt)) * std::cos(around),
                             std::sin(radians(tilt)) * std::sin(around), std::cos(radians(tilt)));
        }
    return all;
}

Mat3 view_turn(const Vec3& direction) {
    if (direction == Vec3::UnitZ()) return Mat3::Identity();
    Mat3 turn;
    const Vec3 x = Vec3::UnitZ().cross(direction).normalized();
    turn.row(0) = x.transpose();
    turn.row(1) = direction.cross(x).transpose();
    turn.row(2) = direction.transpose();
    return turn;
}

class SideFinder {
public:
    SideFinder(const PlanContext& context, const Finish5Settings& settings, const Progress& progress)
        : context_(context), settings_(settings), progress_(progress) {}

    PartSides run() {
        if (faces_up_as_wound()) return {};
        take_surface();
        find_reach();
        if (!asks_for_sides()) {
            find_far();
            return std::move(found_);
        }
        found_.top_only = false;
        join_neighbours();
        fill_holes();
        tell_unreached();
        if (settings_.passes == Finish5Settings::Passes::around) take_what_goes_round();
        choose_views();
        assign();
        smooth();
        make_pieces();
        return std::move(found_);
    }

private:
    double area_of(const Mesh& mesh, std::size_t f) const { return 0.5 * mesh.facet_cross(f).norm(); }

    /// Whether nearly all of a mesh faces up, or down as a sheet may; without asking which side is outside.
    bool faces_up_as_wound() const {
        const Mesh& mesh = *context_.part;
        double up = 0, down = 0, whole = 0;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            const double area = area_of(mesh, f), z = mesh.facet_normal(f).z();
            whole += area;
            up += z >= steep_z ? area : 0;
            down += z <= -steep_z ? area : 0;
        }
        return (context_.is_piece ? up : std::max(up, down)) >= (1 - steep_share) * whole;
    }

    void take_surface() {
        const OutwardSides sides =
            context_.is_piece ? OutwardSides{std::vector<OutwardSides::Side>(context_.part->facet_count())}
                              : outward_sides(*context_.part, progress_.part(0, 0.2));
        const MeshPtr wound = wound_outward(context_.part, sides);
        const CutterProfile cutter(context_.tool.cutter());
        radius_ = cutter.max_radius();
        const double longest = longest_edge * radius_;
        const auto wanted = [&](const std::array<Vec3, 3>& p) {
            return std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()}) > longest;
        };
        DerivedMesh fine = refined(*wound, wanted, longest, std::max(max_facets, wound->facet_count()),
                                   progress_.part(0.2, 0.25));
        const auto vertex_normals_ = vertex_normals(*wound, NormalWeight::angle, progress_.part(0.25, 0.27));
        const auto curvatures = context_.curvatures && wound == context_.part
                                    ? *context_.curvatures
                                    : vertex_curvatures(*wound, vertex_normals_, progress_.part(0.27, 0.3));
        normals_ = carried_normals(fine, vertex_normals_);
        curvatures_ = carried_curvatures(fine, curvatures, normals_);
        buried_.resize(fine.mesh.facet_count());
        for (std::size_t f = 0; f < buried_.size(); ++f)
            buried_[f] = sides.sides[fine.facet_of[f]] == OutwardSides::buried;
        mesh_ = std::move(fine.mesh);
        area_.resize(mesh_.facet_count());
        normal_.resize(mesh_.facet_count());
        for (std::size_t f = 0; f < area_.size(); ++f) {
            area_[f] = area_of(mesh_, f);
            normal_[f] = mesh_.facet_normal(f);
            found_.whole_area += area_[f];
        }
    }

    /// Which facets some axis of the operation reaches, and what keeps it from the others.
    void find_reach() {
        reach_.emplace(context_, settings_);
        reached_.assign(area_.size(), 0);
        far_.assign(area_.size(), 0);
        block_.assign(area_.size(), ReachBlock::none);
        parallel_blocks(area_.size(), facets_per_block, progress_.part(0.3, 0.9),
                        [&](std::size_t begin, std::size_t end) {
                            ToolLift::Hint hint;
                            for (std::size_t f = begin; f < end; ++f) {
                                if (buried_[f] || normal_[f].isZero()) continue;
                                const Vec3 middle =
                                    (mesh_.corner(f, 0) + mesh_.corner(f, 1) + mesh_.corner(f, 2)) / 3;
                                const AxisReach::Found found = reach_->at(middle, normal_[f], hint);
                                reached_[f] = found.reached;
                                far_[f] = found.far;
                                block_[f] = found.block;
                            }
                        });
    }

    bool asks_for_sides() const {
        double steep = 0, far = 0, all = 0;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (!reached_[f]) continue;
            all += area_[f];
            if (far_[f])
                far += area_[f];
            else if (normal_[f].z() < steep_z)
                steep += area_[f];
        }
        return steep > steep_share * (all - far) || far > far_share * all;
    }

    /// What is left where the part is cut from above: an edge that turns under.
    void find_far() {
        double largest = 0;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (!far_[f]) continue;
            found_.far_area += area_[f];
            if (area_[f] <= largest) continue;
            largest = area_[f];
            found_.far_place = (mesh_.corner(f, 0) + mesh_.corner(f, 1) + mesh_.corner(f, 2)) / 3;
        }
        if (found_.far_area < crumb * radius_ * radius_) found_.far_area = 0;
    }

    void join_neighbours() {
        const EdgeTable edges(mesh_, progress_);
        beside_.assign(3 * area_.size(), nowhere);
        joined_ = beside_;
        for (std::size_t low = 0; low < edges.vertex_count(); ++low)
            edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
                if (sides.size() != 2 || sides[0].facet() == sides[1].facet()) return;
                joined_[sides[0].side] = sides[1].facet();
                joined_[sides[1].side] = sides[0].facet();
                if (normal_[sides[0].facet()].dot(normal_[sides[1].facet()]) < sharp_cos) return;
                beside_[sides[0].side] = sides[1].facet();
                beside_[sides[1].side] = sides[0].facet();
            });
    }

    double edge_length(std::size_t side) const {
        return (mesh_.vertices[side_end(mesh_, side)] - mesh_.vertices[side_start(mesh_, side)]).norm();
    }

    /// Facets joined by edges that are alike by `label`: a number for each, from 0, and the area of each.
    std::vector<Index> components(const std::vector<Index>& label, const std::vector<Index>& beside,
                                  std::vector<double>& areas) const {
        std::vector<Index> number(area_.size(), nowhere);
        areas.clear();
        std::vector<Index> open;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (number[f] != nowhere) continue;
            const auto own = Index(areas.size());
            areas.push_back(0);
            number[f] = own;
            open.assign(1, Index(f));
            while (!open.empty()) {
                const Index at = open.back();
                open.pop_back();
                areas.back() += area_[at];
                for (std::size_t k = 0; k < 3; ++k) {
                    const Index other = beside[3 * std::size_t(at) + k];
                    if (other == nowhere || number[other] != nowhere || label[other] != label[at]) continue;
                    number[other] = own;
                    open.push_back(other);
                }
            }
        }
        return number;
    }

    /// What is too low for any axis stays out; other holes are small hollows that clean-up is for.
    void fill_holes() {
        std::vector<double> areas;
        const std::vector<Index> label(reached_.begin(), reached_.end());
        const std::vector<Index> number = components(label, joined_, areas);
        const double least = min_hole * radius_ * radius_;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (areas[number[f]] >= least || buried_[f]) continue;
            // Crumbs that can be reached in the middle of what cannot are no places to cut either.
            if (reached_[f] && areas[number[f]] < crumb * radius_ * radius_) reached_[f] = 0;
            if (!reached_[f] && !reach_->too_low(normal_[f])) reached_[f] = 1;
        }
    }

    void tell_unreached() {
        std::vector<double> areas;
        const std::vector<Index> label(reached_.begin(), reached_.end());
        const std::vector<Index> number = components(label, joined_, areas);
        std::vector<UnreachedPiece> pieces(areas.size());
        std::vector<double> largest(areas.size(), -1);
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (reached_[f] || buried_[f]) continue;
            found_.unreached_area += area_[f];
            UnreachedPiece& piece = pieces[number[f]];
            piece.area += area_[f];
            piece.by_block[std::size_t(block_[f])] += area_[f];
            if (area_[f] <= largest[number[f]]) continue;
            largest[number[f]] = area_[f];
            piece.place = (mesh_.corner(f, 0) + mesh_.corner(f, 1) + mesh_.corner(f, 2)) / 3;
        }
        for (const UnreachedPiece& piece : pieces)
            if (piece.area >= crumb * radius_ * radius_) found_.unreached.push_back(piece);
        std::stable_sort(found_.unreached.begin(), found_.unreached.end(),
                         [](const auto& a, const auto& b) { return a.area > b.area; });
    }

    /// Pieces that rings go about, whichever way their facets face, are cut whole.
    void take_what_goes_round() {
        std::vector<double> areas;
        const std::vector<Index> label(reached_.begin(), reached_.end());
        const std::vector<Index> number = components(label, beside_, areas);
        std::vector<std::vector<Index>> facets(areas.size());
        for (std::size_t f = 0; f < area_.size(); ++f)
            if (reached_[f]) facets[number[f]].push_back(Index(f));
        for (std::size_t i = 0; i < facets.size(); ++i) {
            if (facets[i].empty() || areas[i] < min_piece * radius_ * radius_) continue;
            if (!goes_round(part_of(mesh_, facets[i]).mesh, progress_.part(0.9, 0.95))) continue;
            add_piece(facets[i], Vec3::UnitZ(), areas[i], Finish5Settings::Passes::around);
            for (const Index f : facets[i])
                reached_[f] = 0;
        }
    }

    void choose_views() {
        const std::vector<Vec3> candidates = view_candidates();
        std::vector<bool> served(area_.size());
        double all = 0;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            served[f] = !reached_[f];
            if (reached_[f]) all += area_[f];
        }
        const auto gain = [&](const Vec3& view) {
            double sum = 0;
            for (std::size_t f = 0; f < area_.size(); ++f)
                if (!served[f] && normal_[f].dot(view) >= served_cos) sum += area_[f];
            return sum;
        };
        const auto take = [&](const Vec3& view) {
            views_.push_back(view);
            for (std::size_t f = 0; f < area_.size(); ++f)
                if (normal_[f].dot(view) >= served_cos) served[f] = true;
        };
        // What faces up is cut from above, as parts are that have no other side.
        if (gain(candidates.front()) > worth_a_view * all) take(candidates.front());
        while (true) {
            progress_.check();
            double most = worth_a_view * all;
            const Vec3* best = nullptr;
            for (const Vec3& view : candidates)
                if (const double g = gain(view); g > most) {
                    most = g;
                    best = &view;
                }
            if (!best) break;
            take(*best);
        }
        if (views_.empty()) views_.push_back(candidates.front());
    }

    double seen(std::size_t f, Index view) const { return normal_[f].dot(views_[view]); }

    void assign() {
        view_of_.assign(area_.size(), nowhere);
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (!reached_[f]) continue;
            Index best = 0;
            for (Index v = 1; v < views_.size(); ++v)
                if (seen(f, v) > seen(f, best)) best = v;
            if (seen(f, best) > crossing_cos) view_of_[f] = best;
        }
    }

    /// Facets follow their neighbours, then small pieces what lies around them.
    void smooth() {
        for (int round = 0; round < smoothing_rounds; ++round)
            for (std::size_t f = 0; f < area_.size(); ++f) {
                if (view_of_[f] == nowhere) continue;
                std::vector<double> border(views_.size(), 0);
                for (std::size_t k = 0; k < 3; ++k)
                    if (const Index other = beside_[3 * f + k];
                        other != nowhere && view_of_[other] != nowhere)
                        border[view_of_[other]] += edge_length(3 * f + k);
                const auto most = Index(std::max_element(border.begin(), border.end()) - border.begin());
                if (border[most] > border[view_of_[f]]
                    && seen(f, most) > std::max(seen(f, view_of_[f]) - little_better, crossing_cos))
                    view_of_[f] = most;
            }
        for (int round = 0; round < smoothing_rounds && absorb_small(); ++round) {
        }
    }

    /// Gives facets of small pieces the view of the piece with which they share most border; false where
    /// nothing changed.
    bool absorb_small() {
        std::vector<double> areas;
        const std::vector<Index> number = components(view_of_, beside_, areas);
        const double least = min_piece * radius_ * radius_;
        std::vector<std::vector<double>> border(areas.size());
        std::vector<double> steepest(areas.size() * views_.size(), 1);
        for (std::size_t f = 0; f < area_.size(); ++f) {
            if (view_of_[f] == nowhere || areas[number[f]] >= least) continue;
            auto& own = border[number[f]];
            own.resize(views_.size(), 0);
            for (Index v = 0; v < views_.size(); ++v) {
                double& worst = steepest[number[f] * views_.size() + v];
                worst = std::min(worst, seen(f, v));
            }
            for (std::size_t k = 0; k < 3; ++k)
                if (const Index other = beside_[3 * f + k]; other != nowhere && view_of_[other] != nowhere
                                                            && number[other] != number[f]
                                                            && areas[number[other]] > areas[number[f]])
                    own[view_of_[other]] += edge_length(3 * f + k);
        }
        bool changed = false;
        for (std::size_t f = 0; f < area_.size(); ++f) {
            const auto& own = border[number[f]];
            if (view_of_[f] == nowhere || own.empty()) continue;
            double most = 0;
            Index to = nowhere;
            for (Index v = 0; v < views_.size(); ++v)
                if (own[v] > most && steepest[number[f] * views_.size() + v] > crossing_cos) {
                    most = own[v];
                    to = v;
                }
            if (to == nowhere || to == view_of_[f]) continue;
            view_of_[f] = to;
            changed = true;
        }
        return changed;
    }

    void make_pieces() {
        std::vector<double> areas;
        const std::vector<Index> number = components(view_of_, beside_, areas);
        std::vector<std::vector<Index>> facets(areas.size());
        for (std::size_t f = 0; f < area_.size(); ++f)
            if (view_of_[f] != nowhere) facets[number[f]].push_back(Index(f));
        for (Index v = 0; v < views_.size(); ++v) {
            // Small ones of a view are cut together: one after the other they would be planned for long.
            std::vector<Index> small;
            double small_area = 0;
            for (std::size_t i = 0; i < facets.size(); ++i) {
                if (facets[i].empty() || view_of_[facets[i].front()] != v) continue;
                if (areas[i] < crumb * radius_ * radius_) continue;
                if (areas[i] < min_piece * radius_ * radius_) {
                    small.insert(small.end(), facets[i].begin(), facets[i].end());
                    small_area += areas[i];
                } else {
                    add_piece(facets[i], views_[v], areas[i], passes_but_round(settings_.passes));
                }
            }
            std::sort(small.begin(), small.end());
            if (!small.empty()) add_piece(small, views_[v], small_area, passes_but_round(settings_.passes));
        }
    }

    void add_piece(const std::vector<Index>& facets, const Vec3& view, double area,
                   Finish5Settings::Passes passes) {
        SidePiece made;
        made.piece = side_piece(mesh_, facets, normals_, curvatures_, progress_.part(1, 1));
        made.view = view_turn(view);
        made.area = area;
        made.passes = passes;
        made.lead_limits = lead_limits_of(facets);
        found_.pieces.push_back(std::move(made));
    }

    /// Wider ones where enough of a piece asks for them, without those that are too small for all of it.
    std::array<double, 2> lead_limits_of(const std::vector<Index>& facets) const {
        double far = 0, highest = -1;
        for (const Index f : facets) {
            if (far_[f]) far += area_[f];
            highest = std::max(highest, normal_[f].z());
        }
        if (far < crumb * radius_ * radius_) return settings_.lead_limits;
        const double least =
            std::acos(std::min(highest, 1.0)) - std::acos(tolerance::lowest_axis_z) - normals_differ;
        return {std::clamp(least, settings_.lead_limits[0], settings_.lead_limits[1]), reach_->widest_lead()};
    }

    const PlanContext& context_;
    const Finish5Settings& settings_;
    const Progress& progress_;
    std::optional<AxisReach> reach_;
    double radius_ = 0;
    Mesh mesh_;
    std::vector<Vec3> normals_; ///< of vertices
    std::vector<VertexCurvature> curvatures_;
    std::vector<double> area_; ///< per facet, as all that follows
    std::vector<Vec3> normal_;
    std::vector<char> buried_, reached_;
    std::vector<char> far_; ///< reached by leads above the limits only
    std::vector<ReachBlock> block_;
    /// Per side of a facet: the facet beyond it, or nowhere; `beside_` has none beyond sharp edges.
    std::vector<Index> beside_, joined_;
    std::vector<Index> view_of_; ///< the number of its view, or nowhere
    std::vector<Vec3> views_;
    PartSides found_;
};

} // namespace

Finish5Settings::Passes passes_but_round(Finish5Settings::Passes asked) {
    return asked == Finish5Settings::Passes::around ? Finish5Settings::Passes::morph : asked;
}

Finish5Settings side_settings(const Finish5Settings& settings) {
    Finish5Settings own = settings;
    own.yaw_limits = {-pi, pi};
    own.grid_step = 2 * settings.grid_step;
    return own;
}

PartSides find_sides(const PlanContext& context, const Finish5Settings& settings, const Progress& progress) {
    return SideFinder(context, settings, progress).run();
}

} // namespace facetmill
