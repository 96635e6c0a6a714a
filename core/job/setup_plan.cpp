#include "core/job/setup_plan.h"

#include "core/base/units.h"
#include "core/job/asked_operations.h"
#include "core/job/cache_key.h"
#include "core/job/project_inputs.h"
#include "core/job/repaired_mesh.h"
#include "core/job/stock_so_far.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"

#include <algorithm>
#include <bit>

namespace facetmill {

namespace {

std::string setup_words(const Setup& setup) {
    return "setup '" + printable(setup.name) + "'";
}

std::string content_key(const Mesh& mesh) {
    std::uint64_t key[2] = {0x9E3779B97F4A7C15u, 0xD6E8FEB86659FD93u};
    const auto take = [&](std::uint64_t bits) {
        for (std::size_t k = 0; k < 2; ++k) {
            const auto product = static_cast<unsigned __int128>(key[k] ^ bits)
                                 * (k == 0 ? 0xA0761D6478BD642Fu : 0xE7037ED1A0B428DBu);
            key[k] = std::uint64_t(product) ^ std::uint64_t(product >> 64) ^ (bits + k);
        }
    };
    for (const Vec3& p : mesh.vertices)
        for (int k = 0; k < 3; ++k)
            take(std::bit_cast<std::uint64_t>(p[k] + 0.0));
    for (const Facet& f : mesh.facets)
        for (const Index i : f)
            take(i);
    return std::to_string(mesh.vertices.size()) + "|" + std::to_string(mesh.facets.size()) + "|"
           + std::to_string(key[0]) + "|" + std::to_string(key[1]);
}

Box3 moved_box(const Box3& box, const SetupFrame& frame) {
    Box3 moved;
    for (int corner = 0; corner < 8; ++corner)
        moved.add(frame(Vec3((corner & 1 ? box.hi : box.lo).x(), (corner & 2 ? box.hi : box.lo).y(),
                             (corner & 4 ? box.hi : box.lo).z())));
    return moved;
}

/// A stock of its own that is nowhere near that of the setup before is a slip of a placement. `own`: its box.
void check_meeting(const SetupPlan& before, const Project& setup, const Box3& own) {
    const Box3 earlier = moved_box(before.plan->stock.box, frame_between(before.project, setup));
    if (earlier.empty() || own.empty()) return;
    const double apart = std::max((earlier.lo - own.hi).maxCoeff(), (own.lo - earlier.hi).maxCoeff());
    if (apart < 0) return;
    throw Error(ErrorCode::out_of_range, "stock",
                "it does not meet the stock of " + setup_words(before.project) + ": they are "
                    + length_text(apart, setup.unit) + " apart as the part lies in both",
                "check `place` of both setups and where the stock's mesh is, or let the setup go on with the "
                "rest");
}

void check_known(const Project& project, const std::string& operation) {
    std::vector<std::string> names;
    for (const Operation* o : all_operations(project))
        names.push_back(o->common().name);
    if (!operation.empty() && std::find(names.begin(), names.end(), operation) == names.end())
        refuse_operation(operation, names);
}

bool goes_on(const Setup& setup) {
    return setup.stock.kind == StockSpec::Kind::rest;
}

/// A setup whose operations are all switched off is left out: not where that is all there is, nor where a
/// setup goes on with stock that is its own.
bool is_left_out(const Project& project, std::size_t i) {
    const std::size_t n = setup_count(project);
    const auto works = [&](std::size_t k) {
        const Setup& setup = setup_at(project, k);
        return setup.operations.empty() || !operations_on(setup).empty();
    };
    if (works(i) || (!goes_on(setup_at(project, i)) && i + 1 < n && goes_on(setup_at(project, i + 1))))
        return false;
    for (std::size_t k = 0; k < n; ++k)
        if (works(k)) return true;
    return false;
}

std::shared_ptr<const PlanResult> plan_view(Planner& planner, const Project& view,
                                            const std::string& only_operation, const Progress& progress) {
    auto plan = planner.plan(view, only_operation, progress);
    plan->check_programs();
    return plan;
}

} // namespace

std::string stock_source(const Project& project, const FileText& file_text) {
    if (project.stock.kind != StockSpec::Kind::rest || project.before.empty()) return {};
    Project earlier = view_of_setup(project, chosen_setup(project) - 1);
    earlier.after.clear();
    Key key;
    key.add(std::string_view(project_to_json(earlier)))
        .add(project.place.rotate)
        .add(project.place.translate);
    for (std::size_t i = 0; i < setup_count(earlier); ++i)
        for (const ProjectInput& input : project_inputs(view_of_setup(earlier, i)))
            if (input.kind != ProjectInput::Kind::post) key.add(std::string_view(file_text(input.path)));
    return key.text();
}

SetupPlanners::SetupPlanners(std::shared_ptr<KnownMeshes> meshes)
    : meshes_(meshes ? std::move(meshes) : std::make_shared<KnownMeshes>()) {}

Planner& SetupPlanners::at(std::size_t setup) {
    while (planners_.size() <= setup)
        planners_.push_back(std::make_unique<Planner>(meshes_));
    return *planners_[setup];
}

std::shared_ptr<const CarriedStock> SetupPlanners::known_rest(const Project& project) {
    if (!goes_on(project)) return nullptr;
    const auto& carried = at(chosen_setup(project)).carried();
    return carried && carried->source == stock_source(project) ? carried : nullptr;
}

std::vector<SetupPlan> plan_setups(const Project& project, const std::string& only_operation,
                                   SetupPlanners& planners, const Progress& progress, const PlanSetup& plan) {
    const std::size_t n = setup_count(project);
    std::size_t first = 0, last = n;
    if (n > 1 && !only_operation.empty()) {
        check_known(project, only_operation);
        last = setup_of_operation(project, only_operation) + 1;
        first = setups_of_stock(project, last - 1).first;
    }
    std::vector<SetupPlan> setups;
    for (std::size_t i = first; i < last; ++i) {
        const double share = 1 / double(last - first), at = double(i - first) * share;
        const Progress running = progress.part(at, at + share);
        SetupPlan setup{view_of_setup(project, i), nullptr, only_operation.empty() || i + 1 == last};
        if (only_operation.empty() && is_left_out(project, i)) continue;
        try {
            const bool rests = goes_on(setup.project) && !setups.empty();
            if (rests) {
                auto rest = planners.known_rest(setup.project);
                if (!rest)
                    rest = carried_stock(stock_chains(setups).back(), setup.project, running.part(0, 0.3));
                planners.at(i).carry(std::move(rest));
            }
            if (!rests && !setups.empty()) {
                const auto part = planners.at(i).prepare(setup.project, running.part(0, 0.05));
                check_meeting(setups.back(), setup.project, stock_solid(setup.project.stock, *part).box);
            }
            setup.plan = (plan ? plan : plan_view)(planners.at(i), setup.project,
                                                   setup.asked ? only_operation : std::string(),
                                                   rests ? running.part(0.3, 1) : running.part(0.05, 1));
        } catch (const Error& e) {
            if (n == 1) throw;
            throw e.within(setup_words(setup.project));
        }
        setups.push_back(std::move(setup));
    }
    return setups;
}

std::shared_ptr<const CarriedStock> stock_before(const Project& project, SetupPlanners& planners,
                                                 const Progress& progress, const PlanSetup& plan) {
    const std::size_t setup = chosen_setup(project);
    if (!goes_on(project) || setup == 0) return nullptr;
    // Those before it are a project of their own.
    Project earlier = view_of_setup(project, setup - 1);
    earlier.after.clear();
    const std::vector<SetupPlan> setups = plan_setups(earlier, {}, planners, progress.part(0, 0.8), plan);
    return carried_stock(stock_chains(setups).back(), project, progress.part(0.8, 1));
}

SetupRange setups_of_stock(const Project& project, std::size_t setup) {
    SetupRange range{setup, setup + 1};
    while (range.first > 0 && goes_on(setup_at(project, range.first)))
        --range.first;
    while (range.last < setup_count(project) && goes_on(setup_at(project, range.last)))
        ++range.last;
    return range;
}

std::vector<std::span<const SetupPlan>> stock_chains(std::span<const SetupPlan> setups) {
    std::vector<std::span<const SetupPlan>> chains;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (chains.empty() || !goes_on(setups[i].project))
            chains.push_back(setups.subspan(i, 1));
        else
            chains.back() = {chains.back().data(), chains.back().size() + 1};
    }
    return chains;
}

