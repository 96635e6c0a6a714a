// A machining operation: described parameters and a plan function. One file per kind; it registers itself by
// a line
//
//     const OperationRegistration registration("finish3", "Finish, 3-axis", [] { return
//     std::make_unique<Finish3>(); });
//
// and the forms, the command line, the project file and the reference page know it.
#pragma once

#include "core/base/parameter.h"
#include "core/base/progress.h"
#include "core/gouge/contact_index.h"
#include "core/mesh/geometry.h"
#include "core/setup/boundary.h"
#include "core/setup/machine.h"
#include "core/setup/stock_solid.h"
#include "core/setup/tool.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/plan/shared_parameters.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace facetmill {

struct KeptWithin; // boundary_region.h

/// What an earlier operation cuts: straight motions at feed, axis +Z.
struct EarlierCuts {
    AptCutter cutter;
    std::vector<std::array<Vec3, 2>> motions; ///< tip from, to
    double no_nearer = 0;                     ///< than this to the part the cutter came anywhere, mm
};

/// A place of the part that operations before left.
struct LeftPlace {
    Vec3 point, normal; ///< on the part; unit
    double height = 0;  ///< of the material over it; 0: not known
};

/// What operations before leave, for those that cut it (Operation::reads_left).
struct EarlierLeft {
    std::vector<LeftPlace> points; ///< contact points that they left to clean-up
    std::vector<LeftPlace> rest;   ///< where the verification finds more than the tolerance
    double rest_spacing = 0;       ///< of its samples, mm
};

/// A curve in the plane, looked at along the tool axis.
struct PlanCurve {
    std::vector<Vec2> points; ///< two or more; mm
    bool closed = false;      ///< goes on from the last to the first
};

/// The curves of a boundary that an operation's passes follow (Operation::curve_keys).
struct NamedCurves {
    std::string name; ///< of the boundary; empty: none is named
    std::vector<PlanCurve> all;
};

/// What every strategy gets to work with; all of it const and shared.
struct PlanContext {
    MeshPtr part;
    bool is_piece = false; ///< `part` is a piece of one: its facets face as they are wound
    std::shared_ptr<const MeshGeometry> geometry;
    ContactIndexPtr contact; ///< what must not be cut: the part, and after its facets what else
    Box3 part_box, stock_box;
    Box3 fixtures_box; ///< of what `contact` holds beside the part: fixtures grown by their clearance
    Tool tool;
    Machine machine;
    std::array<double, 2> tessellation_tolerance{0, 0}; ///< out, in (mm); Lu 3.13
    LengthUnit unit = LengthUnit::mm;                   ///< of lengths in warnings and errors, nothing else
    Mat3 to_setup = Mat3::Identity(); ///< turns places there: planners may be asked in turned coordinates
    /// For operations or links that ask what stands (Operation::reads_stock, links_read_stock): the raw
    /// material (its box is stock_box), and what the operations before cut from it, in their order. What cuts
    /// with a tilted axis is left out: material is believed to stand there. A solid whose box is empty stands
    /// for the box stock_box.
    StockSolid stock;
    std::vector<std::shared_ptr<const EarlierCuts>> earlier;
    /// For operations that ask for it; else null.
    std::shared_ptr<const EarlierLeft> left;
    /// Those of Operation::further_tools, in their order.
    std::vector<Tool> further_tools;
    /// Those of Operation::curve_keys, in their order.
    std::vector<NamedCurves> curves;
    /// Curvatures of the part's vertices, where more is known of them than its facets tell (a piece cut out
    /// of a part).
    std::shared_ptr<const std::vector<VertexCurvature>> curvatures;
    /// What planners of layers keep the tool within; null: everywhere. Passes of others are cut to it.
    std::shared_ptr<const KeptWithin> within;

    /// "from above", or for an axis of the operation's own "along the tool axis".
    const char* seen_from() const {
        return to_setup == Mat3::Identity() ? "from above" : "along the tool axis";
    }
    /// Box of part and fixtures.
    Box3 kept_off_box() const {
        Box3 box = part_box;
        box.add(fixtures_box);
        return box;
    }
};

