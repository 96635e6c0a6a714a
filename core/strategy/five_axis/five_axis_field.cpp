#include "core/strategy/five_axis/five_axis_field.h"

#include "core/base/tolerances.h"
#include "core/cspace/cm2.h"
#include "core/mesh/refine.h"
#include "core/mesh/triangle_distance.h"
#include "core/strategy/five_axis/flow_map.h"
#include "core/strategy/five_axis/ring_map.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/surface/travel_direction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace facetmill {

namespace {

/// Lines of the surface lie on a lattice of this share of the cutter's radius.
constexpr double lattice_share = 1.0 / 64;
/// How far lines are continued beyond the part's border, in radii: farther than a cutter reaches.
constexpr double extension_share = 1.5;
/// Largest distance of neighbouring contact points, in diameters.
constexpr double longest_share = 0.2;
/// A line may be simplified by this share of the tolerance.
constexpr double simplified_share = 0.01;
/// Longest piece of a line, in radii.
constexpr double raised_piece_share = 1.0 / 8;
/// Normals of neighbouring contact points differ by no more than this share of the turn limit, so that the
/// axes have room to turn on their own.
constexpr double turn_share = 0.75;

/// Facets that a map is made on are no longer than this, in radii, or there are about so many of them.
constexpr double map_facet_share = 0.5;
constexpr double map_facets = 60'000;
/// Between pieces of a map, in radii: no cutter reaches over it.
constexpr double map_gap_share = 3;
/// How far rings go on after a round, in radii: what a pose clears lies up to a radius behind its contact and
/// a quarter ahead.
constexpr double overlap_share = 1.25;
/// The least that v is taken to grow by across the travel, along planes and in a map.
constexpr double min_slope = 0.1, min_map_slope = 0.02;

/// The part and what is known of it, turned.
PlanContext seen_through(const PlanContext& context, const Mat3& view, const Progress& progress) {
    PlanContext seen = context;
    auto mesh = std::make_shared<Mesh>(*context.part);
    for (Vec3& p : mesh->vertices)
        p = view * p;
    if (context.geometry) {
        auto geometry = std::make_shared<MeshGeometry>(*context.geometry);
        for (auto* normals : {&geometry->vertex_normals, &geometry->facet_normals})
            for (Vec3& n : *normals)
                n = view * n;
        seen.geometry = std::move(geometry);
    } else {
        seen.geometry = compute_geometry(*mesh, progress);
    }
    seen.part_box = mesh->box();
    seen.part = std::move(mesh);
    return seen;
}

} // namespace

FiveAxisField::FiveAxisField(const PlanContext& context, const Finish5Settings& settings,
                             const Progress& progress, bool whole_spaces, const Mat3& view)
    : context_(context), settings_(settings), cusp_(cusp_budget(settings_, context)),
      chord_(chord_budget(settings_.chord_tolerance, cusp_)),
      allowance_(settings_.allowance + context.tessellation_tolerance[1]), view_(view),
      turned_(view != Mat3::Identity()) {
    if (turned_) seen_ = seen_through(context_, view_, progress.part(0, 0));
    seen_box_ = turned_ ? seen_.part_box : context_.part_box;
    drive_ =
        DriveFrame(travel_direction(settings_.direction, turned_ ? seen_ : context_, progress.part(0, 0.5)));
    std::shared_ptr<const MeshGeometry> geometry = context_.geometry;
    if (!geometry) geometry = compute_geometry(*context_.part, progress.part(0.5, 0.6));
    context_.geometry = geometry;
    grid_ = PostureGrid::make(settings_.lead_limits[0], settings_.lead_limits[1], settings_.yaw_limits[0],
                              settings_.yaw_limits[1], settings_.grid_step);
    lift_.emplace(context_.contact, context_.tool, clearance());
    radius_ = cutter().max_radius();
    kinematics_.emplace(context_.machine, gauge_length(context_.tool),
                        default_part_origin(context_.machine, context_.part_box));

    SurfaceSlice::Options options;
    options.deviation = simplified_share * cusp_;
    options.longest = raised_piece_share * radius_;
    options.extension = extension_share * radius_;
    curvatures_ = context_.curvatures;
    if (!curvatures_)
        curvatures_ = std::make_shared<std::vector<VertexCurvature>>(
            vertex_curvatures(*context_.part, geometry->vertex_normals, progress.part(0.7, 0.8)));
    if (settings_.passes != Finish5Settings::Passes::parallel) make_map(progress.part(0.8, 0.9));
    if (map_) {
        options.steepest_u = map_->steepest_u;
        options.period = map_->period;
        options.overlap = overlap_share * radius_;
        options.as_wound = map_->period > 0 && context_.is_piece;
    }
    if (turned_ || map_)
        lines_.emplace(*seen_.part, *seen_.geometry, drive_, fineness() * lattice_share * radius_, options,
                       progress.part(0.9, 1), view_.transpose(), map_ ? &*map_ : nullptr);
    else
        lines_.emplace(*context_.part, *geometry, drive_, lattice_share * radius_, options,
                       progress.part(0.8, 1));

    CSpaceInput input;
    input.lift = &*lift_;
    input.grid = &grid_;
    input.kinematics = &*kinematics_;
    input.lowest_axis_z =
        std::max(tolerance::lowest_axis_z, std::cos(settings_.max_tilt) - tolerance::level_angle);
    input.local_radius = 2 * radius_;
    input.height = cutter().height();
    input.bottom_everywhere = whole_spaces;
    // Lu's local choice goes through what is not free.
    input.low_tops = whole_spaces || settings_.posture == Finish5Settings::PostureChoice::local;
    builder_.emplace(input);
}

