#include "core/gouge/tool_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/axis_frame.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/lower_surface.h"
#include "core/gouge/shared_cut.h"

#include <cmath>

namespace facetmill {

struct ToolLift::Body {
    SurfaceTable surface;
    double offset; ///< of its lowest point above the tip
    double rim;    ///< height above the tip at which its lower surface ends
    ToolBody kind;
    int section;
};

namespace {

void check_pose(const ToolPose& pose) {
    const double largest = tolerance::largest_program_coordinate;
    if (!(pose.tip.cwiseAbs().maxCoeff() <= largest)
        || !(std::abs(pose.axis.norm() - 1) <= tolerance::unit_axis))
        throw Error(ErrorCode::internal, "ToolLift",
                    "was asked for a pose that is not finite or has no unit axis", "report this");
}

} // namespace

const char* tool_body_name(ToolBody body) {
    switch (body) {
    case ToolBody::cutter:
        return "cutter";
    case ToolBody::shank:
        return "shank";
    case ToolBody::holder:
        return "holder";
    case ToolBody::none:
        break;
    }
    return "none";
}

const char* block_cause_name(BlockCause cause) {
    switch (cause) {
    case BlockCause::local:
        return "local";
    case BlockCause::global:
        return "global";
    case BlockCause::shank:
        return "shank";
    case BlockCause::holder:
        return "holder";
    case BlockCause::none:
        break;
    }
    return "none";
}

struct ToolLift::Group::Cuts {
    std::array<SharedCut, max_bodies> of_body;
};

ToolLift::Group::Group() : cuts_(new Cuts) {}
ToolLift::Group::~Group() = default;

ToolLift::~ToolLift() = default;

ToolLift::ToolLift(ContactIndexPtr index, const CutterProfile& cutter, double allowance)
    : index_(std::move(index)), cutter_(cutter) {
    add(cutter_, 0, allowance, ToolBody::cutter, -1);
}

ToolLift::ToolLift(ContactIndexPtr index, const Tool& tool, const ToolClearance& clearance)
    : index_(std::move(index)), cutter_((check_tool(tool), CutterProfile(tool.cutter()))) {
    add(cutter_, 0, clearance.cutter, ToolBody::cutter, -1);
    double height = tool.flute_length;
    const auto cylinder = [&](double diameter, double length, double distance, ToolBody kind, int section) {
        add(CutterProfile(AptCutter::flat(diameter, length)), height, distance, kind, section);
        height += length;
    };
    if (tool.shank_length > 0)
        cylinder(tool.shank_diameter, tool.shank_length, clearance.shank, ToolBody::shank, -1);
    for (std::size_t i = 0; i < tool.holder.size(); ++i)
        cylinder(tool.holder[i].diameter, tool.holder[i].length, clearance.holder, ToolBody::holder, int(i));
}

void ToolLift::add(const CutterProfile& profile, double offset, double clearance, ToolBody kind,
                   int section) {
    const CutterProfile grown = profile.grown(clearance);
    const double lowest = offset - clearance;
    for (const Body& below : bodies_)
        if (grown.max_radius() <= below.surface.max_radius && lowest >= below.rim) return;
    if (bodies_.size() == max_bodies)
        throw Error(ErrorCode::out_of_range, "holder", "has too many sections",
                    "at most " + std::to_string(max_bodies - 2));
    bodies_.push_back(
        {lower_surface(grown), lowest, lowest + grown.height_at(grown.max_radius()), kind, section});
}

void ToolLift::gather(std::span<const ToolPose> poses, double depth, Group& group) const {
    Vec3 axis = Vec3::Zero(), tip = Vec3::Zero();
    for (const ToolPose& pose : poses) {
        check_pose(pose);
        axis += pose.axis;
        tip += pose.tip / double(poses.size());
    }
    // Any direction will do, but one in the middle is best.
    const double length = axis.norm();
    axis = length > 0 ? Vec3(axis / length) : Vec3(Vec3::UnitZ());
    double turned = 0; // the frames' directions differ from those about `axis` by no more
    for (const ToolPose& pose : poses)
        turned = std::max(turned, (pose.axis - axis).norm());
    turned += 4 * tolerance::unit_axis; // frames are as good as axes are unit vectors
    const IndexView view = index_->impl().view();
    const Vec3 origin(view.origin[0], view.origin[1], view.origin[2]);
    const double mesh_size = view.half_size[0] + view.half_size[1] + view.half_size[2];
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = bodies_[b];
        const Vec3 place = tip + body.offset * axis;
        double moved = 0; // the bodies' places differ from `place` by no more
        for (const ToolPose& pose : poses)
            moved = std::max(moved, (pose.tip + body.offset * pose.axis - place).norm());
        const Vec3 from_place = origin - place;
        const double radius = body.surface.max_radius,
                     slack = tolerance::float_slack * (from_place.norm() + mesh_size + radius + moved);
        constexpr std::size_t nodes_per_cut = 3;
        group.cuts_->of_body[b].make(view, nodes_per_cut, [&](const TreeNode& node, std::size_t k) {
            const Vec3 middle = from_place + Vec3(double(node.cx[k]), double(node.cy[k]), double(node.cz[k]));
            const Vec3 half(double(node.hx[k]), double(node.hy[k]), double(node.hz[k]));
            const double square = middle.squaredNorm(), along = middle.dot(axis), size = half.norm();
            // By how much, at most, a point of the box is higher above, or nearer to the axis of, another
            // pose.
            const double other = turned * (std::sqrt(square) + size + moved) + moved + slack;
            const double reach = radius + size + other;
            return along + half.dot(axis.cwiseAbs()) + other > depth
                   && square - along * along <= reach * reach;
        });
    }
}

