// The formats of library_file.h one by one. Internal to this room.
#pragma once

#include "core/tools/library_file.h"
#include "core/tools/loose_json.h"

namespace facetmill {

/// What is said of one tool of a file.
class ToolRemarks {
public:
    explicit ToolRemarks(std::vector<std::string>& all) : all_(all) {}
    /// What the remarks that follow are about.
    void about(const LibraryTool& tool);
    void about(std::string what) { what_ = std::move(what); }
    void add(const std::string& remark) { all_.push_back(what_ + ": " + remark); }
    /// "... is not carried", for every member that nobody has asked for.
    void not_carried(const LooseObject& object);

private:
    std::vector<std::string>& all_;
    std::string what_;
};

/// What a tool's shape comes to in formats that know kinds of cutters. Angles in radians.
enum class CutterKind { flat, ball, bull, tapered, tapered_ball, drill, chamfer };
struct CutterSizes {
    CutterKind kind = CutterKind::flat;
    double diameter = 0;     ///< the largest; of a tapered cutter that at its tip
    double tip_diameter = 0; ///< of a chamfer mill
    double corner_radius = 0;
    double angle = 0; ///< from the axis: of a tapered cutter's side, of a chamfer mill's or a drill's point
    double flute_length = 0;
};
/// The kind that says everything of a tool's cutter; none for other cutters.
std::optional<CutterSizes> sizes_of(const Tool& tool);
/// The cutter of a tool; its shank stays as it is. Throws Error(out_of_range) for what makes no cutter.
void set_cutter(Tool& tool, const CutterSizes& sizes);

/// A shank above the flutes that ends where the holder begins; `below_holder` counts from the tip.
void set_shank(Tool& tool, std::optional<double> diameter, std::optional<double> below_holder);

/// The tool is put into the library, or, where its values make none, a remark.
void add_checked(ReadLibrary& read, LibraryTool tool, ToolRemarks& remarks);

/// A JSON text as it is written to a file.
std::string json_file(const Json& json);

ReadLibrary read_own(const Json& json, const std::string& name);
std::string write_own(const ToolLibrary& library);

ReadLibrary read_fusion(const Json& json);
std::string write_fusion(const ToolLibrary& library, std::vector<std::string>& remarks);

ReadLibrary read_freecad_tool(const Json& json, LengthUnit unit);
ReadLibrary read_freecad_library(const Json& json, LengthUnit unit, const NamedFiles& files);
ReadLibrary read_freecad_holder(const Json& json);
std::string write_freecad_tool(const LibraryTool& tool, LengthUnit unit, std::vector<std::string>& remarks);
WrittenLibrary write_freecad_library(const ToolLibrary& library, const std::string& name);
std::string write_freecad_holder(const ToolHolder& holder, LengthUnit unit);

ReadLibrary read_linuxcnc(std::string_view text, const std::string& name, LengthUnit unit);
std::string write_linuxcnc(const ToolLibrary& library, std::vector<std::string>& remarks);

ReadLibrary read_camotics(const Json& json);
std::string write_camotics(const ToolLibrary& library, std::vector<std::string>& remarks);

ReadLibrary read_kiri(const Json& json);
std::string write_kiri(const ToolLibrary& library, std::vector<std::string>& remarks);

} // namespace facetmill
