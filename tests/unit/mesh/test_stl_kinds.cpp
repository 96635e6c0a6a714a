// Odd and broken STL files of further kinds, beside the corpus in tests/data/badstl: made here from a sound
// box, each with what must come of it. A sound one gives the whole box, a broken one the error's word and its
// cause in words.
#include "core/mesh/mesh_format.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

struct StlKind {
    std::string what, bytes;
    std::string outcome; ///< as `outcome` of mesh_io_support.h has it
    std::string cause;   ///< what the error's line holds
    std::size_t boxes = 1;
};
using StlKinds = std::vector<StlKind>;

const Mesh& stl_box() {
    static const Mesh mesh = box_mesh(Vec3(-10, 0, 0), Vec3(10, 30, 40));
    return mesh;
}
const std::string& text_box() {
    static const std::string text = ascii_stl(stl_box());
    return text;
}
const std::string& binary_box() {
    static const std::string bytes = binary_stl(stl_box());
    return bytes;
}
std::string second_box() {
    return ascii_stl(box_mesh(Vec3(50, 0, 0), Vec3(70, 30, 40)), "second");
}
std::string upper(std::string text) {
    for (char& c : text)
        c = char(std::toupper(static_cast<unsigned char>(c)));
    return text;
}
std::string wide(const std::string& text, int bytes, bool big_endian) {
    std::string all;
    for (const char c : text) {
        const std::string zeros(std::size_t(bytes) - 1, '\0');
        all += big_endian ? zeros + c : c + zeros;
    }
    return all;
}
/// With the count as stated.
std::string counted(std::string bytes, std::uint32_t count) {
    std::memcpy(&bytes[80], &count, 4);
    return bytes;
}
/// With float `word` of facet `f` as stated: 0 to 2 the normal, then three a corner.
std::string with_word(std::string bytes, std::size_t f, std::size_t word, float value) {
    std::memcpy(&bytes[84 + 50 * f + 4 * word], &value, 4);
    return bytes;
}
std::string with_attributes(std::string bytes, std::uint16_t attribute) {
    for (std::size_t at = 84 + 48; at < bytes.size(); at += 50)
        std::memcpy(&bytes[at], &attribute, 2);
    return bytes;
}
/// Every record as `size` bytes of it, or with zeros behind it.
std::string with_records(const std::string& bytes, std::size_t size) {
    std::string all = bytes.substr(0, 84);
    for (std::size_t at = 84; at < bytes.size(); at += 50) {
        std::string record = bytes.substr(at, 50);
        record.resize(size, '\0');
        all += record;
    }
    return all;
}
std::string without_normals(std::string bytes, std::size_t size) {
    for (std::size_t at = 84; at < bytes.size(); at += size)
        std::memset(&bytes[at], 0, 12);
    return bytes;
}
/// A binary STL file in doubles.
std::string in_doubles() {
    std::string bytes = binary_box().substr(0, 84);
    for (std::size_t f = 0; f < stl_box().facets.size(); ++f) {
        for (const Vec3& v : {stl_box().facet_normal(f), stl_box().corner(f, 0), stl_box().corner(f, 1),
                              stl_box().corner(f, 2)})
            append_raw(bytes, v.data(), 24);
        bytes += std::string(2, '\0');
    }
    return bytes;
}
/// Read as text of one byte a character and written as UTF-8.
std::string latin_to_utf8(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto u = static_cast<unsigned char>(c);
        if (u < 0x80)
            text += c;
        else
            (text += char(0xC0 | u >> 6)) += char(0x80 | (u & 0x3F));
    }
    return text;
}
/// Read as UTF-8 that it is not: each byte beyond ASCII has become U+FFFD.
std::string with_replacement_characters(const std::string& bytes) {
    std::string text;
    for (const char c : bytes)
        text += static_cast<unsigned char>(c) < 0x80 ? std::string(1, c) : "\xEF\xBF\xBD";
    return text;
}
/// In the form of zlib.
std::string compressed(const std::string& bytes) {
    return qCompress(QByteArray(bytes.data(), qsizetype(bytes.size()))).mid(4).toStdString();
}
std::string base64(const std::string& bytes) {
    return QByteArray(bytes.data(), qsizetype(bytes.size())).toBase64().toStdString();
}

