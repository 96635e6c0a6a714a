#include "tests/support/test_runner.h"

#include <QTest>

#include <cstdio>
#include <cstring>
#include <vector>

namespace facetmill::test {

namespace {
struct Entry {
    const char* name;
    std::function<std::unique_ptr<QObject>()> make;
};
std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
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
    int failed = 0, run = 0;
    for (const auto& e : entries()) {
        if (only && std::strcmp(e.name, only) != 0) continue;
        const auto object = e.make();
        failed += QTest::qExec(object.get(), argc, argv);
        ++run;
    }
    if (run == 0) {
        std::fprintf(stderr, "no test class was linked into this program\n");
        return 1;
    }
    return failed == 0 ? 0 : 1;
}

std::string data_path(const std::string& relative) {
    return std::string(FACETMILL_TEST_DATA) + "/" + relative;
}

} // namespace facetmill::test
