#include "app/step/surface_file.h"

#include "core/base/error.h"
#include "core/mesh/tessellated.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>

#include <map>
#include <set>

namespace facetmill::step {

namespace {

std::string capitals(std::string text) {
    for (char& c : text)
        c = char(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return text;
}

/// Millimetres of a unit as STEP and IGES files name it; 1 for a name that is not known.
double mm_of(const std::string& name) {
    static const std::map<std::string, double> known = {
        {"MILLIMETRE", 1},    {"MM", 1},          {"MILLIMETER", 1},   {"CENTIMETRE", 10},
        {"CM", 10},           {"METRE", 1000},    {"M", 1000},         {"METER", 1000},
        {"INCH", 25.4},       {"IN", 25.4},       {"FOOT", 304.8},     {"FT", 304.8},
        {"MICROMETRE", 1e-3}, {"UM", 1e-3},       {"MIL", 0.0254},     {"KILOMETRE", 1e6},
        {"KM", 1e6},          {"MILE", 1609344},  {"MI", 1609344},     {"MICROINCH", 2.54e-5},
        {"UIN", 2.54e-5},     {"CENTIMETER", 10}, {"NANOMETRE", 1e-6}, {"DECIMETRE", 100},
    };
    const auto found = known.find(capitals(name));
    return found == known.end() ? 1 : found->second;
}

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorCode::syntax, "", what, "the file is damaged or of another kind: export it again");
}

template <class Reader>
TopoDS_Shape transferred(Reader& reader, const std::string& path, StepProgress& progress) {
    progress.stretch(0, 0.3, "Reading the file");
    const IFSelect_ReturnStatus status = reader.ReadFile(path.c_str());
    if (status != IFSelect_RetDone) refuse("what it holds cannot be understood");
    const Message_ProgressRange range = progress.stretch(0.3, 0.55, "Building surfaces");
    reader.TransferRoots(range);
    return reader.OneShape();
}

TopoDS_Shape read_step(const std::string& path, SurfaceFile& file, StepProgress& progress) {
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    const TopoDS_Shape shape = transferred(reader, path, progress);
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    if (lengths.Length() > 0) file.unit = lengths.First().ToCString();
    std::set<std::string> seen;
    const auto model = reader.StepModel();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto product = opencascade::handle<StepBasic_Product>::DownCast(model->Entity(i));
        if (product.IsNull() || product->Name().IsNull()) continue;
        const std::string name = product->Name()->ToCString();
        if (!name.empty() && seen.insert(name).second) file.parts.push_back(name);
    }
    return shape;
}

TopoDS_Shape read_iges(const std::string& path, SurfaceFile& file, StepProgress& progress) {
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    reader.SetReadVisible(Standard_True);
    const TopoDS_Shape shape = transferred(reader, path, progress);
    const IGESData_GlobalSection global = reader.IGESModel()->GlobalSection();
    if (!global.UnitName().IsNull()) file.unit = global.UnitName()->ToCString();
    return shape;
}

/// Joins what lies edge to edge; faces keep the numbers they had.
TopoDS_Shape sewn(const TopoDS_Shape& shape, double chord, std::map<int, std::size_t>& numbers,
                  TopTools_IndexedMapOfShape& faces, const Message_ProgressRange& range) {
    BRepBuilderAPI_Sewing sewing(chord);
    std::vector<TopoDS_Shape> given;
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
        given.push_back(e.Current());
        sewing.Add(e.Current());
    }
    sewing.Perform(range);
    const TopoDS_Shape& result = sewing.SewedShape();
    if (result.IsNull()) return {};
    TopExp::MapShapes(result, TopAbs_FACE, faces);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const TopoDS_Shape face = sewing.IsModified(given[i]) ? sewing.Modified(given[i]) : given[i];
        for (TopExp_Explorer e(face, TopAbs_FACE); e.More(); e.Next())
            if (const int at = faces.FindIndex(e.Current())) numbers.emplace(at, i);
    }
    return result;
}

class FaceCollector {
public:
    explicit FaceCollector(SurfaceFile& file) : file_(file) {}

    /// Takes the faces of solids and closed shells as bodies, and what remains as loose.
    template <class NumberOf>
    void take(const TopoDS_Shape& shape, const NumberOf& number_of) {
        const auto add = [&](const TopoDS_Shape& of, TopAbs_ShapeEnum outside, std::size_t body) {
            std::size_t count = 0;
            for (TopExp_Explorer e(of, TopAbs_FACE, outside); e.More(); e.Next(), ++count)
                file_.faces.push_back({TopoDS::Face(e.Current()), number_of(e.Current()), body});
            return count;
        };
        for (TopExp_Explorer e(shape, TopAbs_SOLID); e.More(); e.Next())
            if (add(e.Current(), TopAbs_SHAPE, file_.bodies) > 0) ++file_.bodies;
        std::vector<TopoDS_Shape> open;
        for (TopExp_Explorer e(shape, TopAbs_SHELL, TopAbs_SOLID); e.More(); e.Next()) {
            if (!BRep_Tool::IsClosed(e.Current()))
                open.push_back(e.Current());
            else if (add(e.Current(), TopAbs_SHAPE, file_.bodies) > 0)
                ++file_.bodies;
        }
        for (const TopoDS_Shape& shell : open)
            file_.loose_faces += add(shell, TopAbs_SHAPE, file_.bodies);
        file_.loose_faces += add(shape, TopAbs_SHELL, file_.bodies);
    }

private:
    SurfaceFile& file_;
};

} // namespace

SurfaceFile read_surface_file(const std::string& path, SurfaceFormat format, double chord,
                              StepProgress& progress) {
    SurfaceFile file;
    file.shape =
        format == SurfaceFormat::step ? read_step(path, file, progress) : read_iges(path, file, progress);
    file.mm_per_unit = mm_of(file.unit);
    const bool has_faces = !file.shape.IsNull() && TopExp_Explorer(file.shape, TopAbs_FACE).More();
    if (!has_faces)
        throw Error(ErrorCode::no_facets, "", "it holds no solid and no surface",
                    "export the part as solids or surfaces, not as curves or a mesh");

    // Surfaces of IGES files, and loose ones of STEP files, only lie beside each other.
    TopTools_IndexedMapOfShape faces;
    std::map<int, std::size_t> numbers;
    for (TopExp_Explorer e(file.shape, TopAbs_FACE); e.More(); e.Next())
        ++file.numbers;
    if (!TopExp_Explorer(file.shape, TopAbs_SOLID).More()) {
        const TopoDS_Shape joined =
            sewn(file.shape, chord, numbers, faces, progress.stretch(0.55, 0.6, "Joining surfaces"));
        if (!joined.IsNull() && faces.Extent() > 0) {
            file.shape = joined;
            file.sewn = true;
        }
    }
    std::size_t next = 0;
    FaceCollector(file).take(file.shape, [&](const TopoDS_Shape& face) {
        if (!file.sewn) return next++;
        const auto found = numbers.find(faces.FindIndex(face));
        return found == numbers.end() ? std::size_t(0) : found->second;
    });
    return file;
}

} // namespace facetmill::step
