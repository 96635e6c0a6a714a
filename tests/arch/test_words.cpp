// The code speaks the words of the glossary, and a comment begins with the thing it is about.
#include "tests/arch/cpp_scanner.h"
#include "tests/arch/source_tree.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cctype>
#include <regex>
#include <set>
#include <sstream>

using namespace facetmill::test;

namespace {

/// The words of an identifier in lower case: "lead_angle_", "LeadAngle" -> lead, angle.
std::vector<std::string> words_in(const std::string& identifier) {
    std::vector<std::string> words;
    bool begins = true;
    for (std::size_t i = 0; i < identifier.size(); ++i) {
        const auto c = static_cast<unsigned char>(identifier[i]);
        if (c == '_') {
            begins = true;
            continue;
        }
        if (std::isupper(c) && i > 0 && !std::isupper(static_cast<unsigned char>(identifier[i - 1])))
            begins = true;
        if (begins) words.emplace_back();
        words.back() += static_cast<char>(std::tolower(c));
        begins = false;
    }
    return words;
}

/// What to say instead of a word of this identifier; empty when nothing is wrong with it.
std::string better_word(const std::string& identifier) {
    const auto words = words_in(identifier);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& w = words[i];
        if (w == "lambda") return "lead";
        if (w == "omega") return "yaw";
        if (w == "desk" || w == "desks") return "controller";
        if (w == "way" || w == "ways") {
            // "One-way" is what machinists say of passes, and to give way what two of them do.
            static const std::set<std::string> idioms = {"one", "either", "give", "gives", "made"};
            if (i == 0 || !idioms.count(words[i - 1])) return "path, polyline or route";
        }
    }
    if (words.size() > 1 && words[0] == "most" && words[1] != "promising") return "max";
    if (words.size() > 1 && words[0] == "least") return "min";
    return "";
}

QStringList wrong_words(const std::string& text, const std::string& file) {
    static const std::regex identifier(R"([A-Za-z_]\w*)");
    QStringList wrong;
    std::istringstream lines(bare_code(text));
    std::string line;
    for (int n = 1; std::getline(lines, line); ++n)
        for (std::sregex_iterator i(line.begin(), line.end(), identifier), end; i != end; ++i)
            if (const auto better = better_word(i->str()); !better.empty())
                wrong << QString("%1:%2: %3: the glossary says %4")
                             .arg(QString::fromStdString(file))
                             .arg(n)
                             .arg(QString::fromStdString(i->str()), QString::fromStdString(better));
    return wrong;
}

/// Comments that begin with "Of" instead of the thing they are about: "/// Of roughing: size of the cells".
QStringList begun_with_of(const std::string& text, const std::string& file) {
    static const std::regex of(R"(//[/!]?<?\s*Of\s)"), comment_line(R"(^\s*//)");
    QStringList wrong;
    std::istringstream lines(text);
    std::string line;
    bool goes_on = false; // the line before is a comment: this one is in the middle of it
    for (int n = 1; std::getline(lines, line); ++n) {
        const bool whole = std::regex_search(line, comment_line);
        if (!(whole && goes_on) && std::regex_search(line, of))
            wrong << QString("%1:%2: the comment begins with 'Of'").arg(QString::fromStdString(file)).arg(n);
        goes_on = whole;
    }
    return wrong;
}

} // namespace

class TestWords : public QObject {
    Q_OBJECT
private slots:
    void identifiers_keep_to_the_glossary() {
        QStringList wrong;
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app"}))
            wrong << wrong_words(text, file);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void comments_begin_with_their_thing() {
        QStringList wrong;
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app"}))
            if (file.ends_with(".h")) wrong << begun_with_of(text, file);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void a_wrong_beginning_is_found() {
        for (const char* text :
             {"/// Of roughing: cells.\n", "// Of a file.\n", "int a; ///< Of x\n", "a;\n    // Of\tb\n"})
            QCOMPARE(begun_with_of(text, "a.h").size(), 1);
        for (const char* text :
             {"/// Cells.\n/// Of these few.\n", "// Offset\n", "int Of ;\n", "// What is of it\n"})
            QCOMPARE(begun_with_of(text, "a.h").size(), 0);
    }

    void a_wrong_word_is_found() {
        for (const char* text :
             {"double lambda = 0;", "double omega_deg;", "class CSpaceDesk;", "int most_lead;",
              "int least_gap_;", "Polyline way;", "int rough_ways();", "int wayLength;"})
            QCOMPARE(wrong_words(text, "a.cpp").size(), 1);
        for (const char* text : {"// lambda", "s = \"lambda_deg\";", "int desktop, away, always, halfway;",
                                 "bool one_way;", "int at_least;", "auto m = most;", "give_way();"})
            QCOMPARE(wrong_words(text, "a.cpp").size(), 0);
    }
};

FACETMILL_TEST(TestWords)
#include "test_words.moc"
