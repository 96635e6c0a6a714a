#include "core/strategy/lathe/lathe_field.h"

#include "core/base/tolerances.h"

#include <cmath>

namespace facetmill {

namespace {

/// Sides of the prism around a round stock: what it is larger than the cylinder is 4e-5 of the radius.
constexpr int round_sides = 360;
/// A bottom within this share of the allowed cusp of a plane lies on it, as in finishing with three axes.
constexpr double cover_slack_share = 0.125;

/// A closed prism between two rings of corners, the second ahead of the first along the ring's right-hand
/// axis.
void add_prism(Mesh& mesh, const std::vector<Vec3>& low, const std::vector<Vec3>& high) {
    const auto n = Index(low.size()), first = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), low.begin(), low.end());
    mesh.vertices.insert(mesh.vertices.end(), high.begin(), high.end());
    for (Index i = 0; i < n; ++i) {
        const Index next = (i + 1) % n;
        mesh.facets.push_back({first + i, first + next, first + next + n});
        mesh.facets.push_back({first + i, first + next + n, first + i + n});
        if (i > 0 && next != 0) {
            mesh.facets.push_back({first, first + next, first + i});
            mesh.facets.push_back({first + n, first + n + i, first + n + next});
        }
    }
}

/// Around a cylinder.
std::vector<Vec3> ring(const Vec3& middle, const Vec3& x, const Vec3& y, double radius) {
    std::vector<Vec3> corners;
    const double out = radius / std::cos(pi / round_sides);
    for (int i = 0; i < round_sides; ++i) {
        const double angle = 2 * pi * i / round_sides;
        corners.push_back(middle + out * (std::cos(angle) * x + std::sin(angle) * y));
    }
    return corners;
}

} // namespace

Mesh lathe_stock_mesh(const StockSolid& stock, const Box3& stock_box) {
    if (stock.kind == StockSolid::Kind::mesh && stock.mesh) return *stock.mesh;
    Mesh mesh;
    const Box3& box = stock.box.empty() ? stock_box : stock.box;
    if (box.empty()) return mesh;
    if (stock.kind == StockSolid::Kind::cylinder) {
        const int k = stock.axis;
        const Vec3 x = Vec3::Unit((k + 1) % 3), y = Vec3::Unit((k + 2) % 3);
        Vec3 low = box.center(), high = low;
        low[k] = box.lo[k];
        high[k] = box.hi[k];
        add_prism(mesh, ring(low, x, y, stock.radius), ring(high, x, y, stock.radius));
        return mesh;
    }
    const Vec3 &a = box.lo, &b = box.hi;
    add_prism(mesh, {a, {b.x(), a.y(), a.z()}, {b.x(), b.y(), a.z()}, {a.x(), b.y(), a.z()}},
              {{a.x(), a.y(), b.z()}, {b.x(), a.y(), b.z()}, b, {a.x(), b.y(), b.z()}});
    return mesh;
}

Mesh lathe_zone_mesh(const LatheCommon& s, const LatheFrame& frame, const Mesh& stock, double clearance) {
    Mesh mesh;
    double from = infinity, to = -infinity;
    for (const Vec3& p : stock.vertices) {
        from = std::min(from, frame.along(p));
        to = std::max(to, frame.along(p));
    }
    if (!(from < to)) return mesh;
    const Vec3 &d = frame.axis().direction, &x = frame.zero();
    const Vec3 y = d.cross(x);
    const auto cylinder = [&](double lo, double hi, double diameter) {
        const double radius = 0.5 * diameter + clearance;
        add_prism(mesh, ring(frame.axis().point + lo * d, x, y, radius),
                  ring(frame.axis().point + hi * d, x, y, radius));
    };
    const double beyond = to - from;
    if (s.chuck[0] > 0) cylinder(from - beyond, from + s.chuck[0] + clearance, s.chuck[1]);
    if (s.tailstock[0] > 0) cylinder(to - s.tailstock[0] - clearance, to + beyond, s.tailstock[1]);
    return mesh;
}

double radius_about(const LatheFrame& frame, const Mesh& mesh) {
    double radius = 0;
    for (const Vec3& p : mesh.vertices)
        radius = std::max(radius, frame.away(p));
    return radius;
}

