// Texts that come in, and texts that go out.
#include "core/base/latin.h"
#include "core/base/parameter.h"
#include "core/base/strict_json.h"
#include "core/base/text.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using test::code_of;

namespace {

/// A control of the second set, an override, an isolate, a separator of lines, one of paragraphs, a next
/// line, a delete, a bell, nothing; and what is not seen: spaces of no width, marks, a soft hyphen, a tag.
const std::vector<std::string> hidden = {"\xC2\x9B",           "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x80\xA8",
                                         "\xE2\x80\xA9",       "\xC2\x85",     "\x7F",         "\x07",
                                         std::string(1, '\0'), "\n",           "\x1B",         "\xEF\xBB\xBF",
                                         "\xE2\x80\x8B",       "\xE2\x80\x8F", "\xE2\x81\xA0", "\xC2\xAD",
                                         "\xF3\xA0\x81\x81"};
/// Letters with marks, a no-break space, a zero-width joiner, Hebrew, a tool beyond the first plane.
const std::string shown = "d\xC3\xA9j\xC3\xA0\xC2\xA0\xE2\x80\x8D\xD7\xA9\xF0\x9F\x94\xA7";

} // namespace

class TestText : public QObject {
    Q_OBJECT
private slots:
    void blanks_around_a_text_go() {
        QCOMPARE(trimmed(""), std::string_view());
        QCOMPARE(trimmed(" \t\r\n\v\f "), std::string_view());
        QCOMPARE(trimmed("a"), std::string_view("a"));
        QCOMPARE(trimmed("  a \t b\r\n"), std::string_view("a \t b"));
        QCOMPARE(trimmed("\xC2\xA0z"), std::string_view("\xC2\xA0z")); // one that does not break a line stays
    }

    void what_would_be_obeyed_is_replaced() {
        for (const std::string& h : hidden) {
            QCOMPARE(printable("a" + h + "b"), std::string("a?b"));
            const Error e(ErrorCode::internal, "a" + h, "b" + h, "c" + h);
            QCOMPARE(std::string(e.what()), std::string("a?: b? (c?)"));
        }
        QCOMPARE(printable(shown), shown);
        for (const char* bad : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x80", "\xFF"})
            QVERIFY(printable(bad).find_first_not_of('?') == std::string::npos);
    }

    void no_such_text_comes_in() {
        for (const std::string& h : hidden) {
            QCOMPARE(code_of([&] { check_text("a" + h + "b", "tools[0].name"); }),
                     std::string("out_of_range"));
            const Json json = "a" + h;
            QCOMPARE(code_of([&] { strict::read_text(json, "name"); }), std::string("out_of_range"));
            ParameterInfo info;
            info.key = "name";
            for (const ParameterKind kind : {ParameterKind::text, ParameterKind::names}) {
                info.kind = kind;
                QCOMPARE(code_of([&] { info.parse("a" + h, LengthUnit::mm); }), std::string("out_of_range"));
            }
        }
        std::string message;
        QCOMPARE(code_of([&] { check_text("caf\xE9", "part.file"); }, &message), std::string("encoding"));
        QVERIFY(message.starts_with("part.file: the text is not UTF-8"));
        check_text(shown, "name");
    }

    void marks_of_letters_go() {
        QCOMPARE(without_marks("\xC3\x89"
                               "bauche, H\xC3\xB6he, Stra\xC3\x9F"
                               "e, \xC5\x93uvre, \xC5\x81\xC3\xB3"
                               "d\xC5\xBA"),
                 std::string("Ebauche, Hoehe, Strasse, oeuvre, Lodz"));
        QCOMPARE(without_marks("\xC5\xBF\xC4\x80\xC4\xB1\xC4\xB2\xC5\xBD"), std::string("sAiIJZ"));
        // A sign of multiplication, a square, Hebrew, half a letter.
        for (const std::string other :
             {"Finish 2", "3 \xC3\x97 4", "CM\xC2\xB2", "\xD7\xA9", "a\xC3", "\xC3z"})
            QCOMPARE(without_marks(other), other);
    }

    void json_escapes_it_and_keeps_it() {
        std::string all = shown + "\"\\/";
        for (const std::string& h : hidden)
            all += h;
        Json json;
        json[all] = all;
        const std::string text = pretty_json(json);
        for (const std::string& h : hidden)
            QVERIFY(h == "\n" || text.find(h) == std::string::npos);
        QVERIFY(Json::parse(text) == json);
    }

    void json_names_the_place_of_what_is_not_utf8() {
        Json json;
        json["operations"] = {{{"name", "good"}}, {{"name", "caf\xE9"}}};
        std::string message;
        QCOMPARE(code_of([&] { pretty_json(json); }, &message), std::string("encoding"));
        QVERIFY2(message.starts_with("operations[1].name: "), message.c_str());
    }
};

FACETMILL_TEST(TestText)
#include "test_text.moc"