void FiveAxisField::make_map(const Progress& progress) {
    const Mesh& part = turned_ ? *seen_.part : *context_.part;
    const MeshGeometry& geometry = turned_ ? *seen_.geometry : *context_.geometry;
    double area = 0;
    for (std::size_t f = 0; f < part.facet_count(); ++f)
        area += 0.5 * part.facet_cross(f).norm();
    const double longest = std::max(map_facet_share * radius_, 2 * std::sqrt(area / map_facets));
    DerivedMesh fine = refined(
        part, [](const auto&) { return true; }, longest, std::numeric_limits<std::size_t>::max(),
        progress.part(0, 0.2));
    const bool rings = settings_.passes == Finish5Settings::Passes::around;
    if (rings) map_ = ring_map(fine, progress.part(0.2, 1));
    auto own = std::make_shared<MeshGeometry>();
    own->vertex_normals = carried_normals(fine, geometry.vertex_normals);
    for (std::size_t f = 0; f < fine.mesh.facet_count(); ++f)
        own->facet_normals.push_back(geometry.facet_normals[fine.facet_of[f]]);
    facet_of_ = std::move(fine.facet_of);
    seen_.geometry = std::move(own);
    seen_.part = std::make_shared<const Mesh>(std::move(fine.mesh));
    if (!rings) map_ = flow_map(*seen_.part, drive_, map_gap_share * radius_, progress.part(0.2, 1));
}

double FiveAxisField::v_of(const Vec3& p) const {
    const Vec3 seen = turned_ ? Vec3(view_ * p) : p;
    if (!map_) return drive_.v(seen);
    const Mesh& mesh = *seen_.part;
    double least = infinity, v = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec3 nearest =
            nearest_in_triangle(seen, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
        const double away = (nearest - seen).squaredNorm();
        if (!(away < least)) continue;
        least = away;
        v = map_->v[mesh.facets[f][0]] + map_->gradients[f].dot(nearest - mesh.corner(f, 0));
    }
    return v;
}

std::array<double, 2> FiveAxisField::travelled() const {
    if (map_) return {0, map_->u_hi};
    std::array<double, 2> u{infinity, -infinity};
    for (const double x : {seen_box_.lo.x(), seen_box_.hi.x()})
        for (const double y : {seen_box_.lo.y(), seen_box_.hi.y()}) {
            const double at = drive_.u(Vec3(x, y, 0));
            u[0] = std::min(u[0], at);
            u[1] = std::max(u[1], at);
        }
    return u;
}

double FiveAxisField::reaches_beyond(const SurfaceLine& line, const SurfaceSlice::End& other) const {
    const SlicePoint& end = other.first ? line.points.front() : line.points.back();
    if (!map_) return other.first ? end.u - other.u : other.u - end.u;
    const double along = (other.point - end.point).dot(line.direction(other.first ? 0 : line.length()));
    return other.first ? -along : along;
}

ToolClearance FiveAxisField::clearance() const {
    return {allowance_, settings_.holder_clearance, settings_.holder_clearance};
}

ContactPlace FiveAxisField::place(const SurfaceLine& line, double s, double v, int travel) const {
    const SlicePoint at = line.at(s);
    ContactPlace p;
    p.surface = at.point;
    p.frame = ContactFrame::at(at.point + allowance_ * at.normal, at.normal, travel * line.direction(s));
    p.facet = at.facet;
    p.u = at.u;
    p.v = p.v_lo = p.v_hi = v;
    p.s = s;
    return p;
}