/// What all operations have beside their own keys.
struct OperationCommon {
    std::string name = "Operation";
    bool off = false; ///< left out of plan, verification and programs, as if it were not there
    long tool = 1;
    double tolerance = 0.05;           ///< machining tolerance tau: largest cusp left, mm
    double allowance = 0;              ///< stock left on the part, mm
    double feed = 1000;                ///< mm/min
    NumberOrWord ramp_feed{0, "auto"}; ///< into the material; mm/min, auto: half the feed
    NumberOrWord link_feed{0, "auto"}; ///< between cuts; mm/min, auto: the feed
    double spindle = 6000;             ///< rpm
    double clearance = 5;              ///< height of level rapids above stock and part, mm
    double below_bottom = 0;           ///< how far the cutter may go below the stock's bottom, mm
    /// Direction of the tool axis, from the tip to the spindle, of operations that keep one; any length above
    /// 0.
    std::array<double, 3> tool_axis{0, 0, 1};
    NumberOrWord direction{0, "auto"}; ///< "auto", "x", "y", or the angle of travel from X in radians
    std::string boundary;              ///< name of the boundary to cut within; empty: everywhere
    Containment contain = Containment::contact; ///< what of the tool the boundary keeps within
    std::string avoid;                          ///< name of a boundary to keep off; empty: none
    double avoid_distance = 1;                  ///< from that, mm

    /// What a motion at feed of this kind goes at, mm/min.
    double feed_of(MotionKind kind) const {
        if (kind == MotionKind::approach) return ramp_feed.is_number() ? ramp_feed.number : 0.5 * feed;
        const bool between = kind == MotionKind::link || kind == MotionKind::retract;
        return between && link_feed.is_number() ? link_feed.number : feed;
    }
};

struct LatheCommon;         // lathe.h
struct GlobalLocalSettings; // global_local.h

/// The layers as an operation would choose them; some of them may turn out to cut nothing.
struct LayerPreview {
    std::vector<double> heights;                       ///< the tip's on each layer, from the top down, mm
    double depth_min = 0, depth_max = 0, stepover = 0; ///< between layers; between lines where a floor stays
    double remaining = 0; ///< what they leave above the allowance on the slopes that the part has, at most
    Box3 stock;           ///< as it stands before the operation
};

/// How the passes of an operation are joined (motion.h).
enum class Linking {
    upright,    ///< axis +Z: over the surface, or in rapids over part and stock
    tilted,     ///< axis per location: over the surface, or level beyond what the tilted tool reaches
    over_stock, ///< axis +Z: over the stock as it stands at each moment
    about_axis, ///< around a part that turns; such an operation has `turning()`
};

/// What an operation is for, in the order in which parts are machined.
enum class Purpose { roughing, finishing, cleaning };

/// What an operation is for has been done before it: no fault of the job, which goes on without it.
class NothingToDo : public Error {
public:
    NothingToDo(std::string where, std::string message, std::string remedy)
        : Error(ErrorCode::empty_result, std::move(where), std::move(message), std::move(remedy)) {}
};

