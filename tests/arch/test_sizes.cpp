// Functions stay short enough to be read at one go, classes short enough to be kept in mind. What is longer
// has a name, a reason and a limit of its own here; nothing else is.
#include "tests/arch/cpp_scanner.h"
#include "tests/arch/source_tree.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill::test;

namespace {

constexpr int max_function_lines = 100;
constexpr int max_class_lines = 400; // the declaration and the members defined outside it

/// Something longer than the rule allows.
struct Exception {
    const char* file;
    const char* name; // as the scanner gives it
    int limit;        // lines, as it is now: it may shrink but not grow
    const char* why;
};

const std::vector<Exception> long_functions = {};

const std::vector<Exception> large_classes = {};

struct Size {
    std::string file, name;
    int lines = 0;
};

/// What is wrong with the sizes of a tree: things that are too long, and exceptions that nothing needs any
/// more.
QStringList too_long(const std::vector<Size>& sizes, int limit, const std::vector<Exception>& exceptions,
                     const char* kind) {
    QStringList wrong;
    std::vector<bool> needed(exceptions.size(), false);
    for (const auto& s : sizes) {
        if (s.lines <= limit) continue;
        int allowed = limit;
        for (std::size_t i = 0; i < exceptions.size(); ++i)
            if (s.file == exceptions[i].file && s.name == exceptions[i].name) {
                needed[i] = true;
                allowed = exceptions[i].limit;
            }
        if (s.lines > allowed)
            wrong << QString("%1: %2 %3 has %4 lines, %5 are allowed: split it where it changes the subject")
                         .arg(QString::fromStdString(s.file), kind, QString::fromStdString(s.name))
                         .arg(s.lines)
                         .arg(allowed);
    }
    for (std::size_t i = 0; i < exceptions.size(); ++i)
        if (!needed[i])
            wrong << QString("%1: %2 %3 needs its exception no more: strike it off the list")
                         .arg(exceptions[i].file, kind, exceptions[i].name);
    return wrong;
}

std::vector<Size> functions_of(const std::vector<std::pair<std::string, Scan>>& scans) {
    std::vector<Size> sizes;
    for (const auto& [file, scan] : scans)
        for (const auto& e : scan.extents)
            if (e.kind == Extent::Kind::Function) sizes.push_back({file, e.name, e.lines()});
    return sizes;
}

std::vector<Size> classes_of(const std::vector<std::pair<std::string, Scan>>& scans) {
    std::vector<Size> sizes;
    for (const auto& c : class_sizes(scans))
        sizes.push_back({c.file, c.name, c.lines});
    return sizes;
}

std::string lines_of_code(int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
        text += "    work();\n";
    return text;
}

/// "name first-last" of what the scanner finds.
QStringList found(const std::string& text) {
    QStringList all;
    for (const auto& e : scan_cpp(text).extents)
        all << QString("%1 %2 %3-%4")
                   .arg(e.kind == Extent::Kind::Class ? "class" : "function", QString::fromStdString(e.name))
                   .arg(e.first)
                   .arg(e.last);
    return all;
}

} // namespace

