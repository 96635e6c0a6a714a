// A test class registers itself; one program runs all classes that were linked into it.
//
//     class TestUnits : public QObject { Q_OBJECT private slots: void round_trip(); };
//     FACETMILL_TEST(TestUnits)
#pragma once

#include <QObject>

#include <functional>
#include <memory>
#include <string>

namespace facetmill::test {

bool register_test(const char* name, std::function<std::unique_ptr<QObject>()> make);

/// Runs what `program [ClassName] [QtTest arguments]` asks for: one class only when its name comes first;
/// without one, the classes that FACETMILL_CLASSES names, separated by commas, or all but those that
/// FACETMILL_OTHER_CLASSES names, or the program's own (test_runner.cpp). Without any argument only failures
/// and warnings are told, and at the end the classes that failed. The exit status of the program.
int run_tests(int argc, char** argv);

/// How long a test waits for what happens by itself. It only ends a test that hangs: what takes a second
/// alone takes a minute on a machine that does much else.
inline constexpr int patience_ms = 240'000;

/// Path of a file or folder below tests/.
std::string data_path(const std::string& relative);

} // namespace facetmill::test

#define FACETMILL_TEST(Class)                                                                                \
    static const bool registered_##Class =                                                                   \
        facetmill::test::register_test(#Class, [] { return std::unique_ptr<QObject>(new Class); });
