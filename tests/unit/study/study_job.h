// A little roof, a project for it that is planned and judged in some hundredths of a second, and studies.
#pragma once

#include "core/job/project.h"
#include "core/study/study.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <filesystem>
#include <string>

namespace facetmill::test {

struct StudyJob {
    StudyJob() {
        write("roof.stl", R"(solid roof
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 0 0 vertex 20 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 10 4 vertex 0 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 10 4 vertex 20 10 4 vertex 10 20 0 endloop endfacet
endsolid roof
)");
        write("job.facetmill", R"({ "facetmill": 1, "units": "mm", "part": { "file": "roof.stl" },
            "stock": { "kind": "box", "margin": [4, 4, 1] },
            "tools": [ { "number": 1, "diameter": 10, "corner_radius": 5, "flute_length": 20, "shank_length": 20 },
                       { "number": 2, "diameter": 8, "corner_radius": 4, "flute_length": 20, "shank_length": 20 } ],
            "operations": [ { "kind": "rough", "name": "Rough", "tool": 2, "tolerance": 1, "allowance": 0.3 },
                            { "kind": "finish3", "name": "Fine", "tool": 1, "tolerance": 0.3 } ] })");
        project = load_project(path("job.facetmill"));
    }
    std::filesystem::path path(const std::string& name) const {
        return std::filesystem::path(dir.path().toStdString()) / name;
    }
    void write(const std::string& name, const std::string& bytes) const {
        QFile file(QString::fromStdString(path(name).string()));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), qint64(bytes.size())) < 0)
            qFatal("cannot write %s", name.c_str());
    }
    std::string read(const std::string& name) const {
        QFile file(QString::fromStdString(path(name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }
    /// Of the members beside `study`, `project` and `want`.
    static std::string text(const std::string& members) {
        return R"({ "study": 1, "project": "job.facetmill", "want": ["machining_time"], )" + members + " }";
    }
    Study study(const std::string& members) const { return parse_study(text(members), "study", project); }

    QTemporaryDir dir;
    Project project;
};

} // namespace facetmill::test
