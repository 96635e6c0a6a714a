#include "tests/support/surface_files.h"

#ifdef FACETMILL_HAS_OCCT

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Sphere.hxx>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#endif

namespace facetmill::test {

#ifdef FACETMILL_HAS_OCCT

namespace {

std::string written(const auto& write) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("facetmill-surfaces-" + std::to_string(::getpid()));
    write(path.c_str());
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    std::filesystem::remove(path);
    return bytes.str();
}

std::string step_of(const TopoDS_Shape& shape, const char* unit = "MM", int schema = 1) {
    return written([&](const char* path) {
        STEPControl_Writer writer;
        Interface_Static::SetIVal("write.step.schema", schema);
        Interface_Static::SetCVal("write.step.unit", unit);
        Interface_Static::SetIVal("write.step.assembly", 2); // compounds are assemblies
        writer.Model(Standard_True);
        writer.Transfer(shape, STEPControl_AsIs);
        writer.Write(path);
    });
}

} // namespace

const char* no_surface_files() {
    return nullptr;
}

std::string step_box(double x, double y, double z, const char* unit) {
    return step_of(BRepPrimAPI_MakeBox(x, y, z).Shape(), unit);
}

std::string step_cylinder(double radius, double height) {
    return step_of(BRepPrimAPI_MakeCylinder(radius, height).Shape());
}

std::string step_sphere(double radius) {
    return step_of(BRepPrimAPI_MakeSphere(radius).Shape());
}

std::string step_torus(double large, double small) {
    return step_of(BRepPrimAPI_MakeTorus(large, small).Shape());
}

std::string step_block_with_hole(double radius) {
    const gp_Ax2 axis(gp_Pnt(50, 50, -1), gp_Dir(0, 0, 1));
    return step_of(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(100, 100, 20).Shape(),
                                   BRepPrimAPI_MakeCylinder(axis, radius, 40).Shape())
                       .Shape());
}

const std::vector<std::string>& step_solids() {
    static const std::vector<std::string> all = {"box",    "cylinder", "cone",    "wedge", "torus",
                                                 "sphere", "hole",     "rounded", "slope", "bottle"};
    return all;
}

StepSolid step_solid(const std::string& name, const char* unit, int schema) {
    const double pi = std::acos(-1.0);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
    const auto as = [&](const TopoDS_Shape& shape, double volume) {
        return StepSolid{step_of(shape, unit, schema), volume};
    };
    if (name == "cylinder") return as(BRepPrimAPI_MakeCylinder(6, 25).Shape(), pi * 36 * 25);
    if (name == "cone") return as(BRepPrimAPI_MakeCone(10, 4, 15).Shape(), pi * 15 / 3 * (100 + 40 + 16));
    if (name == "wedge") return as(BRepPrimAPI_MakeWedge(20, 10, 15, 8).Shape(), (20 + 8) / 2.0 * 10 * 15);
    if (name == "torus") return as(BRepPrimAPI_MakeTorus(20, 5).Shape(), 2 * pi * pi * 20 * 25);
    if (name == "sphere") return as(BRepPrimAPI_MakeSphere(12).Shape(), 4 * pi / 3 * 12 * 12 * 12);
    if (name == "hole")
        return as(
            BRepAlgoAPI_Cut(
                box, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 10, -1), gp_Dir(0, 0, 1)), 5, 20).Shape())
                .Shape(),
            30 * 20 * 10 - pi * 25 * 10);
    if (name == "rounded" || name == "slope") {
        BRepFilletAPI_MakeFillet fillet(box);
        BRepFilletAPI_MakeChamfer chamfer(box);
        bool cut = false;
        for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                         b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
            if (std::abs(a.X() - b.X()) + std::abs(a.Y() - b.Y()) > 1e-9) continue; // upright ones
            fillet.Add(4, edge);
            if (!cut) chamfer.Add(3, edge);
            cut = true;
        }
        // Every edge is found from both of its faces; rounding it twice is rounding it once.
        return name == "rounded" ? as(fillet.Shape(), 30 * 20 * 10 - (4 - pi) * 16 * 10)
                                 : as(chamfer.Shape(), 30 * 20 * 10 - 3 * 3 / 2.0 * 10);
    }
    if (name == "bottle") { // r = 5 + z (20 - z) / 25, turned about Z
        TColgp_Array1OfPnt poles(1, 3);
        poles(1) = gp_Pnt(5, 0, 0);
        poles(2) = gp_Pnt(13, 0, 10);
        poles(3) = gp_Pnt(5, 0, 20);
        TColStd_Array1OfReal knots(1, 2);
        knots(1) = 0;
        knots(2) = 1;
        TColStd_Array1OfInteger turns(1, 2);
        turns(1) = turns(2) = 3;
        const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, turns, 2);
        const TopoDS_Wire outline =
            BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge(),
                                    BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 20), gp_Pnt(0, 0, 20)).Edge(),
                                    BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 20), gp_Pnt(0, 0, 0)).Edge(),
                                    BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(5, 0, 0)).Edge());
        const TopoDS_Shape turned = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline).Face(),
                                                          gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
                                        .Shape();
        // Integral of pi r^2 with r = 5 + 16 t (1 - t), z = 20 t.
        return as(turned, 20 * pi * (25 + 160 / 6.0 + 256 / 30.0));
    }
    return as(box, 30 * 20 * 10);
}

std::string step_assembly(int boxes, int along) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < boxes; ++i) {
        gp_Trsf place;
        place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), (i % 4) * std::acos(-1.0) / 2);
        gp_Trsf move;
        move.SetTranslation(gp_Vec(10 * (i % along), 10 * (i / along), 0));
        builder.Add(all, box.Moved(TopLoc_Location(move * place)));
    }
    return step_of(all);
}

std::string step_bowl(double radius) {
    return step_of(
        BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), radius), 0, 2 * std::acos(-1.0), -std::acos(-1.0) / 2, 0)
            .Shape());
}

std::string step_wire() {
    return step_of(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 3)).Shape());
}

std::string iges_cylinder(double radius, double height, bool solid) {
    return written([&](const char* path) {
        IGESControl_Writer writer("MM", solid ? 1 : 0);
        writer.AddShape(BRepPrimAPI_MakeCylinder(radius, height).Shape());
        writer.ComputeModel();
        writer.Write(path);
    });
}

#else

const char* no_surface_files() {
    return "this build has no OpenCASCADE: STEP and IGES files are not read";
}

std::string step_box(double, double, double, const char*) {
    return {};
}
std::string step_cylinder(double, double) {
    return {};
}
std::string step_sphere(double) {
    return {};
}
std::string step_torus(double, double) {
    return {};
}
std::string step_block_with_hole(double) {
    return {};
}
const std::vector<std::string>& step_solids() {
    static const std::vector<std::string> none;
    return none;
}
StepSolid step_solid(const std::string&, const char*, int) {
    return {};
}
std::string step_assembly(int, int) {
    return {};
}
std::string step_bowl(double) {
    return {};
}
std::string step_wire() {
    return {};
}
std::string iges_cylinder(double, double, bool) {
    return {};
}

#endif

} // namespace facetmill::test
