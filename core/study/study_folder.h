// A study on disk, in a folder that all who work on it see:
//
//     request.json                       the study and the program that works on it
//     project.facetmill                  the project as it stands
//     candidates/KEY/project.facetmill   a candidate's project
//     candidates/KEY/estimate.json       what planning it came to; coarse.json, fine.json
//     study.json, table.md, table.csv    what it all came to
//
// KEY is a hash of the program, the candidate's project, the content of the files that this reads, and what
// candidates are judged by: what is found under it is what would be found again. Every file is written beside
// its place and renamed, so that one which is there is whole, whoever was killed, and when.
#pragma once

#include "core/base/progress.h"
#include "core/study/candidates.h"
#include "core/study/halving.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct StudyRequest {
    std::string program; ///< program_identity of who wrote it
    std::string study;   ///< the study's text
};

/// A program's name, and a hash of its file, where none is given of the one that runs: two builds are two
/// programs. Throws what InputFile does.
std::string program_identity(const std::string& name, const std::filesystem::path& file = "/proc/self/exe");

class StudyFolder {
public:
    /// Writes request and project into a folder, made if missing; what a study there had found and this one
    /// asks again stays found. Throws Error(unwritable), Error(unsupported_format) for a packed project, what
    /// load_project and parse_study throw.
    static StudyFolder make(const std::filesystem::path& folder, const std::filesystem::path& study_file,
                            const std::string& program);
    /// Reads it. Throws Error(not_found, ...); Error(newer_version) where another program wrote it.
    StudyFolder(std::filesystem::path folder, const std::string& program);

    const std::filesystem::path& path() const { return path_; }
    const Study& study() const { return study_; }
    const Project& project() const { return project_; } ///< as it stands
    const std::string& program() const { return program_; }
    std::filesystem::path candidate_folder(const std::string& key) const {
        return path_ / "candidates" / key;
    }

    /// The text of a candidate's project in its folder, and the key of it.
    std::string candidate_file(const Project& candidate) const;
    std::string key_of(const Project& candidate, const std::string& file_text) const;
    /// Writes the project of a candidate where it is not there. Throws Error(unwritable).
    void write_candidate(const std::string& key, const std::string& file_text) const;
    /// The project of a candidate. Throws Error(not_found); Error(out_of_range) where it, or a file that it
    /// reads, is not what the key was made of.
    Project candidate(const std::string& key) const;

    /// Nothing where it is not there, or no such file.
    std::optional<RungResult> result(const std::string& key, Rung rung) const;
    /// Throws Error(unwritable).
    void write_result(const std::string& key, Rung rung, const RungResult& result) const;

private:
    std::filesystem::path path_;
    std::string program_;
    Study study_;
    Project project_;
    std::string judging_;
};

/// Looks at one candidate and writes what it came to, where that is not there yet. Throws what StudyFolder
/// and evaluate do.
void work_on(const StudyFolder& folder, const std::string& key, Rung rung, const Progress& progress);

/// The study beside whose file the folder of a study lies unless one is named: "NAME.study".
std::filesystem::path usual_study_folder(const std::filesystem::path& study_file);

} // namespace facetmill