class Operation : public Parameterized {
public:
    virtual std::string_view kind() const = 0;
    virtual std::unique_ptr<Operation> clone() const = 0;
    /// Throws Error(empty_result) with the reason when nothing can be cut, as NothingToDo where that is as it
    /// should be.
    virtual StrategyResult plan(const PlanContext& context, const Progress& progress) const = 0;
    virtual Purpose purpose() const { return Purpose::finishing; }
    /// True when the tool keeps one axis, `common().tool_axis`. Such an operation is planned with the axis
    /// +Z, over a part that is turned accordingly.
    virtual bool keeps_axis() const = 0;
    /// True when every tool axis is +Z.
    bool three_axis() const { return keeps_axis() && !is_indexed(); }
    /// True when the tool axis is to be another one than +Z, the same everywhere ("3+2").
    bool is_indexed() const;
    /// The unit vector of `common().tool_axis`: +Z to the last digit where it is that.
    Vec3 tool_axis() const;
    virtual Linking linking() const { return keeps_axis() ? Linking::upright : Linking::tilted; }
    /// The settings of an operation that turns the part about an axis; else null.
    virtual const LatheCommon* turning() const { return nullptr; }
    /// The settings of an operation that leaves regions to rework with a smaller tool; else null.
    virtual const GlobalLocalSettings* rework() const { return nullptr; }
    /// True when `preview_layers` tells the layers without planning them.
    virtual bool has_layer_preview() const { return false; }
    /// Needs neither contact index nor geometry in the context. Throws what `plan` does of depth, step-over,
    /// tolerance and stock; Error(internal) where there is no preview.
    virtual LayerPreview preview_layers(const PlanContext& context, const Progress& progress) const;
    /// What it leaves on the part on purpose, mm.
    virtual double left_on_purpose() const { return common().allowance; }
    /// True when the plan depends on what stands of the stock: raw material and earlier operations.
    virtual bool reads_stock() const { return false; }
    /// True when the links do; those of an operation that reads the stock do anyway.
    bool links_read_stock() const { return reads_stock() || linking() == Linking::tilted; }
    /// What of the operations before it the plan depends on beside that.
    struct ReadsLeft {
        bool points = false, rest = false; ///< of EarlierLeft
        bool any() const { return points || rest; }
    };
    virtual ReadsLeft reads_left() const { return {}; }
    /// Numbers of the tools that the operation uses or asks about, beside its own.
    virtual std::vector<long> further_tools() const { return {}; }
    /// A tool that it uses got another number.
    virtual void renumber_tool(long from, long to) {
        if (common().tool == from) common().tool = to;
    }
    /// Keys of parameters that name boundaries whose curves the passes follow; an empty name stands for none.
    virtual std::vector<std::string> curve_keys() const { return {}; }
    /// The boundaries that they name.
    std::vector<std::string> curve_names() const;
    /// A boundary that it names got another name.
    void rename_boundary(const std::string& from, const std::string& to);
    /// What shank and holder keep from the part, mm.
    virtual double holder_clearance() const { return 0; }

    /// True when its time is counted with what the axes take to change their speed.
    virtual bool accelerations() const { return false; }

    virtual const OperationCommon& common() const = 0;
    virtual OperationCommon& common() = 0;
};

/// An operation whose settings are a struct, derived from OperationCommon, with a table of its parameters.
template <class Settings, const ParameterTable<Settings>& (*table)()>
class OperationWith : public Operation {
public:
    OperationWith() = default;
    explicit OperationWith(Settings settings) : settings_(std::move(settings)) {}

    const OperationCommon& common() const override { return settings_; }
    OperationCommon& common() override { return settings_; }
    const Settings& settings() const { return settings_; }

    std::vector<const ParameterInfo*> parameters() const override {
        Settings unused;
        return ParameterView(unused, table()).parameters();
    }
    ParameterValue get(std::string_view key) const override {
        Settings copy = settings_;
        return ParameterView(copy, table()).get(key);
    }
    void set(std::string_view key, const ParameterValue& value) override {
        ParameterView(settings_, table()).set(key, value);
    }

protected:
    Settings settings_;
};

/// Throws Error(empty_result) for a part without facets, Error(out_of_range) for a tolerance that is not
/// above 0.
void check_plannable(const PlanContext& context, const OperationCommon& settings);

struct OperationKind {
    std::string kind, label;
    std::function<std::unique_ptr<Operation>()> make;
};

/// In alphabetical order of `kind`.
const std::vector<OperationKind>& operation_kinds();
/// Throws Error(out_of_range) that lists the known kinds.
std::unique_ptr<Operation> make_operation(std::string_view kind);

struct OperationRegistration {
    OperationRegistration(std::string kind, std::string label,
                          std::function<std::unique_ptr<Operation>()> make);
};

/// Where the part is while an operation cuts it.
enum class Workholding {
    on_table, ///< there is something below its bottom
    turning,
};

/// Adds the common parameters to an operation's table. S derives from OperationCommon.
template <class S>
void add_common_parameters(ParameterTable<S>& table, Workholding holding = Workholding::on_table);
/// And that of an operation which may keep another tool axis than +Z.
template <class S>
void add_tool_axis_parameter(ParameterTable<S>& table);

} // namespace facetmill

#include "core/strategy/plan/operation_common.inl"