SetupFrame frame_between(const Setup& from, const Setup& to) {
    return frame_of(to.place).after(frame_of(from.place).inverse());
}

VerifyProgram moved_program(const VerifyProgram& program, const SetupFrame& frame) {
    if (frame.is_identity()) return program;
    VerifyProgram moved = program;
    auto motions = std::make_shared<ToolMotions>(*program.motions);
    for (Motion& m : motions->motions)
        m.to = {frame(m.to.tip), frame.turn * m.to.axis};
    const auto turn = [&](std::optional<TurningAxis>& axis) {
        if (axis) axis = TurningAxis{frame(axis->point), frame.turn * axis->direction};
    };
    turn(motions->turning);
    turn(moved.turning);
    moved.motions = std::move(motions);
    if (program.fixtures) {
        auto fixtures = std::make_shared<std::vector<FixtureSolid>>(*program.fixtures);
        for (FixtureSolid& fixture : *fixtures) {
            auto mesh = std::make_shared<Mesh>(*fixture.mesh);
            for (Vec3& p : mesh->vertices)
                p = frame(p);
            fixture.mesh = std::move(mesh);
            fixture.grown = nullptr; // of planners
        }
        moved.fixtures = std::move(fixtures);
    }
    if (moved.seen_along) moved.seen_along = frame.turn * *moved.seen_along;
    moved.machine_turn = exact_turn(frame.turn * program.machine_turn);
    return moved;
}

