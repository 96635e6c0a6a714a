// Project files, and settings as the command line changes them: the first line is a setting where it does not
// begin with a brace. A project that was read is saved and read again as the same.
#include "core/job/project.h"
#include "tests/fuzz/fuzz.h"

using namespace facetmill;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::text_of(data, size), setting;
    if (!text.empty() && text.front() != '{') {
        const std::size_t end = std::min(text.find('\n'), text.size());
        setting = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    Project project;
    if (!fuzz::reads([&] { project = parse_project(text, "a.facetmill"); })) return 0;
    if (!setting.empty()) fuzz::reads([&] { apply_setting(project, setting); });
    fuzz::reads([&] { check_project(project); });
    std::string saved;
    if (!fuzz::reads([&] { saved = project_to_json(project); }))
        fuzz::found("a project that was read cannot be saved");
    if (!fuzz::reads([&] {
            if (project_to_json(parse_project(saved, "again")) != saved)
                fuzz::found("a saved project reads differently");
        }))
        fuzz::found("a saved project cannot be read");
    return 0;
}
