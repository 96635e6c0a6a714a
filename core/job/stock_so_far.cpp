#include "core/job/stock_so_far.h"

#include "core/job/axis_view.h"
#include "core/job/cache_key.h"
#include "core/job/verification.h"
#include "core/verify/stock_surface.h"

namespace facetmill {

namespace {

/// Rays of a stock whose surface planners read as a mesh: some million facets at most.
constexpr std::size_t rest_rays = 3'000'000;
/// A minute or less of cutting it.
constexpr double rest_rays_asked = 1e8;

} // namespace

StockSolid rest_after(const StockSolid& stock, std::span<const VerifyProgram> programs,
                      VerifySettings settings, const Progress& progress) {
    settings.usual_rays = rest_rays;
    settings.usual_rays_asked = rest_rays_asked;
    const std::shared_ptr<const StockModel> left =
        stock_after(stock, programs, settings, progress.part(0, 0.7));
    StockSolid rest;
    rest.kind = StockSolid::Kind::mesh;
    auto mesh = std::make_shared<Mesh>(stock_mesh(*left, progress.part(0.7, 1)));
    rest.box = mesh->box();
    rest.mesh = std::move(mesh);
    rest.edge_loss = left->lattice().spacing.maxCoeff();
    return rest;
}

void RestMeshes::begin_plan() {
    for (auto& [key, kept] : kept_)
        kept.used = false;
}

void RestMeshes::end_plan() {
    std::erase_if(kept_, [](const auto& entry) { return !entry.second.used; });
}

StockSolid& RestMeshes::of(const std::string& key) {
    Kept& kept = kept_[key];
    kept.used = true;
    return kept.stock;
}

std::shared_ptr<const EarlierCuts> cuts_of(const OperationResult& operation, double allowance,
                                           const Mat3& turn) {
    const ClSection& program = operation.program;
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = program.cutter;
    // Moves may run into what the allowance leaves by the chord tolerance.
    if (const double chord = operation.path.chord_tolerance; chord > 0)
        cuts->no_nearer = std::max(0.0, allowance - chord);
    const auto& motions = program.motions.motions;
    for (std::size_t i = 1; i < motions.size(); ++i)
        if (motions[i].kind != MotionKind::rapid)
            cuts->motions.push_back({turn * motions[i - 1].to.tip, turn * motions[i].to.tip});
    return cuts;
}

StockSoFar::StockSoFar(const Project& project, const PlanResult& setup, std::string key, RestMeshes& rests)
    : project_(project), setup_(setup), key_(std::move(key)), rests_(rests) {}

void StockSoFar::add(const Operation& operation, const std::shared_ptr<const OperationResult>& result,
                     std::string name) {
    const Vec3 axis = operation.tool_axis();
    if (!result->nothing_to_do.empty()) return cuts_.push_back({axis, nullptr, nullptr, std::move(name)});
    const Mat3 turn = operation.is_indexed() ? turn_upright(axis) : Mat3::Identity();
    cuts_.push_back({axis, result, cuts_of(*result, operation.common().allowance, turn), std::move(name)});
}

std::string StockSoFar::key() const {
    Key key;
    for (const Cut& cut : cuts_)
        key.add(std::string_view(cut.name));
    return key.text();
}

StockSoFar::Before StockSoFar::before(const Operation& operation, const Progress& progress) const {
    // Operations that choose their axes know the stock as upright ones do.
    const Vec3 axis = operation.keeps_axis() ? operation.tool_axis() : Vec3::UnitZ();
    std::size_t others = cuts_.size(); // up to the last that has another axis
    while (others > 0 && (!cuts_[others - 1].result || cuts_[others - 1].axis == axis))
        --others;
    Before before{setup_.stock, {}};
    if (others > 0)
        before.stock = rest(others, progress.part(0, 1, operation.common().name + ": stock left so far"));
    for (std::size_t i = others; i < cuts_.size(); ++i)
        if (cuts_[i].cuts) before.earlier.push_back(cuts_[i].cuts);
    return before;
}

const StockSolid& StockSoFar::rest(std::size_t count, const Progress& progress) const {
    Key key;
    key.add(std::string_view(key_));
    for (std::size_t i = 0; i < count; ++i)
        key.add(std::string_view(cuts_[i].name));
    StockSolid& kept = rests_.of(key.text());
    if (kept.mesh) return kept;
    auto before = std::make_shared<PlanResult>();
    before->part = setup_.part;
    before->stock = setup_.stock;
    for (std::size_t i = 0; i < count; ++i)
        if (cuts_[i].result)
            for (const auto& program : programs_of(cuts_[i].result))
                before->operations.push_back(program);
    StockSolid left = rest_after(before->stock, verify_programs(project_, before),
                                 verify_settings(project_, before.get()), progress);
    if (left.mesh->facets.empty())
        throw Error(ErrorCode::empty_result, "stock", "the operations before leave nothing of it",
                    "leave this operation out, or check what those before it cut");
    return kept = std::move(left);
}

} // namespace facetmill