std::vector<std::vector<VerifyProgram>> planned_programs(std::span<const SetupPlan> chain) {
    std::vector<std::vector<VerifyProgram>> programs;
    for (const SetupPlan& setup : chain)
        programs.push_back(verify_programs(setup.project, setup.plan));
    return programs;
}

ChainPrograms chain_programs(std::span<const SetupPlan> chain,
                             std::span<const std::vector<VerifyProgram>> programs) {
    ChainPrograms all;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const SetupFrame frame = frame_between(chain[i].project, chain.front().project);
        for (const VerifyProgram& program : programs[i]) {
            all.programs.push_back(i == 0 ? program : moved_program(program, frame));
            all.setups.push_back(i);
        }
    }
    return all;
}

VerifySettings chain_settings(std::span<const SetupPlan> chain) {
    VerifySettings all = verify_settings(chain.front().project, chain.front().plan.get());
    all.cut_before = false; // it is judged on the stock of the first
    for (const SetupPlan& setup : chain.subspan(1)) {
        const VerifySettings own = verify_settings(setup.project, setup.plan.get());
        if (own.allowance < all.allowance) {
            all = own;
            all.cut_before = false;
        } else if (own.allowance == all.allowance) {
            all.tolerance = std::max(all.tolerance, own.tolerance);
            all.gouge_limit = std::max(all.gouge_limit, own.gouge_limit);
        }
    }
    return all;
}

std::string tolerance_remark(std::span<const SetupPlan> chain) {
    const VerifySettings all = chain_settings(chain);
    for (const SetupPlan& setup : chain) {
        const VerifySettings own = verify_settings(setup.project, setup.plan.get());
        if (own.allowance == all.allowance && own.tolerance < all.tolerance)
            return "The tolerances of the setups differ: what is left was held against the largest, "
                   + length_text(all.tolerance, setup.project.unit) + ".";
    }
    return {};
}

std::shared_ptr<const CarriedStock> carried_stock(std::span<const SetupPlan> chain, const Project& next,
                                                  const Progress& progress) {
    const SetupPlan& first = chain.front();
    const ChainPrograms all = chain_programs(chain, planned_programs(chain));
    const SetupFrame frame = frame_between(first.project, next);
    const StockSolid rest = rest_after(first.plan->stock, all.programs, chain_settings(chain),
                                       progress.part(0, 0.95, next.name + ": stock left so far"));
    if (rest.mesh->facets.empty())
        throw Error(ErrorCode::empty_result, "stock",
                    "nothing of it is left by " + setup_words(chain.back().project),
                    "check the placements, or give the setup a stock of its own");
    auto mesh = std::make_shared<Mesh>(*rest.mesh);
    for (Vec3& p : mesh->vertices)
        p = frame(p);
    auto carried = std::make_shared<CarriedStock>();
    carried->edge_loss = rest.edge_loss;
    carried->key = content_key(*mesh);
    carried->source = stock_source(next);
    carried->mesh = std::move(mesh);
    progress.set(1.0);
    return carried;
}

} // namespace facetmill
