// The picture of a part, its stock, path and tool, as `facetmill-cli render` and setup sheets show it.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "viz/cspace_display.h"
#include "viz/picture.h"
#include "viz/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct RenderRequest {
    MeshPtr part;
    StockSolid stock; ///< box empty: none
    std::vector<std::shared_ptr<const OperationResult>> operations;
    std::shared_ptr<const std::vector<FixtureSolid>> fixtures; ///< null: none
    StockPatches cut_stock;                                    ///< what the layer `stock` shows instead of it
    std::shared_ptr<const Verification> verification;          ///< for the layers `deviation` and `findings`
    std::optional<DeviationScale> deviation_scale;             ///< default_scale without it
    std::optional<Tool> tool;                                  ///< drawn in the layer `tool` ...
    std::optional<CutterLocation> pose; ///< ... here; without it at the middle cut of the last operation
    std::vector<Layer> layers{Layer::part};
    /// The last operation at this share of its cuts, 0 to 1: deviations behind the tool, the cuts ahead.
    std::optional<double> half_done;
    StandardView view = StandardView::iso;
    std::optional<Vec3> toward_eye; ///< instead of it; a unit vector, Z is up
    bool perspective = false;
    PartStyle part_style = PartStyle::smooth;
    Palette palette = Palette::light;
    LengthUnit unit = LengthUnit::mm;
    std::string title;
    std::string subtitle; ///< empty: the part's size and number of facets
    int width = 1200, height = 900;
};

/// Fills part, stock, operations, unit, title and the tool of the last planned operation from a plan.
void take_plan(RenderRequest& request, const Project& project, const PlanResult& plan);

/// Draws through OSMesa; needs no display. Throws Error(out_of_range) for the size, Error(empty_result) when
/// a layer was asked for and there is nothing to show in it, Cancelled before and between the stages of about
/// 0.1 s.
Picture render_picture(const RenderRequest& request, const Progress& progress);

/// One contact point's configuration space.
struct CSpaceRequest {
    CSpaceContent content;
    Palette palette = Palette::light;
    LengthUnit unit = LengthUnit::mm;
    std::string title, subtitle;
    int width = 1200, height = 900;
};
/// Throws Error(out_of_range) for the size.
Picture render_cspace(const CSpaceRequest& request);

/// "part,stock,cc,cl,strips,tool,edges,deviation" in any order. Throws Error(out_of_range) that names `where`
/// for unknown words and Error(unsupported_format) for the layers whose results Facetmill does not make.
std::vector<Layer> parse_picture_layers(std::string_view text, const std::string& where);

struct PictureSize {
    int width = 0, height = 0;
};
/// "-60,25": a unit vector towards the eye, by the degrees from X towards Y and above the level. Throws
/// Error(out_of_range) that names `where`.
Vec3 parse_eye(std::string_view text, const std::string& where);

/// "1200x900". Throws Error(out_of_range) that names `where`.
PictureSize parse_picture_size(std::string_view text, const std::string& where);

} // namespace facetmill
