// Colours stand in one file, viz/palette.cpp; what draws takes them from there.
#include "tests/arch/cpp_scanner.h"
#include "tests/arch/source_tree.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <regex>
#include <sstream>

using namespace facetmill::test;

namespace {

/// The only file that may have colours.
constexpr char palette[] = "viz/palette.cpp";

/// Colours as code has them.
const std::vector<std::regex>& code_patterns() {
    static const std::vector<std::regex> all = {
        std::regex(R"(\b0[xX]([fF]{2})?[0-9a-fA-F]{6}[uU]?\b)"), // 0xRRGGBB, opaque 0xAARRGGBB
        std::regex(R"(\b(QColor|QRgba64|Rgb|rgb|qRgba?)\s*(\w+\s*)?(=\s*)?[({]\s*([0-9.]|Qt::|"))"),
        std::regex(R"(\b(from|set)(Rgb|Rgba|Rgba64|Hsv|Hsl|Cmyk)F?\s*\(\s*[0-9.])"),
        std::regex(R"(\bSet\w*(Color|Background2?)\s*\(\s*[0-9.])"), // VTK's
        std::regex(
            R"(\bQt::(dark)?([wW]hite|[bB]lack|[rR]ed|[gG]reen|[bB]lue|[cC]yan|[mM]agenta|[yY]ellow|[gG]ray)\b)"),
        std::regex(R"(\bQt::lightGray\b|\bQColorConstants\b|\bvtkNamedColors\b)"),
    };
    return all;
}

/// Colours as texts have them: style sheets, names. `text` is a literal with its quotes.
const std::vector<std::regex>& text_patterns() {
    static const std::vector<std::regex> all = {
        std::regex(R"(#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})(?![0-9a-zA-Z]))"),
        std::regex(R"(\b(color|background)\s*[:=]\s*\\?["']?[a-zA-Z])"),
    };
    return all;
}

/// A QColor made of a name: the name is gone from bare code.
const std::regex& named_color() {
    static const std::regex pattern(R"(\bQColor\s*(\w+\s*)?[({]\s*(\w+\()?\s*")");
    return pattern;
}

QStringList colors_in(const std::string& text, const std::string& file) {
    static const std::regex literal(R"("([^"\\]|\\.)*")"), skipped(R"(\s*(//|#\s*include).*)");
    QStringList wrong;
    std::istringstream lines(text), bare_lines(bare_code(text));
    std::string line, bare;
    for (int n = 1; std::getline(lines, line) && std::getline(bare_lines, bare); ++n) {
        const auto matches = [](const std::string& s, const std::vector<std::regex>& patterns) {
            return std::any_of(patterns.begin(), patterns.end(),
                               [&](const std::regex& r) { return std::regex_search(s, r); });
        };
        bool found = matches(bare, code_patterns());
        if (line.find('"') != std::string::npos && !std::regex_match(line, skipped)) {
            found = found || std::regex_search(line, named_color());
            for (std::sregex_iterator i(line.begin(), line.end(), literal), end; i != end; ++i)
                found = found || matches(i->str(), text_patterns());
        }
        if (found)
            wrong << QString("%1:%2: a colour: give it a name in viz/palette: %3")
                         .arg(QString::fromStdString(file))
                         .arg(n)
                         .arg(QString::fromStdString(line).trimmed());
    }
    return wrong;
}

} // namespace

class TestColors : public QObject {
    Q_OBJECT
private slots:
    void colors_stand_in_the_palette() {
        QStringList wrong;
        for (const auto& [file, text] : sources({"viz", "ui", "app"}))
            if (file != palette) wrong << colors_in(text, file);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void the_palette_has_them() { QVERIFY(colors_in(sources({"viz"}).at(palette), palette).size() > 100); }

    void a_color_is_found() {
        for (const char* text : {"return rgb(0x2FA876);",
                                 "const unsigned c = 0xe4572e;",
                                 "QRgb c = 0xFF1B2430u;",
                                 "QColor(12, 34, 56)",
                                 "QColor ink(0, 0, 0, 28);",
                                 "QColor{1, 2, 3}",
                                 "p.setPen(QColor(\"red\"));",
                                 "QColor(QStringLiteral(\"#123456\"))",
                                 "label.setStyleSheet(\"color: red\");",
                                 "s = \"<b style=\\\"color:#a00\\\">\";",
                                 "s = \"<font color='red'>\";",
                                 "Rgb c{0.5, 0.25, 1};",
                                 "return Rgb{.5, .25, 1};",
                                 "const Rgb c = {0.1, 0.2, 0.3};",
                                 "Rgb(0.1, 0.2, 0.3)",
                                 "p.setPen(Qt::white);",
                                 "QPen(Qt::darkGray, 2)",
                                 "QColor(Qt::black)",
                                 "c.setRgb(1, 2, 3);",
                                 "QColor::fromHsv(120, 255, 255)",
                                 "qRgb(1, 2, 3)",
                                 "actor->GetProperty()->SetColor(0.8, 0.1, 0);",
                                 "renderer->SetBackground(1, 1, 1);",
                                 "property->SetDiffuseColor(.5, .5, .5);"})
            QVERIFY2(colors_in(text, "a.cpp").size() == 1, text);
    }

    void other_things_are_none() {
        for (const char* text :
             {"x = (x | x << 8) & 0x0300F00Fu;", "QChar(0x2212)", "// #123456 is a color: red",
              "QColor ink = palette.color(QPalette::Text);", "Rgb c;", "Rgb color{};",
              "QColor(mix(a, b), mix(c, d), 0)", "SetColor(c.r, c.g, c.b);", "SetBackgroundAlpha(1.0);",
              "s = \"#include\"; t = \"#7\";", "\"<td style=\\\"color:%1\\\">\"",
              "pixmap.fill(Qt::transparent);", "QColor::fromRgbF(float(c.r), g, b)",
              "p.setBrush(Qt::NoBrush);", "Index(0x7FFFFFFF)"})
            QVERIFY2(colors_in(text, "a.cpp").isEmpty(), text);
    }
};

FACETMILL_TEST(TestColors)
#include "test_colors.moc"
