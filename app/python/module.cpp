// import facetmill: core in Python. Numbers come in and go out as NumPy arrays, in millimetres and radians as
// core has them; what can take a while runs without the interpreter's lock, can be cancelled by a Job, by
// Ctrl-C, and throws what core throws.
#include "app/python/waiting.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/job/whole_job.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/study/study_results.h"
#include "facetmill_version.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace py = pybind11;

namespace facetmill::python {

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

static_assert(sizeof(Vec2) == 2 * sizeof(double) && sizeof(Vec3) == 3 * sizeof(double));

void expect_columns(const py::array& values, py::ssize_t columns, const char* what) {
    if (values.ndim() == 2 && values.shape(1) == columns) return;
    throw Error(ErrorCode::wrong_type, what, "the array has another shape",
                "give one of (n, " + std::to_string(columns) + ")");
}

std::shared_ptr<Mesh> mesh_of(const Doubles& vertices, const Integers& facets) {
    expect_columns(vertices, 3, "vertices");
    expect_columns(facets, 3, "facets");
    auto mesh = std::make_shared<Mesh>();
    const auto v = vertices.unchecked<2>();
    const auto f = facets.unchecked<2>();
    mesh->vertices.resize(std::size_t(v.shape(0)));
    for (py::ssize_t i = 0; i < v.shape(0); ++i) {
        mesh->vertices[std::size_t(i)] = {v(i, 0), v(i, 1), v(i, 2)};
        if (!mesh->vertices[std::size_t(i)].allFinite())
            throw Error(ErrorCode::non_finite, "vertices[" + std::to_string(i) + "]", "is not finite",
                        "leave it out");
    }
    mesh->facets.reserve(std::size_t(f.shape(0)));
    for (py::ssize_t i = 0; i < f.shape(0); ++i) {
        Facet facet{};
        for (int k = 0; k < 3; ++k) {
            if (f(i, k) < 0 || f(i, k) >= v.shape(0))
                throw Error(ErrorCode::out_of_range, "facets[" + std::to_string(i) + "]",
                            "there is no vertex " + std::to_string(f(i, k)), "count them from 0");
            facet[std::size_t(k)] = Index(f(i, k));
        }
        mesh->facets.push_back(facet);
    }
    if (mesh->facets.empty())
        throw Error(ErrorCode::no_facets, "facets", "there are none", "give at least one");
    return mesh;
}

Doubles array_of(const std::vector<Vec3>& points) {
    Doubles array({py::ssize_t(points.size()), py::ssize_t(3)});
    double* to = array.mutable_data();
    for (const Vec3& p : points)
        to = std::copy_n(p.data(), 3, to);
    return array;
}

py::array_t<std::uint32_t> array_of(const std::vector<Facet>& facets) {
    py::array_t<std::uint32_t> array({py::ssize_t(facets.size()), py::ssize_t(3)});
    if (!facets.empty()) std::memcpy(array.mutable_data(), facets.data(), facets.size() * sizeof(Facet));
    return array;
}

std::pair<std::array<double, 3>, std::array<double, 3>> corners(const Box3& box) {
    return {{box.lo.x(), box.lo.y(), box.lo.z()}, {box.hi.x(), box.hi.y(), box.hi.z()}};
}

/// A cutter over a part: made once, lowered as often as one likes.
class DropCutter {
public:
    DropCutter(const std::shared_ptr<Mesh>& mesh, const AptCutter& cutter, double allowance, PythonJob* job)
        : lift_(waited(job, [&](const Progress& progress) {
              return AxialLift(std::make_shared<const ContactIndex>(mesh, progress), CutterProfile(cutter),
                               allowance);
          })) {}

    /// Heights into `out`, an array of as many numbers, or into a new one.
    Doubles drop(const Doubles& points, PythonJob* job, const py::object& out) const {
        expect_columns(points, 2, "points");
        const auto n = std::size_t(points.shape(0));
        Doubles heights = out.is_none() ? Doubles(py::ssize_t(n)) : heights_in(out, py::ssize_t(n));
        const std::span<const Vec2> from(reinterpret_cast<const Vec2*>(points.data()), n);
        const std::span<double> to(heights.mutable_data(), n);
        waited(job, [&](const Progress& progress) {
            lift_.tip_z(from, to, progress);
            return 0;
        });
        return heights;
    }

private:
    /// What is given to be filled is filled, and not a copy of it.
    static Doubles heights_in(const py::object& out, py::ssize_t n) {
        if (py::isinstance<Doubles>(out)) {
            auto array = py::reinterpret_borrow<Doubles>(out);
            if (array.ndim() == 1 && array.shape(0) == n && array.writeable()) return array;
        }
        throw Error(ErrorCode::wrong_type, "out", "heights cannot be written there",
                    "give a writable array of " + std::to_string(n) + " float64, one beside the other");
    }