StlKinds lines_and_words() {
    const std::string& good = text_box();
    StlKinds kinds;
    const auto sound = [&](const char* what, const std::string& bytes, const char* outcome = "ok") {
        kinds.push_back({what, bytes, outcome, "", 1});
    };
    sound("UTF-8 mark and CR LF", "\xEF\xBB\xBF" + replaced_all(good, "\n", "\r\n"));
    sound("blank lines before the first word", "\n\r\n\t\n" + good);
    sound("upper case throughout", upper(good));
    sound("upper case, UTF-8 mark", "\xEF\xBB\xBF" + upper(good));
    sound("LF CR", replaced_all(good, "\n", "\n\r"));
    sound("CR CR LF: CR LF made CR LF once more", replaced_all(good, "\n", "\r\r\n"));
    sound("form feeds", replaced_all(good, "endfacet\n", "endfacet\f\n"));
    sound("vertical tabs between numbers", replaced_all(good, " 30 ", "\v30\v"));
    sound("blanks at the ends of lines", replaced_all(good, "\n", "  \t \n"));
    sound("empty lines everywhere", replaced_all(good, "\n", "\n\n\n"));
    sound("no line end behind the last word", good.substr(0, good.size() - 1));
    sound("no name behind endsolid", replaced(good, "endsolid part", "endsolid"));
    sound("another name behind endsolid", replaced(good, "endsolid part", "endsolid other thing"));
    sound("end solid in two words and a name", replaced(good, "endsolid", "end solid"));
    sound("END SOLID in two words", replaced(upper(good), "ENDSOLID", "END SOLID"));
    sound("a tab behind solid", replaced(good, "solid part", "solid\tpart"));
    sound("the name is endsolid", replaced(good, "solid part", "solid endsolid"));
    sound("the name is solid", replaced(good, "solid part", "solid solid solid"));
    sound("the name is facet normal 0 0 1", replaced(good, "solid part", "solid facet normal 0 0 1"));
    sound("the name has quotes and umlauts", replaced(good, "solid part", "solid \"Geh\xC3\xA4use\" 'A'"));
    sound("the name is binary", replaced(good, "solid part", "solid binary STL COLOR=\x01\x02"));
    sound("comments between facets", replaced_all(good, "endfacet\n", "endfacet\n# next\n"),
          "ok,unknown_lines");
    sound("comments of C between facets", replaced_all(good, "endfacet\n", "endfacet\n// a note\n"),
          "ok,unknown_lines");
    sound("colours between facets", replaced_all(good, "endfacet\n", "endfacet\ncolor 1 0.5 0\n"),
          "ok,unknown_lines");
    sound("a comment behind the end", good + "; made by hand\n", "ok,trailing_data");
    sound("end of file of CP/M", good + std::string(128, '\x1A'), "ok,trailing_data");
    sound("a page behind the end", good + "<!-- cached -->\n", "ok,trailing_data");
    sound("facets and loops on one line each", replaced_all(replaced_all(good, "\n ", " "), "\nend", " end"));
    sound("the end is missing, the last facet is whole", good.substr(0, good.find("endsolid")),
          "ok,missing_endsolid");
    sound("cut inside the word endsolid", good.substr(0, good.find("endsolid") + 3), "ok,missing_endsolid");
    sound("cut behind the word endsolid", good.substr(0, good.find("endsolid") + 8));
    return kinds;
}

