// Pictures of every kind that PNG and TIFF know as reliefs, each against the heights that its numbers ask
// for; and those whose header says what cannot be.
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"
#include "tests/unit/mesh/picture_support.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr unsigned kind_columns = 21, kind_rows = 9;
constexpr double full_height = 4;
using Height = std::function<double(unsigned column, unsigned row)>; ///< 0 to 1

LoadedMesh relief_of(const std::string& bytes, const std::string& name, bool invert = false) {
    MeshReading reading;
    reading.relief = {.width = double(kind_columns - 1),
                      .length = double(kind_rows - 1),
                      .height = full_height,
                      .invert = invert};
    return read_mesh(bytes, name, reading, Progress());
}

/// Largest difference from the heights; infinite where points are missing.
double farthest(const Mesh& mesh, const Height& height) {
    if (mesh.vertices.size() != std::size_t(kind_columns) * kind_rows)
        return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const Vec3& v : mesh.vertices)
        largest = std::max(largest, std::abs(v.z()
                                             - full_height
                                                   * height(unsigned(std::lround(v.x())),
                                                            unsigned(kind_rows - 1 - std::lround(v.y())))));
    return largest;
}

double luminance(double red, double green, double blue) {
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/// Anything, but the same each time, and the largest and the smallest are among them.
unsigned number_at(unsigned c, unsigned r, unsigned k, unsigned largest) {
    if (c == 0 && r == 0) return 0;
    if (c == 1 && r == 0) return largest;
    return (c * 7919u + r * 104729u + k * 1299709u + c * r * 31u) % (largest + 1);
}

struct Kind {
    std::string name, bytes, words;
    Height height;
    double within = 1e-12; ///< of the height
};

std::vector<Kind> png_kinds() {
    std::vector<Kind> all;
    for (const bool interlaced : {false, true})
        for (const auto& [colour, bits] : {std::pair{0, 1},
                                           {0, 2},
                                           {0, 4},
                                           {0, 8},
                                           {0, 16},
                                           {2, 8},
                                           {2, 16},
                                           {3, 1},
                                           {3, 2},
                                           {3, 4},
                                           {3, 8},
                                           {4, 8},
                                           {4, 16},
                                           {6, 8},
                                           {6, 16}}) {
            const unsigned largest = (1u << bits) - 1;
            PngMaker png{.columns = kind_columns,
                         .rows = kind_rows,
                         .bits = bits,
                         .colour = colour,
                         .interlaced = interlaced};
            png.pixel = [=](unsigned c, unsigned r, int k) { return number_at(c, r, unsigned(k), largest); };
            const auto part = [=](unsigned c, unsigned r, unsigned k) {
                return number_at(c, r, k, largest) / double(largest);
            };
            Kind kind{.name = "PNG, colour " + std::to_string(colour) + ", " + std::to_string(bits) + " bits"
                              + (interlaced ? ", interlaced" : ""),
                      .height = {}};
            kind.words = bits > 8 ? "" : "picture_steps";
            if (colour == 2 || colour == 3 || colour == 6)
                kind.words = "picture_colours" + std::string(bits > 8 ? "" : ",picture_steps");
            if (colour >= 4) kind.words += std::string(kind.words.empty() ? "" : ",") + "picture_transparent";
            if (colour == 3) {
                std::string entries;
                for (unsigned i = 0; i <= largest; ++i)
                    entries += {char(i * 3 % 256), char(255 - i % 256), char(i * 7 % 256)};
                png.before_data = png_chunk("PLTE", entries);
                kind.height = [=](unsigned c, unsigned r) {
                    const unsigned i = number_at(c, r, 0, largest);
                    return luminance(i * 3 % 256, 255 - i % 256, i * 7 % 256) / 255;
                };
            } else if (colour == 0 || colour == 4) {
                kind.height = [=](unsigned c, unsigned r) {
                    return part(c, r, 0) * (colour == 4 ? part(c, r, 1) : 1);
                };
            } else {
                kind.height = [=](unsigned c, unsigned r) {
                    return luminance(part(c, r, 0), part(c, r, 1), part(c, r, 2))
                           * (colour == 6 ? part(c, r, 3) : 1);
                };
            }
            kind.bytes = png.bytes();
            all.push_back(kind);
        }
    return all;
}

/// One channel of grey, in which `low` is the ground and `high` the top.
Kind grey_tiff(const std::string& name, TiffMaker tiff, double low, double high) {
    tiff.columns = kind_columns;
    tiff.rows = kind_rows;
    const auto steps = unsigned(std::min(high - low, 60000.0));
    const auto part = [=](unsigned c, unsigned r) { return number_at(c, r, 0, steps) / double(steps); };
    const bool whole = tiff.format != 3;
    tiff.value = [=](unsigned c, unsigned r) {
        const double v = low + (high - low) * part(c, r);
        return whole ? std::round(v) : v;
    };
    const double rounding = (whole ? 0.51 : 1e-6) / (high - low);
    return {name + (tiff.tile ? ", tiles" : "") + (tiff.big_endian ? ", large end first" : ""), tiff.bytes(),
            tiff.bits <= 8 ? "picture_steps" : "",
            [=](unsigned c, unsigned r) { return tiff.photometric == 0 ? 1 - part(c, r) : part(c, r); },
            steps < high - low || !whole ? rounding : 1e-12};
}

std::vector<Kind> grey_tiffs() {
    std::vector<Kind> all;
    for (const unsigned tile : {0u, 16u})
        for (const unsigned bits : {1u, 2u, 4u, 12u})
            all.push_back(grey_tiff("TIFF, " + std::to_string(bits) + " bits", {.bits = bits, .tile = tile},
                                    0, (1u << bits) - 1));
    all.push_back(grey_tiff("TIFF, 4 bits, white is low", {.bits = 4, .photometric = 0}, 0, 15));
    for (const bool big : {false, true}) {
        all.push_back(
            grey_tiff("TIFF, 8 bits with a sign", {.bits = 8, .format = 2, .big_endian = big}, -100, 90));
        all.push_back(
            grey_tiff("TIFF, 16 bits with a sign", {.bits = 16, .format = 2, .big_endian = big}, -431, 8848));
        all.push_back(
            grey_tiff("TIFF, 32 bits with a sign", {.bits = 32, .format = 2, .big_endian = big}, -2e9, 2e9));
        all.push_back(grey_tiff("TIFF, 32 bits", {.bits = 32, .big_endian = big}, 0, 4e9));
        all.push_back(
            grey_tiff("TIFF, 64-bit floats", {.bits = 64, .format = 3, .big_endian = big}, -3.25, 1e5));
    }
    all.push_back(
        grey_tiff("TIFF, white is low, with a sign", {.bits = 16, .format = 2, .photometric = 0}, -40, 60));
    return all;
}

std::vector<Kind> coloured_tiffs() {
    std::vector<Kind> all;
    const auto eight = [](unsigned c, unsigned r, unsigned k) { return number_at(c, r, k, 255); };
    for (const unsigned bits : {8u, 16u})
        for (const unsigned tile :
             {0u, 32u}) { // libtiff refuses tiles of colours that are no multiple of 1024 bytes
            const unsigned scale = bits == 16 ? 257 : 1;
            TiffMaker tiff{.columns = kind_columns,
                           .rows = kind_rows,
                           .bits = bits,
                           .photometric = 2,
                           .samples = 3,
                           .tile = tile};
            tiff.channel = [=](unsigned c, unsigned r, unsigned k) { return scale * eight(c, r, k); };
            all.push_back({"TIFF, colours, " + std::to_string(bits) + " bits" + (tile ? ", tiles" : ""),
                           tiff.bytes(), "picture_colours,picture_steps", [=](unsigned c, unsigned r) {
                               return luminance(eight(c, r, 0), eight(c, r, 1), eight(c, r, 2)) / 255;
                           }});
        }
    {
        // Opacity that is not multiplied in: libtiff does that, with whole numbers.
        TiffMaker tiff{
            .columns = kind_columns, .rows = kind_rows, .photometric = 2, .samples = 4, .opacity = 2};
        tiff.channel = eight;
        all.push_back({"TIFF, colours and opacity", tiff.bytes(), "picture_colours,picture_steps",
                       [=](unsigned c, unsigned r) {
                           return luminance(eight(c, r, 0), eight(c, r, 1), eight(c, r, 2)) / 255
                                  * eight(c, r, 3) / 255;
                       },
                       1.01 / 255});
    }
    {
        TiffMaker tiff{.columns = kind_columns, .rows = kind_rows, .photometric = 3};
        for (unsigned k = 0; k < 3; ++k)
            for (unsigned i = 0; i < 256; ++i)
                tiff.palette.push_back(257 * ((i * (k + 3) + 11 * k) % 256));
        tiff.value = [=](unsigned c, unsigned r) { return eight(c, r, 0); };
        all.push_back(
            {"TIFF, a palette", tiff.bytes(), "picture_colours,picture_steps", [=](unsigned c, unsigned r) {
                 const unsigned i = eight(c, r, 0);
                 return luminance(i * 3 % 256, (i * 4 + 11) % 256, (i * 5 + 22) % 256) / 255;
             }});
    }
    for (unsigned orientation = 2; orientation <= 4; ++orientation) {
        TiffMaker tiff{.columns = kind_columns, .rows = kind_rows, .orientation = orientation};
        tiff.value = [=](unsigned c, unsigned r) { return eight(c, r, 0); };
        const bool left = orientation == 1 || orientation == 4, up = orientation <= 2;
        all.push_back({"TIFF, orientation " + std::to_string(orientation), tiff.bytes(), "picture_steps",
                       [=](unsigned c, unsigned r) {
                           return eight(left ? c : kind_columns - 1 - c, up ? r : kind_rows - 1 - r, 0)
                                  / 255.0;
                       }});
    }
    return all;
}

std::string joined(const std::set<std::string>& words) {
    std::string all;
    for (const std::string& word : words)
        all += (all.empty() ? "" : ",") + word;
    return all;
}

} // namespace

