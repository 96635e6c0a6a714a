#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace facetmill::test {

/// Names of classes, separated by commas: those that a program runs by itself, where it is linked with others
/// as well (WITH in cmake/Facetmill.cmake). Programs that run all of theirs define none.
extern const char* const own_classes [[gnu::weak]];

namespace {
struct Entry {
    const char* name;
    std::function<std::unique_ptr<QObject>()> make;
};
std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
}

/// Names of classes, separated by commas; nothing where there is no text. A name that no class has ends the
/// program: the class would be left out in silence.
std::optional<std::vector<std::string>> classes_in(const char* text, const char* said_by) {
    if (!text) return std::nullopt;
    std::vector<std::string> names;
    std::istringstream all(text);
    for (std::string name; std::getline(all, name, ',');) {
        if (std::none_of(entries().begin(), entries().end(),
                         [&](const Entry& e) { return name == e.name; })) {
            std::fprintf(stderr, "%s: no test class is named '%s'\n", said_by, name.c_str());
            std::exit(1); // NOLINT(concurrency-mt-unsafe)
        }
        names.push_back(name);
    }
    return names;
}
} // namespace

bool register_test(const char* name, std::function<std::unique_ptr<QObject>()> make) {
    entries().push_back({name, std::move(make)});
    return true;
}

int run_tests(int argc, char** argv) {
    const char* only = nullptr;
    if (argc > 1 && argv[1][0] != '-') {
        for (const auto& e : entries())
            if (std::strcmp(e.name, argv[1]) == 0) only = e.name;
        if (only) {
            for (int i = 1; i + 1 < argc; ++i)
                argv[i] = argv[i + 1];
            --argc;
        }
    }
    const auto asked = [](const char* variable) {
        return classes_in(std::getenv(variable), variable); // NOLINT(concurrency-mt-unsafe)
    };
    auto these = asked("FACETMILL_CLASSES");
    const auto others = asked("FACETMILL_OTHER_CLASSES");
    if (!these && !others && &own_classes) these = classes_in(own_classes, "own_classes");
    const auto names = [](const auto& list, const char* name) {
        return std::find(list->begin(), list->end(), std::string_view(name)) != list->end();
    };
    // Several classes: only what fails is told, and which classes failed once more at the end. Whoever reads
    // the log of a program with forty classes sees the one failure, also where the middle of a long log is
    // cut.
    char silent[] = "-silent";
    std::vector<char*> arguments(argv, argv + argc);
    if (!only && argc == 1) arguments.push_back(silent);
    const auto count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    std::vector<std::string_view> failed;
    int run = 0;
    for (const auto& e : entries()) {
        if (only && std::strcmp(e.name, only) != 0) continue;
        if (!only && ((these && !names(these, e.name)) || (others && names(others, e.name)))) continue;
        const auto object = e.make();
        if (QTest::qExec(object.get(), count, arguments.data()) != 0) failed.emplace_back(e.name);
        ++run;
    }
    if (run == 0) {
        std::fprintf(stderr, "no test class was linked into this program\n");
        return 1;
    }
    if (run > 1) std::printf("%d classes, %zu failed\n", run, failed.size());
    for (const auto name : failed)
        std::printf("FAILED CLASS: %.*s\n", static_cast<int>(name.size()), name.data());
    return failed.empty() ? 0 : 1;
}

std::string data_path(const std::string& relative) {
    return std::string(FACETMILL_TEST_DATA) + "/" + relative;
}

} // namespace facetmill::test
