#include "tests/support/surface_files.h"

#ifdef FACETMILL_HAS_OCCT

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
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

std::string step_of(const TopoDS_Shape& shape, const char* unit = "MM") {
    return written([&](const char* path) {
        STEPControl_Writer writer;
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
