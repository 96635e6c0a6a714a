#include "core/job/axis_view.h"

#include "core/job/cache_key.h"
#include "core/job/fixtures.h"
#include "core/job/stock_solid.h"
#include "core/mesh/geometry.h"
#include "core/setup/kinematics.h"
#include "core/setup/lying.h"
#include "core/strategy/cleanup/cleanup.h"
#include "core/strategy/plan/stock_bottom.h"

#include <optional>

namespace facetmill {

namespace {

/// What a tool keeps from the plane on which the stock stands, mm: a cut may end on that plane.
constexpr double table_clearance = 1;

/// The tool at its widest, cutter, shank and holder, mm.
double tool_radius(const Tool& tool) {
    double diameter = std::max(2 * CutterProfile(tool.cutter()).max_radius(), tool.shank_diameter);
    for (const HolderSection& section : tool.holder)
        diameter = std::max(diameter, section.diameter);
    return 0.5 * diameter;
}

/// The upper end of what holds the stock, in the setup.
double table_height(const Box3& stock, const Operation& operation) {
    return stock.lo.z() - operation.common().below_bottom;
}

/// What holds the stock, in the setup: below all of it, and as far beside it as the tool is wide. None where
/// it is so far below that no tool comes there.
std::optional<FixtureSolid> table_below(const Project& project, const Operation& operation,
                                        const Box3& stock) {
    const Tool& tool = project.tool_of(operation);
    const double beside = 2 * tool_radius(tool) + operation.common().clearance;
    if (operation.common().below_bottom > beside + gauge_length(tool)) return std::nullopt;
    Fixture slab;
    slab.name = "the table below the stock";
    slab.size = {stock.size().x() + 2 * beside, stock.size().y() + 2 * beside, beside};
    slab.translate = {stock.center().x(), stock.center().y(),
                      table_height(stock, operation) - table_clearance - beside};
    return FixtureSolid{slab.name,
                        std::make_shared<Mesh>(fixture_mesh(slab)),
                        std::make_shared<Mesh>(fixture_mesh(slab, table_clearance)),
                        table_clearance,
                        false,
                        true};
}

Vec3 middle_bottom(const Box3& box) {
    return {box.center().x(), box.center().y(), box.lo.z()};
}

/// A box or an upright cylinder over a place.
Mesh stock_body(const StockSolid& stock) {
    Fixture body;
    const Vec3 size = stock.box.size();
    if (stock.kind == StockSolid::Kind::cylinder) {
        body.kind = Fixture::Kind::cylinder;
        body.diameter = 2 * stock.radius;
        body.height = size[stock.axis];
        Mesh mesh = fixture_mesh(body);
        // From an upright one about the origin to its own axis, by a change of coordinates that keeps its
        // winding.
        const Vec3 half = 0.5 * Vec3::UnitZ() * body.height;
        for (Vec3& p : mesh.vertices) {
            const Vec3 q = p - half;
            Vec3 r;
            for (int k = 0; k < 3; ++k)
                r[(stock.axis + 1 + k) % 3] = q[k];
            p = stock.box.center() + r;
        }
        return mesh;
    }
    body.size = {size.x(), size.y(), size.z()};
    const Vec3 place = middle_bottom(stock.box);
    body.translate = {place.x(), place.y(), place.z()};
    return fixture_mesh(body);
}

void turn_pass(Pass& pass, const Mat3& turn) {
    for (CutterContact& c : pass.cc)
        c = {turn * c.point, turn * c.normal};
    for (auto* locations : {&pass.cl, &pass.entry})
        for (CutterLocation& c : *locations)
            c = {turn * c.tip, turn * c.axis};
}

void turn_strip(Strip& strip, const Mat3& turn) {
    for (auto& triangle : strip.band)
        for (Vec3& p : triangle)
            p = turn * p;
    for (auto* curves : {&strip.boundaries, &strip.centers})
        for (auto& curve : *curves)
            for (Vec3& p : curve)
                p = turn * p;
}

} // namespace

Mat3 turn_upright(const Vec3& axis) {
    return exact_turn(turn_to_lie(-axis));
}

void AxisView::index_part(const Progress& progress) {
    if (!index || index->mesh_ptr() != part->mesh)
        index = std::make_shared<ContactIndex>(part->mesh, progress.part(0, 0.6));
    if (kept_off && kept_off->mesh_ptr() == part->kept_off) return;
    // Both or none: a plan that was cancelled in between would take fixtures for a part of the part.
    ContactIndexPtr all = index, held;
    if (part->fixtures) {
        all = std::make_shared<ContactIndex>(part->kept_off, progress.part(0.6, 1));
        held = std::make_shared<ContactIndex>(grown_fixtures(*part->fixtures), progress.part(1, 1));
    }
    kept_off = std::move(all);
    fixtures = std::move(held);
}

std::string axis_view_key(const Project& project, const Operation& operation, const Box3& stock) {
    if (!operation.is_indexed()) return {};
    return Key()
        .add("axis")
        .add(operation.tool_axis())
        .add(tool_radius(project.tool_of(operation)))
        .add(gauge_length(project.tool_of(operation)))
        .add(operation.common().clearance)
        .add(table_height(stock, operation))
        .add(stock.lo)
        .add(stock.hi)
        .text();
}

std::shared_ptr<const KeptWithin> kept_within_of(const Project& project, const Operation& operation,
                                                 const PreparedPart& part, const Mat3& turn,
                                                 const Progress& progress) {
    if (operation.common().boundary.empty()) return nullptr;
    const auto alone = operation.clone(); // what it keeps off is asked of a contact index, and of that alone
    alone->common().avoid.clear();
    PreparedPart seen = part;
    if (turn != Mat3::Identity()) seen.mesh = turned_mesh(part.mesh, turn);
    return BoundsCache(turn).of(project, *alone, seen, {}, progress).within;
}

MeshPtr turned_mesh(const MeshPtr& mesh, const Mat3& turn) {
    if (!mesh) return nullptr;
    auto turned = std::make_shared<Mesh>(*mesh);
    for (Vec3& p : turned->vertices)
        p = turn * p;
    return turned;
}

StockSolid turned_stock(const StockSolid& stock, const Mat3& turn) {
    StockSolid turned;
    turned.kind = StockSolid::Kind::mesh;
    if (stock.box.empty()) return turned;
    const bool quarters = (turn.array() == turn.array().round()).all();
    if (quarters && stock.kind != StockSolid::Kind::mesh) {
        turned = stock;
        turned.box = Box3();
        turned.box.add(turn * stock.box.lo);
        turned.box.add(turn * stock.box.hi);
        (turn * Vec3::Unit(stock.axis)).cwiseAbs().maxCoeff(&turned.axis);
        return turned;
    }
    turned.edge_loss = stock.edge_loss;
    turned.mesh = turned_mesh(
        stock.kind == StockSolid::Kind::mesh ? stock.mesh : std::make_shared<Mesh>(stock_body(stock)), turn);
    if (turned.mesh) turned.box = turned.mesh->box();
    return turned;
}

AxisView::AxisView(const PreparedPart& setup, const Project& project, const Operation& operation,
                   const Box3& stock, const Progress& progress)
    : turn(turn_upright(operation.tool_axis())), bounds(turn) {
    auto turned = std::make_shared<PreparedPart>();
    turned->mesh = turned_mesh(setup.mesh, turn);
    turned->report = setup.report;
    turned->faces = setup.faces;
    turned->surface_deviation = setup.surface_deviation;
    turned->turned_facets = setup.turned_facets;
    turned->repairs = setup.repairs;
    turned->box = turned->mesh->box();
    turned->reach = reach_about_middle(*turned->mesh, turned->box);
    turned->geometry = compute_geometry(*turned->mesh, progress);
    std::vector<FixtureSolid> solids;
    if (setup.fixtures) solids = *setup.fixtures;
    if (auto table = table_below(project, operation, stock.empty() ? setup.box : stock))
        solids.push_back(std::move(*table));
    for (FixtureSolid& fixture : solids) {
        fixture.mesh = turned_mesh(fixture.mesh, turn);
        fixture.grown = turned_mesh(fixture.grown, turn);
    }
    turned->kept_off = solids.empty() ? turned->mesh : with_fixtures(*turned->mesh, solids);
    if (!solids.empty())
        turned->fixtures = std::make_shared<const std::vector<FixtureSolid>>(std::move(solids));
    part = std::move(turned);
}

StrategyResult turned_path(const StrategyResult& path, const Mat3& turn) {
    StrategyResult turned = path;
    for (Pass& pass : turned.passes)
        turn_pass(pass, turn);
    for (CutterContact& c : turned.cleanup)
        c = {turn * c.point, turn * c.normal};
    for (Strip& strip : turned.strips)
        turn_strip(strip, turn);
    if (auto* cleanup = std::get_if<CleanupPath>(&turned.detail); cleanup && cleanup->record) {
        auto record = std::make_shared<CleanupRecord>(*cleanup->record);
        for (CleanupRecord::Touch& t : record->touches) {
            for (Vec3* p : {&t.center, &t.tip, &t.touch[0], &t.touch[1]})
                *p = turn * *p;
        }
        cleanup->record = std::move(record);
    }
    return turned;
}

ToolMotions turned_motions(ToolMotions motions, const Mat3& turn) {
    motions.clearance_z = -infinity;
    for (Motion& m : motions.motions) {
        m.to = {turn * m.to.tip, turn * m.to.axis};
        motions.clearance_z = std::max(motions.clearance_z, m.to.tip.z());
    }
    return motions;
}

std::shared_ptr<const PreparedPart> with_normals(std::shared_ptr<const PreparedPart> part,
                                                 const Project& project, const Progress& progress) {
    const bool turns =
        std::ranges::any_of(project.operations, [](const auto& o) { return !o->keeps_axis(); });
    if (part->geometry || !turns) return part;
    auto measured = std::make_shared<PreparedPart>(*part);
    measured->geometry = compute_geometry(*part->mesh, progress);
    return measured;
}

} // namespace facetmill