StlKinds numbers_and_solids() {
    const std::string& good = text_box();
    StlKinds kinds;
    const auto number = [&](const char* what, const char* text, const char* outcome = "ok") {
        kinds.push_back({what, replaced_all(good, " 30 ", " " + std::string(text) + " "), outcome, "", 1});
    };
    number("1 digit of mantissa", "3E1");
    number("exponent with zeros", "3e+0001");
    number("a point and no digit behind it", "30.");
    number("a point and no digit before it", ".3e2");
    number("zeros before", "0000030.0");
    number("an explicit sign", "+30.000");
    number("forty digits", "30.00000000000000000000000000000000000000");
    number("exponent D of Fortran", "3.D+01");
    number("exponent d of Fortran", ".3d2");
    number("decimal comma and exponent", "3,0E+01", "ok,comma_decimal");
    kinds.push_back({"minus zero", replaced_all(good, " 0 ", " -0.0 "), "ok", "", 1});
    kinds.push_back({"too small for a double", replaced_all(good, " 0 ", " 1e-400 "), "ok", "", 1});
    kinds.push_back(
        {"infinite normals", replaced_all(good, "normal 0 0 ", "normal inf -inf "), "ok,bad_normals", "", 1});
    kinds.push_back({"normals of Windows that are no numbers",
                     replaced_all(good, "normal 0 0 ", "normal -1.#IND 1.#QNAN "), "ok,bad_normals", "", 1});
    kinds.push_back({"normals too large for a double", replaced_all(good, "normal 0 0 ", "normal 1e999 0 "),
                     "ok,bad_normals", "", 1});
    const std::string two = "ok,multiple_shells,multiple_solids";
    kinds.push_back(
        {"two solids of one name", good + replaced_all(second_box(), "second", "part"), two, "", 2});
    kinds.push_back(
        {"two solids, a UTF-8 mark each", "\xEF\xBB\xBF" + good + "\xEF\xBB\xBF" + second_box(), two, "", 2});
    kinds.push_back({"two solids, end solid in two words",
                     replaced(good, "endsolid", "end solid") + second_box(), two, "", 2});
    kinds.push_back({"an empty solid behind the other", good + "solid empty\nendsolid empty\n",
                     "ok,empty_solid,multiple_solids", "", 1});
    kinds.push_back({"an empty solid that does not end", good + "solid empty\n",
                     "ok,empty_solid,missing_endsolid,multiple_solids", "", 1});
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += ascii_stl(box_mesh(Vec3(30 * i, 0, 0), Vec3(30 * i + 20, 30, 40)), std::to_string(i));
    kinds.push_back({"a hundred solids", many, two, "", 100});
    return kinds;
}

StlKinds broken_texts() {
    const std::string& good = text_box();
    StlKinds kinds;
    const auto number = [&](const char* what, const std::string& text, const char* outcome,
                            const char* cause) {
        kinds.push_back(
            {what, replaced(good, "vertex -10 30 0", "vertex -10 " + text + " 0"), outcome, cause, 0});
    };
    for (const char* word : {"inf", "-Infinity", "NaN", "nan(0x8)", "1.#INF00", "-1.#SNAN"})
        number(word, word, "non_finite", "not a finite number");
    for (const char* word : {"1e400", "1e39", "2e7", "-123456789012"})
        number(word, word, "coordinate_range", "is beyond");
    for (const char* word : {"3e",
                             "3e+",
                             "--30",
                             "+-30",
                             "3-0",
                             "30f",
                             "30mm",
                             "1_000",
                             "1'000",
                             "3 0",
                             "0x1e",
                             "30;",
                             "3.0.0",
                             "\xE2\x88\x92"
                             "30",
                             "30\xC2\xA0",
                             "$30",
                             "(30)",
                             "3/4",
                             "1e1.5",
                             "*",
                             "\xD9\xA3\xD9\xA0"})
        number(word, word, "syntax", "line 5: ");
    number("a comma for the thousands", "1,000.5", "syntax", "line 5: ");
    kinds.push_back({"commas between the numbers", replaced_all(good, "vertex -10 30 0", "vertex -10, 30, 0"),
                     "syntax", "line 5: ", 0});
    kinds.push_back({"commas without blanks", replaced_all(good, "vertex -10 30 0", "vertex -10,30,0"),
                     "syntax", "line 5: ", 0});
    const auto word = [&](const char* what, const char* from, const char* to, const char* outcome,
                          const char* cause) {
        kinds.push_back({what, replaced(good, from, to), outcome, cause, 0});
    };
    word("facetnormal in one word", "facet normal 0", "facetnormal 0", "syntax", "expected");
    word("outerloop in one word", "outer loop", "outerloop", "syntax", "outer loop expected");
    word("inner loop", "outer loop", "inner loop", "syntax", "outer loop expected");
    word("end loop in two words", "endloop", "end loop", "syntax", "endloop expected");
    word("a letter of vertex is missing", "vertex", "vertx", "syntax", "vertex expected");
    word("endfacet is missing", "endfacet\n", "", "syntax", "endfacet expected");
    word("a second loop", "endloop\n", "endloop\nouter loop\n", "syntax", "endfacet expected");
    word("five corners", "endloop", "vertex 1 2 3\nvertex 4 5 6\nendloop", "not_triangles",
         "more than three corners");
    word("two corners", "vertex -10 0 0\n", "\n", "syntax", "vertex expected");
    word("no solid", "solid part\n", "", "not_stl", "does not start with 'solid'");
    word("a comment before solid", "solid part\n", "# made by hand\nsolid part\n", "not_stl",
         "does not start with 'solid'");
    word("solid without a blank", "solid part\n", "solid_part\n", "not_stl", "does not start with 'solid'");
    word("facets behind the end", "endfacet\n", "endfacet\nendsolid part\n", "syntax", "outside of a solid");
    kinds.push_back({"two solids and no line end between them",
                     good.substr(0, good.size() - 1) + " " + second_box(), "syntax", "outside of a solid",
                     0});
    kinds.push_back({"nothing but solid", "solid\n", "no_facets", "no facet", 0});
    kinds.push_back({"a solid of comments", "solid a\n# nothing\nendsolid a\n", "no_facets", "no facet", 0});
    const std::size_t last = good.rfind("facet normal");
    kinds.push_back({"cut between facets", good.substr(0, last), "truncated", "", 0});
    kinds.push_back({"cut behind the last vertex", good.substr(0, good.rfind(" endloop")), "truncated",
                     "the file was cut", 0});
    kinds.push_back({"cut behind the last endloop", good.substr(0, good.rfind("endfacet")), "truncated",
                     "the file was cut", 0});
    kinds.push_back({"cut inside the last endfacet", good.substr(0, good.rfind("endfacet") + 4), "truncated",
                     "the file was cut", 0});
    kinds.push_back({"UTF-16, little endian, no mark", wide(good, 2, false), "encoding", "UTF-16", 0});
    kinds.push_back({"UTF-16, big endian, no mark", wide(good, 2, true), "encoding", "UTF-16", 0});
    kinds.push_back({"UTF-32, little endian", std::string("\xFF\xFE\0\0", 4) + wide(good, 4, false),
                     "encoding", "UTF-32", 0});
    kinds.push_back({"UTF-32, big endian", std::string("\0\0\xFE\xFF", 4) + wide(good, 4, true), "encoding",
                     "UTF-32", 0});
    kinds.push_back({"UTF-32, little endian, no mark", wide(good, 4, false), "encoding", "UTF-32", 0});
    kinds.push_back({"UTF-32, big endian, no mark", wide(good, 4, true), "encoding", "UTF-32", 0});
    kinds.push_back({"a binary STL behind the text", good + binary_box(), "syntax", "binary bytes", 0});
    return kinds;
}

