#include "core/job/region_preview.h"

namespace facetmill {

namespace {

/// Ball of the estimate where there is no rework tool: a quarter of the main one, as in Wang's example.
constexpr double usual_rework_share = 0.25;

} // namespace

RegionPreview::Result RegionPreview::find(const Project& project, std::size_t place, const PreparedPart& part,
                                          const Progress& progress) {
    check_project(project);
    const Operation& operation = *project.operations.at(place);
    const GlobalLocalSettings* settings = operation.rework();
    if (!settings)
        throw Error(ErrorCode::internal, operation.common().name, "the operation has no rework regions",
                    "report this");
    PlanContext context = preview_context(project, place, part, {});
    context.geometry = part.geometry;

    // All of the project that the assumed path depends on, and the rest put to rest.
    Project alone;
    alone.part = project.part;
    alone.machine = project.machine;
    alone.tools = {context.tool};
    GlobalLocalSettings same = *settings;
    const GlobalLocalSettings none;
    same.name = none.name;
    same.lead_limit = none.lead_limit;
    same.raise_lead_limit = none.raise_lead_limit;
    same.rework_offset = none.rework_offset;
    same.rework_tool = none.rework_tool;
    same.rework_cutting = none.rework_cutting;
    same.machining_direction = none.machining_direction;
    same.view_direction = none.view_direction;
    same.feed = none.feed;
    same.spindle = none.spindle;
    same.region_edits.clear();
    same.boundary_drags.clear();
    alone.operations.push_back(std::make_unique<GlobalLocal>(same));
    const std::string key = project_to_json(alone);

    Result result;
    if (!index_ || index_->mesh_ptr() != part.mesh) {
        index_ = std::make_shared<ContactIndex>(part.mesh, progress.part(0, 0.1, "Indexing the part"));
        key_.clear();
    }
    if (key != key_) {
        context.contact = index_;
        source_ = region_source(context, *settings, progress.part(0.1, 0.7, "Following the assumed path"));
        key_ = key;
        result.followed = true;
    }
    result.found = find_regions(*source_, *settings, project.unit, {},
                                progress.part(0.7, 0.9, "Finding rework regions"));
    const std::vector<Tool> further = project.further_tools_of(operation);
    const double diameter = context.tool.diameter;
    result.advice = tool_advice(*source_, diameter, *settings,
                                further.empty() ? usual_rework_share * diameter : further.front().diameter,
                                progress.part(0.9, 1, "Comparing tools"));
    return result;
}

} // namespace facetmill