class TestPictureKinds : public QObject {
    Q_OBJECT
private slots:
    void every_kind_has_its_heights() {
        std::vector<Kind> all = png_kinds();
        for (const auto& more : {grey_tiffs(), coloured_tiffs()})
            all.insert(all.end(), more.begin(), more.end());
        for (const Kind& kind : all) {
            const LoadedMesh loaded = relief_of(kind.bytes, kind.name.starts_with("PNG") ? "a.png" : "a.tif");
            const double off = farthest(*loaded.mesh, kind.height);
            QVERIFY2(off <= full_height * kind.within,
                     qPrintable(QString("%1: %2").arg(kind.name.c_str()).arg(off)));
            const auto& words = loaded.report.warnings;
            const std::string found = joined({words.begin(), words.end()});
            QVERIFY2(found == kind.words, (kind.name + ": " + found).c_str());
        }
        QVERIFY(all.size() >= 55);
    }

    /// A place without height lies on the ground, below all the others, inverted or not.
    void gaps_lie_on_the_ground() {
        struct Gap {
            unsigned bits, format;
            double value;
            const char* text;
        };
        for (const Gap& gap :
             {Gap{16, 2, -32768, "-32768"}, Gap{32, 3, -9999, "-9999"}, Gap{32, 3, -9999, " -9999.0 "},
              Gap{32, 3, -3.4028234663852886e38, "-3.4028234663852886e+38"},
              Gap{32, 3, std::numeric_limits<double>::quiet_NaN(), "nan"}, Gap{64, 3, 1e300, "1e300"}})
            for (const bool invert : {false, true}) {
                TiffMaker tiff{.columns = kind_columns,
                               .rows = kind_rows,
                               .bits = gap.bits,
                               .format = gap.format,
                               .nodata = gap.text};
                const auto is_gap = [](unsigned c, unsigned r) { return c > 4 && c < 8 && r < 5; };
                const auto part = [](unsigned c, unsigned r) { return number_at(c, r, 0, 1000) / 1000.0; };
                tiff.value = [&](unsigned c, unsigned r) {
                    return is_gap(c, r) ? gap.value : 300 + 1000 * part(c, r);
                };
                const LoadedMesh loaded = relief_of(tiff.bytes(), "a.tif", invert);
                const double off = farthest(*loaded.mesh, [&](unsigned c, unsigned r) {
                    return is_gap(c, r) ? 0.0 : invert ? 1 - part(c, r) : part(c, r);
                });
                QVERIFY2(off < 1e-6, qPrintable(QString("%1: %2").arg(gap.text).arg(off)));
                QCOMPARE(QString::fromStdString(
                             joined({loaded.report.warnings.begin(), loaded.report.warnings.end()})),
                         QString("picture_transparent"));
            }
        // All of it a gap: level ground. One that is not said to be a gap is a height, and not-a-number is
        // none.
        TiffMaker tiff{
            .columns = kind_columns, .rows = kind_rows, .bits = 32, .format = 3, .nodata = "-9999"};
        tiff.value = [](unsigned, unsigned) { return -9999; };
        QCOMPARE(farthest(*relief_of(tiff.bytes(), "a.tif").mesh, [](unsigned, unsigned) { return 0.0; }),
                 0.0);
        tiff.value = [](unsigned c, unsigned) {
            return c == 3 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
        };
        QVERIFY_THROWS_EXCEPTION(Error, relief_of(tiff.bytes(), "a.tif"));
    }