StlKinds sound_binaries() {
    const std::string& good = binary_box();
    StlKinds kinds;
    const auto sound = [&](const char* what, const std::string& bytes, const char* outcome = "ok") {
        kinds.push_back({what, bytes, outcome, "", 1});
    };
    const auto header = [&](const char* what, const std::string& text, const char* outcome = "ok") {
        sound(what, binary_stl(stl_box(), text), outcome);
    };
    header("header of bytes 0xFF", std::string(80, '\xFF'));
    header("header of line ends", std::string(80, '\n'));
    header("header SOLID", "SOLID upper", "ok,binary_solid_header");
    header("header with a UTF-8 mark and solid", "\xEF\xBB\xBFsolid", "ok,binary_solid_header");
    header("header with blanks and solid", "   solid x", "ok,binary_solid_header");
    header("header solid of 80 bytes", "solid " + std::string(74, 'x'), "ok,binary_solid_header");
    header("header that begins as a PLY file", "ply\nformat ascii 1.0\n");
    header("header that begins as an archive", "PK\x03\x04 not one");
    header("header that begins as a picture", "\x89PNG\r\n\x1A\n");
    header("header in UTF-16", wide("Part", 2, false));
    header("Magics: colour of the part", "COLOR=\xFF\x80\x40\xFF,MATERIAL=\x10\x20\x30\x40");
    sound("Magics: colours of facets",
          with_attributes(binary_stl(stl_box(), "COLOR=\xFF\x80\x40\xFF"), 0x7C1F), "ok,attribute_data");
    sound("VisCAM: colours of facets", with_attributes(good, 0x83E0), "ok,attribute_data");
    sound("attributes of 0xFFFF", with_attributes(good, 0xFFFF), "ok,attribute_data");
    sound("two bytes of payload a facet", with_records(with_attributes(good, 2), 52), "ok,attribute_payload");
    sound("count 0 and whole facets", counted(good, 0), "ok,count_wrong");
    sound("count 1 too small", counted(good, 11), "ok,count_wrong");
    sound("no normals, count 0", counted(without_normals(good, 50), 0), "ok,count_wrong");
    sound("no normals, a text behind", without_normals(good, 50) + "exported", "ok,trailing_data");
    sound("49 bytes behind", good + std::string(49, '\0'), "ok,trailing_data");
    sound("a text behind", good + "exported by hand", "ok,trailing_data");
    sound("end of file of CP/M behind", good + "\x1A", "ok,trailing_data");
    sound("a normal that is not a number", with_word(good, 3, 1, std::nanf("")), "ok,bad_normals");
    sound("normals of length 1000", with_word(good, 0, 2, -1000.0F));
    return kinds;
}