    AxialLift lift_;
};

py::object parsed(const std::string& json) {
    return py::module_::import("json").attr("loads")(json);
}

std::vector<std::string> names_of(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> names;
    names.reserve(files.size());
    for (const auto& file : files)
        names.push_back(file.string());
    return names;
}

struct Judged {
    std::shared_ptr<const PlannedJob> plan; ///< what it is about
    JudgedJob job;
    const Verification& first() const { return *job.chains.front().result; }
};

std::shared_ptr<PlannedJob> planned(const Project& project, const std::string& only,
                                    const Progress& progress) {
    SetupPlanners planners;
    return std::make_shared<PlannedJob>(plan_job(project, only, planners, {}, Reach::any, progress));
}

std::shared_ptr<Judged> judged(const std::shared_ptr<PlannedJob>& plan, double resolution, double spacing,
                               const Progress& progress) {
    const auto ask = [&](VerifySettings& settings, std::span<const SetupPlan>,
                         std::span<const std::vector<VerifyProgram>>) {
        settings.resolution = resolution;
        settings.sample_spacing = spacing;
    };
    return std::make_shared<Judged>(Judged{plan, judge_job(plan->setups, ask, progress)});
}

py::array_t<float> deviation_of(const Judged& judged) {
    const auto& d = judged.first().surface->deviation;
    return py::array_t<float>(py::ssize_t(d.size()), d.data());
}

py::array_t<float> points_of(const Judged& judged) {
    const auto& p = judged.first().surface->points;
    py::array_t<float> array({py::ssize_t(p.size()), py::ssize_t(3)});
    if (!p.empty()) std::memcpy(array.mutable_data(), p.data(), p.size() * sizeof p[0]);
    return array;
}

py::object study_of(const std::string& file, const std::string& given, PythonJob* job) {
    const std::filesystem::path folder =
        given.empty() ? usual_study_folder(file) : std::filesystem::path(given);
    return parsed(waited(job, [&](const Progress& progress) {
        const StudyFolder study =
            StudyFolder::make(folder, file, program_identity("facetmill.py " FACETMILL_VERSION));
        const StudyOutcome outcome = run_study(study, work_here(), progress);
        write_study(study, outcome);
        check_winner(study, outcome);
        return study_json(study, outcome);
    }));
}

void describe_errors(py::module_& m) {
    static py::exception<Error> error(m, "Error");
    static py::exception<Cancelled> cancelled(m, "Cancelled");
    error.doc() = "What ends a job: `code`, `where`, `what`, `remedy`, as facetmill-cli writes them.";
    // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 asks for this signature
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Error& e) {
            const py::object type = error; // whose own call raises it at once
            py::object one = type(e.what());
            one.attr("code") = std::string(code_name(e.code()));
            one.attr("where") = e.where();
            one.attr("what") = e.message();
            one.attr("remedy") = e.remedy();
            PyErr_SetObject(error.ptr(), one.ptr());
        } catch (const Cancelled& e) {
            cancelled(e.what());
        }
    });
}