double ToolLift::search(const ToolPose& pose, double least, double enough, Hint& hint, ToolContact* contact,
                        const Group* group) const {
    check_pose(pose);
    AxialQuery query;
    set_frame(pose.axis, query.frame);
    query.least = least;
    query.enough = enough;
    const IndexView view = index_->impl().view();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = bodies_[b];
        const Vec3 place = pose.tip + body.offset * pose.axis;
        for (int k = 0; k < 3; ++k)
            query.place[k] = place[k];
        // The highest the mesh reaches along the axis, as seen from the body: mostly a holder is far above.
        double top = 0, away = 0;
        for (int k = 0; k < 3; ++k) {
            top += pose.axis[k] * (view.origin[k] - place[k]) + std::abs(pose.axis[k]) * view.half_size[k];
            away += std::abs(view.origin[k] - place[k]) + view.half_size[k];
        }
        if (top + tolerance::bound_slack * away <= query.least) continue;
        if (group) {
            const SharedCut& cut = group->cuts_->of_body[b];
            if (cut.empty()) continue;
            query.cut = cut.nodes();
            query.cut_nodes = cut.count();
        }
        query.hint = hint.slot_[b];
        AxialAnswer answer;
        axial_kernels().tilted(view, body.surface, query, answer);
        // Where nothing reached higher, the next pose is most likely free as well: then no guess is better
        // than one.
        hint.slot_[b] = answer.slot;
        if (!(answer.tip > query.least)) continue;
        query.least = answer.tip;
        if (contact && answer.slot != no_slot) {
            contact->lift = answer.tip;
            contact->body = body.kind;
            contact->section = body.section;
            contact->facet =
                index_->impl().blocks[answer.slot / block_width].facet[answer.slot % block_width];
            contact->point = place;
            for (int k = 0; k < 3; ++k)
                for (int j = 0; j < 3; ++j)
                    contact->point[k] += query.frame[j][k] * answer.point[j];
        }
        if (query.least > enough) break;
    }
    return query.least;
}

double ToolLift::lift(const ToolPose& pose, Hint& hint) const {
    return search(pose, -infinity, infinity, hint, nullptr);
}

double ToolLift::lift(const ToolPose& pose) const {
    Hint none;
    return lift(pose, none);
}

double ToolLift::lift_above(const ToolPose& pose, double depth, double enough, Hint& hint) const {
    return search(pose, depth, enough, hint, nullptr);
}

ToolContact ToolLift::contact(const ToolPose& pose) const {
    Hint none;
    ToolContact contact;
    search(pose, -infinity, infinity, none, &contact);
    return contact;
}

ToolContact ToolLift::contact_above(const ToolPose& pose, double depth, Hint& hint) const {
    ToolContact contact;
    contact.lift = depth;
    search(pose, depth, infinity, hint, &contact);
    return contact;
}

ToolContact ToolLift::contact_above(const ToolPose& pose, double depth, Hint& hint,
                                    const Group& group) const {
    ToolContact contact;
    contact.lift = depth;
    search(pose, depth, infinity, hint, &contact, &group);
    return contact;
}

bool ToolLift::is_deeper(const ToolPose& pose, double depth, Hint& hint) const {
    return search(pose, depth, depth, hint, nullptr) > depth;
}

void ToolLift::lift(std::span<const ToolPose> poses, std::span<double> lifts,
                    const Progress& progress) const {
    if (poses.size() != lifts.size())
        throw Error(ErrorCode::internal, "ToolLift", "as many lifts as poses are needed", "report this");
    constexpr std::size_t poses_per_block = 128;
    parallel_blocks(poses.size(), poses_per_block, progress, [&](std::size_t begin, std::size_t end) {
        Hint hint;
        for (std::size_t i = begin; i < end; ++i)
            lifts[i] = lift(poses[i], hint);
    });
}

Vec2 plane_contact(const CutterProfile& cutter, double angle) {
    // The outermost point of the profile that is no steeper than the plane.
    Vec2 at = Vec2::Zero();
    for (const ProfilePiece& p : cutter.lower_pieces()) {
        if (p.angle_at_start() > angle + tolerance::cutter_angle) break;
        if (p.kind == ProfilePiece::Kind::arc && p.angle_at_end() > angle)
            at = p.center + p.radius * Vec2(std::sin(angle), -std::cos(angle));
        else
            at = p.to;
    }
    return at;
}

Vec3 tip_at_contact(const CutterProfile& cutter, const Vec3& point, const Vec3& normal, const Vec3& axis) {
    const double up = normal.dot(axis);
    const Vec3 across_axis = normal - up * axis;
    const double horizontal = across_axis.norm();
    if (!(up > 0)) throw Error(ErrorCode::out_of_range, "axis", "points into the part", "tilt the tool less");
    const Vec2 at = plane_contact(cutter, std::atan2(horizontal, up));
    const Vec3 away = horizontal > 0 ? Vec3(across_axis / horizontal) : Vec3(Vec3::Zero());
    return point + at.x() * away - at.y() * axis;
}

BlockCause block_cause(const ToolContact& contact, const Vec3& contact_point, double local_radius) {
    switch (contact.body) {
    case ToolBody::cutter:
        return (contact.point - contact_point).norm() <= local_radius ? BlockCause::local
                                                                      : BlockCause::global;
    case ToolBody::shank:
        return BlockCause::shank;
    case ToolBody::holder:
        return BlockCause::holder;
    case ToolBody::none:
        break;
    }
    return BlockCause::none;
}

} // namespace facetmill