StlKinds broken_binaries() {
    const std::string& good = binary_box();
    StlKinds kinds;
    const auto broken = [&](const char* what, const std::string& bytes, const char* outcome,
                            const char* cause) {
        kinds.push_back({what, bytes, outcome, cause, 0});
    };
    broken("count 1 too large", counted(good, 13), "truncated", "announces 13");
    broken("count 24", counted(good, 24), "truncated", "announces 24");
    broken("the count's bytes alone reversed", counted(good, 12U << 24), "coordinate_range", "");
    std::string swapped = good;
    for (std::size_t f = 0; f < 12; ++f)
        for (std::size_t w = 0; w < 12; ++w)
            std::reverse(&swapped[84 + 50 * f + 4 * w], &swapped[84 + 50 * f + 4 * w] + 4);
    broken("all but the count's bytes reversed", swapped, "coordinate_range", "");
    broken("header of 79 bytes", good.substr(1), "count_mismatch", "do not look like facets");
    broken("header of 81 bytes", "x" + good, "truncated", "announces");
    broken("records of 64 bytes without normals", without_normals(with_records(good, 64), 64),
           "count_mismatch", "do not look like facets");
    broken("no header", good.substr(80), "truncated", "announces");
    broken("records of 48 bytes", with_records(good, 48), "count_mismatch", "48 bytes");
    broken("records of 52 bytes", with_records(good, 52), "count_mismatch", "52 bytes");
    broken("records of 64 bytes", with_records(good, 64), "count_mismatch", "64 bytes");
    broken("doubles", in_doubles(), "count_mismatch", "do not look like facets");
    broken("half of a facet is missing in the middle", good.substr(0, 200) + good.substr(225), "truncated",
           "announces 12");
    broken("a block of the file twice", good.substr(0, 400) + good.substr(337), "coordinate_range", "facet");
    broken("infinite coordinate of the last facet", with_word(good, 11, 11, -infinity), "non_finite",
           "facet 12");
    broken("a coordinate beyond the range", with_word(good, 4, 5, 1.1e7F), "coordinate_range", "facet 5");
    broken("a coordinate of 3e38", with_word(good, 0, 3, 3e38F), "coordinate_range", "facet 1");
    broken("all coordinates 0", good.substr(0, 84) + std::string(600, '\0'), "no_facets", "");
    broken("smaller than any part", binary_stl(box_mesh(Vec3(0, 0, 0), Vec3(1e-8, 1e-8, 1e-8))),
           "coordinate_range", "");
    broken("another binary STL behind", good + binary_stl(box_mesh(Vec3(50, 0, 0), Vec3(70, 30, 40))),
           "count_mismatch", "another STL");
    broken("an ASCII STL behind", good + second_box(), "count_mismatch", "another STL");
    const Mesh torus = torus_mesh(30, 10);
    const std::string round = binary_stl(torus);
    broken("written as UTF-8 from Latin-1", latin_to_utf8(round), "syntax", "UTF-8");
    broken("bytes beyond ASCII replaced", with_replacement_characters(round), "syntax", "UTF-8");
    broken("the same with solid in its header", latin_to_utf8(binary_stl(torus, "solid")), "syntax", "UTF-8");
    broken("LF made CR LF", replaced_all(round, "\n", "\r\n"), "syntax", "transfer as text");
    broken("CR LF made LF", replaced_all(binary_stl(torus, std::string("made\r\nby hand")), "\r\n", "\n"),
           "truncated", "announces");
    broken("zeros taken out", replaced_all(good, std::string(1, '\0'), ""), "not_stl", "not an STL file");
    broken("base64", base64(good), "not_stl", "does not start with 'solid'");
    broken("base64 with its kind", "data:model/stl;base64," + base64(good), "not_stl",
           "does not start with 'solid'");
    broken("zlib", compressed(round), "not_stl", "zlib");
    return kinds;
}