class TestSizes : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app"})) {
            scans_.emplace_back(file, scan_cpp(text));
            QVERIFY2(scans_.back().second.closed, file.c_str()); // else nothing it says can be trusted
        }
    }

    void functions_stay_readable() {
        const auto sizes = functions_of(scans_);
        QVERIFY(sizes.size() > 2000); // the scan found the tree
        const auto wrong = too_long(sizes, max_function_lines, long_functions, "function");
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void classes_stay_readable() {
        const auto sizes = classes_of(scans_);
        QVERIFY(sizes.size() > 300);
        const auto wrong = too_long(sizes, max_class_lines, large_classes, "class");
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void exceptions_say_why() {
        for (const auto* list : {&long_functions, &large_classes})
            for (const auto& e : *list)
                QVERIFY2(QString(e.why).size() > 20, e.name);
    }

    void a_long_function_is_found() {
        const auto check = [](const std::string& text, const std::vector<Exception>& exceptions = {}) {
            return too_long(functions_of({{"a.cpp", scan_cpp(text)}}), max_function_lines, exceptions,
                            "function")
                .size();
        };
        const std::string body = lines_of_code(max_function_lines - 2);
        QCOMPARE(check("void f() {\n" + body + "}\n"), 0);
        QCOMPARE(check("void f() {\n" + body + "\n}\n"), 1);
        QCOMPARE(check("void f() {\n" + body + "\n}\n", {{"a.cpp", "f", 101, "a reason"}}), 0);
        QCOMPARE(check("void f() {\n" + body + "\n\n}\n", {{"a.cpp", "f", 101, "a reason"}}), 1);
        QCOMPARE(check("void f() {\n" + body + "\n}\n", {{"b.cpp", "f", 101, "a reason"}}),
                 2); // and none needs it
        QCOMPARE(check("void f() {\n" + body + "}\n", {{"a.cpp", "f", 101, "a reason"}}),
                 1); // needed no more
        QCOMPARE(check("struct A {\n    A() : x_{1}, y_(2) {\n" + body + "\n    }\n};\n"), 1);
        QCOMPARE(check("namespace n {\ntemplate <class T> auto A<T>::operator()(int i) const -> T {\n" + body
                       + "\n}\n}\n"),
                 1);
    }

    void a_large_class_is_found() {
        const std::string member = "void A::f() {\n" + lines_of_code(148) + "}\n"; // 150 lines
        const std::string header =
            "namespace n {\nclass A {\n    void f();\n" + lines_of_code(98) + "};\n}\n"; // 101
        const auto check = [&](const std::string& other) {
            return too_long(classes_of({{"a.cpp", scan_cpp("namespace n {\n" + member + "}\n")},
                                        {"a.h", scan_cpp(header)},
                                        {"b.cpp", scan_cpp(other)}}),
                            max_class_lines, {}, "class")
                .size();
        };
        QCOMPARE(check(""), 0);
        QCOMPARE(check("namespace n {\n" + member + "}\n"), 1);
        QCOMPARE(check("namespace m {\n" + member + "}\n"), 0); // of another namespace
        QCOMPARE(check("namespace n { namespace {\nclass A {};\n" + member + "}}\n"),
                 0); // of a class of its own
    }

    void the_scanner_reads() {
        QCOMPARE(found("int f(int a = g(1), int b = {}) {\n  if (a) { b(); }\n}\n"),
                 QStringList{"function f 1-3"});
        QCOMPARE(found("namespace a::b {\nstruct C final : D<int> {\n  C() = default;\n  int x{1}, y = {2};\n"
                       "  bool operator==(const C&) const { return true; }\n};\n}\n"),
                 (QStringList{"function a::b::C::operator== 5-5", "class a::b::C 2-6"}));
        QCOMPARE(found("A::B::~B() noexcept {\n}\n"), QStringList{"function A::B::~B 1-2"});
        QCOMPARE(
            found(
                "A::A(int x)\n    : Base(x), y_{x, 2}, z_([&] { return 1; }()) {\n  go();\n}\nvoid g() {}\n"),
            (QStringList{"function A::A 1-4", "function g 5-5"}));
        QCOMPARE(found("class Q : public O {\n  Q_OBJECT\npublic slots:\n  void s() {\n  }\n};\n"),
                 (QStringList{"function Q::s 4-5", "class Q 1-6"}));
        QCOMPARE(found("enum class E { a, b };\nconst int t[] = {1, 2};\nauto l = [](int) { return 0; };\n"
                       "std::array<void (*)(int), 1> s = {f};\nvoid f();\n"),
                 QStringList{});
        QCOMPARE(found("template <class T>\n    requires(sizeof(T) > 1)\n[[nodiscard]] T f(T t) {\n}\n"),
                 QStringList{"function f 3-4"});
        QCOMPARE(found("struct A f() {\n  struct B { void g() {} };\n}\n"), QStringList{"function f 1-3"});
        QCOMPARE(found("extern \"C\" {\nint f() { return '{'; }\n}\n"), QStringList{"function f 2-2"});
        QCOMPARE(found("#define OPEN {\\\n  {\nint f() {\n  // }\n  /* } */ s = \"}\\\"}\"; r = "
                       "R\"x(})\")x\"; n = 1'000;\n}\n"),
                 QStringList{"function f 3-6"});
        QCOMPARE(found("struct A {\n  struct {\n    int x;\n  } b, c;\n};\n"), QStringList{"class A 1-5"});
        QVERIFY(!scan_cpp("void f() {\n").closed);
        QVERIFY(!scan_cpp("void f() {}}\n").closed);
    }

private:
    std::vector<std::pair<std::string, Scan>> scans_;
};

FACETMILL_TEST(TestSizes)
#include "test_sizes.moc"