    void headers_that_cannot_be_are_refused() {
        int tried = 0;
        const auto refused = [&](const std::string& bytes, const char* what,
                                 const std::string& name = "a.png") {
            ++tried;
            try {
                relief_of(bytes, name);
                QFAIL(what);
            } catch (const Error& e) {
                QVERIFY2(e.code() != ErrorCode::internal && !e.remedy().empty(), what);
                QVERIFY2(std::string(e.what()).find(name) != std::string::npos, e.what());
            }
        };
        const std::string sound = PngMaker{.columns = kind_columns, .rows = kind_rows}.bytes();
        for (const auto& [colour, bits] : {std::pair{2, 1},
                                           {2, 2},
                                           {2, 4},
                                           {3, 16},
                                           {4, 1},
                                           {4, 2},
                                           {4, 4},
                                           {6, 1},
                                           {6, 2},
                                           {6, 4},
                                           {0, 3},
                                           {0, 0}}) {
            PngMaker png{.columns = kind_columns, .rows = kind_rows, .bits = bits, .colour = colour};
            refused(png.with_data(zlib_stored(std::string(500, '\0'))),
                    qPrintable(QString("%1 %2").arg(colour).arg(bits)));
        }
        for (const std::size_t field : {10, 11, 12}) { // compression, filter, interlacing
            std::string data = PngMaker{.columns = kind_columns, .rows = kind_rows}.header().substr(8, 13);
            data[field] = 9;
            refused(sound.substr(0, 8) + png_chunk("IHDR", data) + sound.substr(33),
                    qPrintable(QString::number(field)));
        }
        for (std::size_t i = 0; i < 8; ++i) {
            std::string bytes = sound;
            bytes[i] = char(bytes[i] ^ 0x20);
            refused(bytes, qPrintable(QString("signature %1").arg(i)));
        }
        for (const auto& [bits, format] :
             {std::pair{24u, 1u}, {64u, 1u}, {64u, 2u}, {4u, 2u}, {16u, 3u}, {32u, 5u}, {32u, 6u}})
            refused(
                TiffMaker{.columns = kind_columns, .rows = kind_rows, .bits = bits, .format = format}.bytes(),
                qPrintable(QString("TIFF, %1 bits, format %2").arg(bits).arg(format)), "a.tif");
        for (const unsigned photometric : {4u, 7u, 99u})
            refused(
                TiffMaker{
                    .columns = kind_columns, .rows = kind_rows, .photometric = photometric, .samples = 2}
                    .bytes(),
                qPrintable(QString("TIFF, photometric %1").arg(photometric)), "a.tif");
        // One sent as text is told from what is no picture at all.
        std::string text = sound;
        text.erase(4, 1); // CR LF became LF
        try {
            relief_of(text, "a.png");
            QFAIL("it was read");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("as text") != std::string::npos, e.what());
        }
        QVERIFY(tried >= 33);
    }
};

FACETMILL_TEST(TestPictureKinds)
#include "test_picture_kinds.moc"