StlKinds other_files() {
    StlKinds kinds;
    const auto other = [&](const char* what, std::string bytes, const char* cause) {
        bytes.resize(std::max<std::size_t>(bytes.size(), 700), '\7');
        kinds.push_back({what, bytes, "not_stl", cause, 0});
    };
    other("zip", "PK\x03\x04\x14", "ZIP");
    other("an empty zip", std::string("PK\x05\x06\0\0", 6), "ZIP");
    other("gzip", "\x1F\x8B\x08", "gzip");
    other("zstd", "\x28\xB5\x2F\xFD", "Zstandard");
    other("bzip2", "BZh91AY&SY", "bzip2");
    other("xz",
          "\xFD"
          "7zXZ",
          "xz");
    other("7z", "7z\xBC\xAF\x27\x1C", "7z");
    other("rar", "Rar!\x1A\x07", "RAR");
    std::string tar = "solid.stl" + std::string(248, '\0') + "ustar";
    other("tar", tar, "tar");
    other("a resource fork of macOS", std::string("\0\x05\x16\x07\0\x02\0\0", 8), "AppleDouble");
    other("Blender", "BLENDER-v293", "Blender");
    other("glTF", std::string("glTF\2\0\0\0", 8), "glTF");
    other("Draco", "DRACO\x02\x02", "Draco");
    other("Parasolid", "**ABCDEFGHIJKLMNOPQRSTUVWXYZ**", "Parasolid");
    kinds.push_back({"AMF", "<?xml version=\"1.0\"?>\n<amf unit=\"mm\"></amf>\n", "not_stl", "XML", 0});
    kinds.push_back(
        {"a web page in small letters", "<!doctype html>\n<html></html>\n", "not_stl", "web page", 0});
    kinds.push_back({"a pointer of Git LFS",
                     "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 684\n", "not_stl",
                     "Git LFS", 0});
    kinds.push_back({"STEP", "ISO-10303-21;\nHEADER;\n", "not_stl", "STEP", 0});
    kinds.push_back({"DXF", "  0\nSECTION\n  2\nENTITIES\n  0\nEOF\n", "not_stl", "DXF", 0});
    kinds.push_back({"JSON", "{\"error\": \"not found\"}\n", "not_stl", "does not start with 'solid'", 0});
    return kinds;
}

StlKinds all_kinds() {
    StlKinds all;
    for (const auto& group :
         {lines_and_words, numbers_and_solids, broken_texts, sound_binaries, broken_binaries, other_files})
        for (StlKind& kind : group())
            all.push_back(std::move(kind));
    return all;
}

} // namespace

class TestStlKinds : public QObject {
    Q_OBJECT
private slots:

    void every_kind_data() {
        QTest::addColumn<std::size_t>("index");
        std::size_t i = 0;
        for (const StlKind& kind : all_kinds())
            QTest::newRow(printable(kind.what, 200).c_str()) << i++;
    }

    void every_kind() {
        QFETCH(std::size_t, index);
        const StlKind kind = all_kinds()[index];
        QCOMPARE(QString::fromStdString(outcome(kind.bytes, "a.stl")), QString::fromStdString(kind.outcome));
        if (!kind.outcome.starts_with("ok")) {
            const std::string line = error_line(kind.bytes, "a.stl");
            QVERIFY2(line.find(kind.cause) != std::string::npos, line.c_str());
            QVERIFY2(line.starts_with("a.stl") && printable(line, line.size()) == line, line.c_str());
            return;
        }
        const LoadedMesh loaded = read(kind.bytes, "a.stl");
        QCOMPARE(loaded.report.facets, 12 * kind.boxes);
        QVERIFY(loaded.report.watertight);
        QVERIFY(std::abs(loaded.report.file_volume - 24000.0 * double(kind.boxes)) < 1e-6);
    }

    /// Cut anywhere, none of them is taken for whole with a facet less.
    void cut_anywhere() {
        for (const std::string& whole :
             {text_box(), upper(text_box()), binary_box(), replaced_all(text_box(), "\n", "\r\n")})
            for (std::size_t size = 0; size < whole.size(); ++size) {
                const std::string cut = whole.substr(0, size);
                const std::string came = outcome(cut, "a.stl");
                if (!came.starts_with("ok")) continue;
                QCOMPARE(read(cut, "a.stl").report.facets, std::size_t(12));
                QVERIFY2(size + 20 > whole.size(), came.c_str());
            }
    }
};

FACETMILL_TEST(TestStlKinds)
#include "test_stl_kinds.moc"