LatheField::LatheField(const LatheCommon& s, const PlanContext& context, double allowance,
                       const Progress& progress)
    : frame_(s, context), contact_(context.contact),
      cover_(CutterProfile(context.tool.cutter()), cover_slack_share * s.tolerance),
      part_(std::make_unique<ToolLift>(context.contact, context.tool,
                                       ToolClearance{allowance, s.holder_clearance, s.holder_clearance})),
      allowance_(allowance), floor_(s.core_radius / std::cos(s.tilt)),
      part_radius_(radius_about(frame_, *context.part)) {
    for (const auto& [name, zone] : {std::pair("chuck", s.chuck), std::pair("tailstock", s.tailstock)})
        if (zone[0] > 0 && !(zone[1] > 0))
            throw Error(ErrorCode::out_of_range, name, "the diameter of what holds the part is 0",
                        "give its length and its diameter");
    const Mesh stock = lathe_stock_mesh(context.stock, context.stock_box);
    stock_radius_ = radius_about(frame_, stock);
    stock_from_ = infinity;
    stock_to_ = -infinity;
    for (const Vec3& p : (stock.vertices.empty() ? *context.part : stock).vertices) {
        stock_from_ = std::min(stock_from_, frame_.along(p));
        stock_to_ = std::max(stock_to_, frame_.along(p));
    }
    auto zones = std::make_shared<Mesh>(lathe_zone_mesh(s, frame_, stock, s.clearance));
    if (zones->facets.empty()) return;
    zone_radius_ = radius_about(frame_, *zones);
    zone_ = std::make_unique<ToolLift>(std::make_shared<ContactIndex>(zones, progress), context.tool);
}

double LatheField::zone_u(const LathePlace& place, Hint& hint) const {
    if (!zone_) return -infinity;
    const CutterLocation at = frame_.at(place, 0);
    return zone_->lift({at.tip, at.axis}, hint.zone);
}

double LatheField::u(const LathePlace& place, Hint& hint) const {
    return point(place, hint).u;
}

LathePoint LatheField::point(const LathePlace& place, Hint& hint) const {
    const CutterLocation foot = frame_.at(place, 0);
    const ToolPose pose{foot.tip, foot.axis};
    const ToolContact contact = part_->contact_above(pose, floor_, hint.part);
    LathePoint p;
    p.place = place;
    p.u = std::max(contact.lift, floor_);
    p.held = contact.body == ToolBody::none     ? LathePoint::HeldBy::core
             : contact.body == ToolBody::cutter ? LathePoint::HeldBy::part
                                                : LathePoint::HeldBy::shaft;
    if (zone_)
        if (const double zone = zone_->lift(pose, hint.zone); zone > p.u) {
            p.u = zone;
            p.held = LathePoint::HeldBy::zone;
        }
    const Vec3 tip = foot.tip + p.u * foot.axis;
    if (p.held != LathePoint::HeldBy::part) {
        p.cc = {tip, foot.axis};
        return p;
    }
    const Vec3 rel = contact.point - tip;
    const Vec3 x = frame_.axis().direction.cross(foot.axis).normalized(), y = foot.axis.cross(x);
    const auto open = cover_.contact_normal(Vec3(rel.dot(x), rel.dot(y), rel.dot(foot.axis)));
    Vec3 normal = open ? Vec3(open->x() * x + open->y() * y + open->z() * foot.axis)
                       : contact_->mesh().facet_normal(contact.facet);
    if (normal.dot(foot.axis) < 0) normal = -normal;
    p.cc = {contact.point, normal};
    return p;
}

LatheStock::LatheStock(const LatheFrame& frame, const PlanContext& context, Of of, const Progress& progress)
    : frame_(frame) {
    const auto index = std::make_shared<ContactIndex>(
        std::make_shared<Mesh>(lathe_stock_mesh(context.stock, context.stock_box)), progress);
    const Tool& tool = context.tool;
    if (of == Of::cutter)
        bodies_.push_back({std::make_unique<ToolLift>(index, CutterProfile(tool.cutter())), 0});
    if (of == Of::whole_tool) bodies_.push_back({std::make_unique<ToolLift>(index, tool), 0});
    if (of != Of::above_flutes) return;
    double base = tool.flute_length;
    const auto add = [&](double diameter, double length) {
        if (length > 0)
            bodies_.push_back(
                {std::make_unique<ToolLift>(index, CutterProfile(AptCutter::flat(diameter, length))), base});
        base += length;
    };
    add(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        add(section.diameter, section.length);
}

double LatheStock::u(const LathePlace& place, Hint& hint) const {
    hint.resize(bodies_.size());
    double u = -infinity;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const CutterLocation at = frame_.at(place, bodies_[i].base);
        u = std::max(u, bodies_[i].lift->lift({at.tip, at.axis}, hint[i]));
    }
    return u;
}

} // namespace facetmill