bool FiveAxisField::raised_line(const ContactPlace& place, long plane, RaisedCurve& curve,
                                double along) const {
    const double raise = allowance_ + cusp_ - chord_;
    const auto slope = [&] { return std::max(std::abs(across(place)), map_ ? min_map_slope : min_slope); };
    const auto at = [&](long k) {
        // Steep across the travel the line beside is farther away than its plane.
        const double aside = std::abs(lines_->v(k) - place.v);
        return lines_->slice(k)->near(place.surface, place.frame.normal, place.u,
                                      along * radius_ + aside / slope(), raise, curve);
    };
    if (at(plane)) return true;
    // The surface ends somewhere between this plane and the one before it: that one's line, moved here.
    const double away = lines_->v(plane) - place.v;
    if (std::abs(away) <= lines_->spacing() || !at(plane + (away > 0 ? -1 : 1))) return false;
    const double towards = (away > 0) == (across(place) > 0) ? 1 : -1;
    for (Vec3& p : curve)
        p += towards * lines_->spacing() / slope() * place.frame.left;
    return true;
}

bool FiveAxisField::own_line(const ContactPlace& place, RaisedCurve& curve) const {
    return raised_line(place, lines_->beyond(place.v, place.v), curve, settings_.own_reach);
}

std::vector<RaisedCurve> FiveAxisField::strip_curves(const ContactPlace& place) const {
    const long own = lines_->beyond(place.v, place.v);
    const long lo = lines_->beyond(place.v_lo, place.v), hi = lines_->beyond(place.v_hi, place.v);
    std::vector<long> planes;
    RaisedCurve unused;
    for (long end : {lo, hi}) {
        if (end == own) continue;
        if (!raised_line(place, end, unused)) {
            // The surface ends within the strip: what is to be cleared goes as far as it does.
            long inside = own, outside = end;
            while (std::abs(outside - inside) > 1) {
                const long middle = inside + (outside - inside) / 2;
                (raised_line(place, middle, unused) ? inside : outside) = middle;
            }
            end = inside;
            if (end == own) continue;
        }
        planes.push_back(end);
        if (const long middle = own + (end - own) / 2; middle != own) planes.push_back(middle);
    }
    std::vector<RaisedCurve> curves;
    // Every pose holds a place of its own line near its contact point (Finish5Settings::own_reach).
    RaisedCurve curve;
    if (own_line(place, curve)) curves.push_back(curve);
    for (const long plane : planes)
        if (raised_line(place, plane, curve)) curves.push_back(curve);
    return curves;
}

double FiveAxisField::hollowness(const ContactPlace& place, const Vec3& direction) const {
    double hollow = 0;
    if (place.facet != no_index) {
        const Index facet = facet_of_.empty() ? place.facet : facet_of_[place.facet];
        hollow = facetmill::hollowness(*context_.part, *curvatures_, facet, place.surface, direction);
        // Curvatures are signed by the winding, which need not face the tool.
        if (context_.part->facet_normal(facet).dot(place.frame.normal) < 0) hollow = -hollow;
    }
    return hollow;
}

double FiveAxisField::cm2_lead(const ContactPlace& place) const {
    return facetmill::cm2_lead(cutter(), hollowness(place), settings_.lead_limits[0],
                               settings_.lead_limits[1]);
}

std::vector<double> FiveAxisField::samples(const SurfaceLine& line) const {
    const double longest = longest_share * 2 * radius_, max_away = 0.5 * chord_;
    // With the normals the axes turn, and those of neighbours have to stay together.
    const double cos_limit = std::cos(std::min(settings_.normal_limit, turn_share * settings_.turn_limit));
    // Stations: the line's own points, and more on long pieces.
    std::vector<double> stations{0};
    for (std::size_t i = 1; i < line.arc.size(); ++i) {
        const double piece = line.arc[i] - line.arc[i - 1];
        const auto parts = std::size_t(std::ceil(piece / (0.25 * longest)));
        for (std::size_t k = 1; k <= parts; ++k)
            stations.push_back(line.arc[i - 1] + piece * double(k) / double(parts));
    }
    std::vector<SlicePoint> at;
    at.reserve(stations.size());
    for (const double s : stations)
        at.push_back(line.at(s));
    const auto serves = [&](std::size_t a, std::size_t b) {
        if (stations[b] - stations[a] > longest || at[a].normal.dot(at[b].normal) < cos_limit) return false;
        for (std::size_t k = a + 1; k < b; ++k)
            if (distance_to_segment(at[k].point, at[a].point, at[b].point) > max_away
                || at[a].normal.dot(at[k].normal) < cos_limit)
                return false;
        return true;
    };
    std::vector<double> chosen{0};
    for (std::size_t a = 0; a + 1 < stations.size();) {
        std::size_t b = a + 1;
        while (b + 1 < stations.size() && serves(a, b + 1))
            ++b;
        chosen.push_back(stations[b]);
        a = b;
    }
    return chosen;
}

} // namespace facetmill
