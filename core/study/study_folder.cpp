#include "core/study/study_folder.h"

#include "core/base/file.h"
#include "core/base/keyed_hash.h"
#include "core/base/strict_json.h"
#include "core/job/cache_key.h"
#include "core/job/kept_folder.h"
#include "core/job/new_folder.h"
#include "core/job/project_inputs.h"
#include "core/study/evaluation.h"

#include <memory>
#include <system_error>

namespace facetmill {

namespace fs = std::filesystem;
using namespace strict;

namespace {

/// Names of files only: what a study finds is not sealed against its own user.
constexpr HashKey study_hash_key{{0x66616365746d696cu, 0x7374756479000001u}};
constexpr const char* request_name = "request.json";
constexpr const char* project_name = "project.facetmill";

std::string text_of(const fs::path& path) {
    const InputFile file(path);
    return std::string(file.bytes());
}

void write_text(const fs::path& path, const std::string& text) {
    OutputFile out(path);
    out.write(text);
    out.commit();
}

void make_folder(const fs::path& folder) {
    std::error_code ec;
    fs::create_directories(folder, ec);
    if (!fs::is_directory(folder, ec))
        throw Error(ErrorCode::unwritable, printable(folder.string(), 400), "the folder cannot be made",
                    "check its place, permissions and the disk");
}

/// Files of all setups by their content: the same bytes in another place are the same.
std::string contents_of(const Project& project) {
    Key key;
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const ProjectInput& input : project_inputs(view_of_setup(project, i)))
            if (!is_missing(input.path)) key.add(content_text(input.path, study_hash_key, {}));
    return key.text();
}

Json result_json(const RungResult& result) {
    Json measures = Json::object();
    for (const Measure m : all_measures())
        if (result.measures[m])
            measures[std::string(measure_name(m))] = json_number(*result.measures[m], "study");
    return Json{{"passed", result.passed}, {"why", printable(result.why, 2000)}, {"measures", measures}};
}

RungResult read_result(const Json& object, const std::string& name) {
    RungResult result;
    expect_object(object, name);
    const Json& passed = require(object, name, "passed", "run the study again");
    if (!passed.is_boolean()) wrong_type(member(name, "passed"), passed, "true or false");
    result.passed = passed.get<bool>();
    result.why = require(object, name, "why", "run the study again").get<std::string>();
    const Json& measures = require(object, name, "measures", "run the study again");
    for (auto it = measures.begin(); it != measures.end(); ++it)
        result.measures[measure_named(it.key(), name)] = it.value().get<double>();
    return result;
}

} // namespace

std::string program_identity(const std::string& name, const fs::path& file) {
    return name + " " + content_text(file, study_hash_key, {});
}

fs::path usual_study_folder(const fs::path& study_file) {
    std::string stem = study_file.stem().string();
    if (!stem.ends_with(".study")) stem += ".study";
    return study_file.parent_path() / stem;
}

StudyFolder StudyFolder::make(const fs::path& folder, const fs::path& study_file,
                              const std::string& program) {
    const std::string text = text_of(study_file);
    const std::string name = printable(study_file.string(), 400);
    fs::path file = study_project(text, name);
    if (file.is_relative()) file = study_file.parent_path() / file;
    Project project = load_project(file);
    if (project.unpacked)
        throw Error(ErrorCode::unsupported_format, printable(file.string(), 400),
                    "is a packed project: its files have no place of their own", "unpack it first");
    (void)parse_study(text, name, project);
    NewFolder made(folder);
    for (const char* const own : {request_name, project_name})
        for (const fs::path& read : {study_file, file})
            refuse_to_overwrite(read, folder / own);
    move_project(project, folder / project_name);
    OutputSet set;
    set.add(folder / project_name).write(project_to_json(project));
    set.add(folder / request_name)
        .write(pretty_json(Json{{"study_request", 1}, {"program", program}, {"study", text}}));
    set.commit();
    return StudyFolder(folder, program);
}

StudyFolder::StudyFolder(fs::path folder, const std::string& program)
    : path_(std::move(folder)), program_(program) {
    const fs::path file = path_ / request_name;
    const std::string name = printable(file.string(), 400);
    const Json request = parse_strict_json(text_of(file), name);
    expect_object(request, name);
    const std::string wrote =
        read_text(require(request, name, "program", "run the study again"), member(name, "program"));
    if (wrote != program)
        throw Error(ErrorCode::newer_version, name,
                    "another program works on this study (" + printable(wrote, 100) + "; this is "
                        + printable(program, 100) + ")",
                    "use the same one on all machines, or begin with this one: study run");
    const Json& text = require(request, name, "study", "run the study again");
    if (!text.is_string()) wrong_type(member(name, "study"), text, "the text of a study");
    project_ = load_project(path_ / project_name);
    study_ = parse_study(text.get<std::string>(), name, project_);
    judging_ = judging_key(project_);
}

std::string StudyFolder::candidate_file(const Project& candidate) const {
    Project moved = candidate;
    move_project(moved, candidate_folder("KEY") / project_name); // whichever: relative files are as far away
    return project_to_json(moved);
}

std::string StudyFolder::key_of(const Project& candidate, const std::string& file_text) const {
    Key key;
    key.add(program_).add(file_text).add(contents_of(candidate)).add(judging_);
    return keyed_hash(study_hash_key, key.text()).hex();
}

void StudyFolder::write_candidate(const std::string& key, const std::string& file_text) const {
    const fs::path folder = candidate_folder(key);
    if (!is_missing(folder / project_name)) return;
    make_folder(folder);
    write_text(folder / project_name, file_text);
}

Project StudyFolder::candidate(const std::string& key) const {
    const fs::path file = candidate_folder(key) / project_name;
    Project project = load_project(file);
    if (key_of(project, text_of(file)) != key)
        throw Error(ErrorCode::out_of_range, printable(file.string(), 400),
                    "it, or a file that it reads, was changed since the study began", "run the study again");
    return project;
}

std::optional<RungResult> StudyFolder::result(const std::string& key, Rung rung) const {
    const fs::path file = candidate_folder(key) / (std::string(rung_name(rung)) + ".json");
    if (is_missing(file)) return std::nullopt;
    try {
        return read_result(parse_strict_json(text_of(file), "result"), "result");
    } catch (const Error&) {
        return std::nullopt; // torn by the disk: it is found out again
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void StudyFolder::write_result(const std::string& key, Rung rung, const RungResult& result) const {
    write_text(candidate_folder(key) / (std::string(rung_name(rung)) + ".json"),
               pretty_json(result_json(result)));
}

void work_on(const StudyFolder& folder, const std::string& key, Rung rung, const Progress& progress) {
    if (folder.result(key, rung)) return;
    const Project project = folder.candidate(key);
    folder.write_result(key, rung, evaluate(project, folder.project(), rung, progress));
}

} // namespace facetmill