void describe_geometry(py::module_& m) {
    py::class_<PythonJob, std::shared_ptr<PythonJob>>(m, "Job", "Progress and cancellation of one call.")
        .def(py::init<>())
        .def("cancel", [](PythonJob& j) { j.job.cancel(); })
        .def_property_readonly("fraction", [](const PythonJob& j) { return j.job.fraction(); })
        .def_property_readonly("label", [](const PythonJob& j) { return j.job.label(); });
    py::class_<Mesh, std::shared_ptr<Mesh>>(m, "Mesh", "Facets on vertices, in mm.")
        .def(py::init(&mesh_of), py::arg("vertices"), py::arg("facets"))
        .def_property_readonly("vertices", [](const Mesh& s) { return array_of(s.vertices); })
        .def_property_readonly("facets", [](const Mesh& s) { return array_of(s.facets); })
        .def_property_readonly("box", [](const Mesh& s) { return corners(s.box()); })
        .def(
            "save",
            [](const Mesh& s, const std::string& file, const std::string& units) {
                save_stl(s, file, parse_mesh_unit(units, "units"), {});
            },
            py::arg("file"), py::arg("units") = "mm")
        .def("__len__", &Mesh::facet_count);
    py::class_<AptCutter>(m, "Cutter", "The APT cutter; lengths in mm, angles in radians.")
        .def(py::init([](const std::string& shape) { return parse_cutter(shape, 1); }), py::arg("shape"))
        .def_static("ball", &AptCutter::ball, py::arg("diameter"), py::arg("height") = unlimited_height)
        .def_static("flat", &AptCutter::flat, py::arg("diameter"), py::arg("height") = unlimited_height)
        .def_static("bull", &AptCutter::bull, py::arg("diameter"), py::arg("corner_radius"),
                    py::arg("height") = unlimited_height)
        .def_static("cone", &AptCutter::cone, py::arg("diameter"), py::arg("half_angle"))
        .def_property_readonly("apt",
                               [](const AptCutter& c) {
                                   return std::array<double, 7>{c.d, c.r, c.e, c.f, c.alpha, c.beta, c.h};
                               })
        .def("height_at", [](const AptCutter& c, double rho) { return CutterProfile(c).height_at(rho); });
    py::class_<DropCutter>(m, "DropCutter", "A cutter over a mesh, lowered along Z.")
        .def(py::init<const std::shared_ptr<Mesh>&, const AptCutter&, double, PythonJob*>(), py::arg("mesh"),
             py::arg("cutter"), py::arg("allowance") = 0.0, py::arg("job") = nullptr)
        .def("drop", &DropCutter::drop, py::arg("points"), py::arg("job") = nullptr,
             py::arg("out") = py::none());
    m.def(
        "load_mesh",
        [](const std::string& file, const std::string& units, PythonJob* job) {
            return waited(job, [&](const Progress& progress) {
                return std::make_shared<Mesh>(
                    *load_mesh(file, parse_mesh_unit(units, "units"), progress).mesh);
            });
        },
        py::arg("file"), py::arg("units") = "mm", py::arg("job") = nullptr);
    m.def(
        "sample",
        [](const std::string& name, double tolerance) {
            return std::make_shared<Mesh>(*make_sample(name, tolerance, {}));
        },
        py::arg("name"), py::arg("tolerance") = default_sample_tolerance);
    m.def("set_threads", &set_thread_count, py::arg("count"));
}

void describe_jobs(py::module_& m) {
    py::class_<Project, std::shared_ptr<Project>>(m, "Project", "A project, as its file has it.")
        .def(
            "set", [](Project& p, const std::string& setting) { apply_setting(p, setting); },
            py::arg("setting"))
        .def_property_readonly("json", [](const Project& p) { return parsed(project_to_json(p)); })
        .def(
            "save", [](const Project& p, const std::string& file) { save_project(p, file); }, py::arg("file"))
        .def(
            "plan",
            [](const Project& p, const std::string& operation, PythonJob* job) {
                return waited(job, [&](const Progress& progress) { return planned(p, operation, progress); });
            },
            py::arg("operation") = "", py::arg("job") = nullptr);
    py::class_<PlannedJob, std::shared_ptr<PlannedJob>>(m, "Plan", "A project planned: its programs.")
        .def_property_readonly("report", [](const PlannedJob& p) { return parsed(p.report()); })
        .def(
            "write",
            [](const PlannedJob& p, const std::string& folder, PythonJob* job) {
                return names_of(
                    waited(job, [&](const Progress& progress) { return p.write(folder, progress); }));
            },
            py::arg("folder"), py::arg("job") = nullptr)
        .def(
            "verify",
            [](const std::shared_ptr<PlannedJob>& p, double resolution, double spacing, PythonJob* job) {
                return waited(
                    job, [&](const Progress& progress) { return judged(p, resolution, spacing, progress); });
            },
            py::arg("resolution") = 0.0, py::arg("spacing") = 0.0, py::arg("job") = nullptr);
    py::class_<Judged, std::shared_ptr<Judged>>(m, "Verification", "What the judge says of a plan.")
        .def_property_readonly("verdict", [](const Judged& j) { return verdict_name(j.job.verdict()); })
        .def_property_readonly("findings", [](const Judged& j) { return j.job.findings(); })
        .def_property_readonly("json", [](const Judged& j) { return parsed(j.job.json()); })
        .def_property_readonly("points", &points_of)
        .def_property_readonly("deviation", &deviation_of)
        .def(
            "write",
            [](const Judged& j, const std::string& folder, PythonJob* job) {
                return names_of(
                    waited(job, [&](const Progress& progress) { return j.job.write(folder, progress); }));
            },
            py::arg("folder"), py::arg("job") = nullptr);
    m.def(
        "load_project", [](const std::string& file) { return std::make_shared<Project>(load_project(file)); },
        py::arg("file"));
    m.def("run_study", &study_of, py::arg("file"), py::arg("folder") = "", py::arg("job") = nullptr);
}

} // namespace

} // namespace facetmill::python

PYBIND11_MODULE(_core, m) {
    m.doc() = "Facetmill's core.";
    m.attr("__version__") = FACETMILL_VERSION;
    facetmill::python::describe_errors(m);
    facetmill::python::describe_geometry(m);
    facetmill::python::describe_jobs(m);
}
