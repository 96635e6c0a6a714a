// Reliefs from PNG and TIFF pictures: heights against the formula, odd and broken pictures.
#include "core/mesh/outward.h"
#include "core/mesh/relief.h"
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/mesh_io_support.h"
#include "tests/unit/mesh/picture_support.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

MeshReading reading_of(Relief relief, LengthUnit unit = LengthUnit::mm) {
    MeshReading reading = unit;
    reading.relief = relief;
    return reading;
}

LoadedMesh relief_of(const std::string& bytes, const Relief& relief, const char* name = "a.png",
                     LengthUnit unit = LengthUnit::mm) {
    return read_mesh(bytes, name, reading_of(relief, unit), Progress());
}

/// Largest distance of the sheet's points from heights that the columns and rows of a picture should have; a
/// number of points that does not fit is infinite.
template <class Height>
double farthest(const Mesh& mesh, unsigned columns, unsigned rows, double width, double length,
                const Height& height) {
    if (mesh.vertices.size() != std::size_t(columns) * rows) return infinity;
    if (mesh.facets.size() != 2 * std::size_t(columns - 1) * (rows - 1)) return infinity;
    double largest = 0;
    for (const Vec3& v : mesh.vertices) {
        const double c = v.x() / width * (columns - 1), r = (1 - v.y() / length) * (rows - 1);
        const double off = std::max(std::abs(c - std::round(c)), std::abs(r - std::round(r)));
        if (off > 1e-9) return infinity;
        largest =
            std::max(largest, std::abs(v.z() - height(unsigned(std::round(c)), unsigned(std::round(r)))));
    }
    return largest;
}

std::string words(const LoadedMesh& loaded) {
    std::string all;
    for (const std::string& w : loaded.report.warnings)
        all += (all.empty() ? "" : ",") + w;
    return all;
}

const Relief usual{.width = 20, .length = std::nullopt, .height = 4};

} // namespace

class TestRelief : public QObject {
    Q_OBJECT
private slots:

    /// Every kind of pixel, of every number of bits, in order and interlaced.
    void heights_are_those_of_the_pixels() {
        std::mt19937 random(7);
        for (const bool interlaced : {false, true})
            for (const auto& [colour, bits] : {std::pair{0, 1},
                                               {0, 2},
                                               {0, 4},
                                               {0, 8},
                                               {0, 16},
                                               {2, 8},
                                               {2, 16},
                                               {4, 8},
                                               {4, 16},
                                               {6, 8},
                                               {6, 16}}) {
                const unsigned columns = 19, rows = 11;
                std::vector<unsigned> values(columns * rows * 4);
                for (unsigned& v : values)
                    v = unsigned(random()) & ((1u << bits) - 1);
                PngMaker png{.columns = columns,
                             .rows = rows,
                             .bits = bits,
                             .colour = colour,
                             .interlaced = interlaced};
                const auto value = [&](unsigned c, unsigned r, int k) {
                    return values[(r * columns + c) * 4 + unsigned(k)];
                };
                png.pixel = value;
                const double full = (1 << bits) - 1;
                for (const bool invert : {false, true}) {
                    Relief relief = usual;
                    relief.invert = invert;
                    const LoadedMesh loaded = relief_of(png.bytes(), relief);
                    const auto height = [&](unsigned c, unsigned r) {
                        double v = value(c, r, 0) / full;
                        if (colour == 2 || colour == 6)
                            v = 0.2126 * v + 0.7152 * value(c, r, 1) / full + 0.0722 * value(c, r, 2) / full;
                        if (invert) v = 1 - v;
                        if (colour >= 4) v *= value(c, r, png.channels() - 1) / full;
                        return 4 * v;
                    };
                    QVERIFY2(farthest(*loaded.mesh, columns, rows, 20, 20.0 * 10 / 18, height) < 1e-12,
                             qPrintable(QString("colour %1, %2 bits").arg(colour).arg(bits)));
                    QCOMPARE(loaded.report.shells, std::size_t(1));
                    QCOMPARE(loaded.report.inconsistent_edges, std::size_t(0));
                    QCOMPARE(loaded.report.non_manifold_edges, std::size_t(0));
                }
            }
    }

    /// The sheet faces up however deep it is, and planners take that side as its outside.
    void the_outside_is_up() {
        for (const double height : {0.5, 4.0, 80.0})
            for (const bool bowl : {false, true}) {
                PngMaker png{.columns = 41, .rows = 41};
                png.pixel = [](unsigned c, unsigned r, int) {
                    return unsigned(
                        std::max(0.0, 255 - 0.6 * (std::pow(c - 20.0, 2) + std::pow(r - 20.0, 2))));
                };
                const LoadedMesh loaded =
                    relief_of(png.bytes(), {.width = 40, .height = height, .invert = bowl});
                for (std::size_t f = 0; f < loaded.mesh->facets.size(); ++f)
                    QVERIFY(loaded.mesh->facet_normal(f).z() > 0);
                QCOMPARE(outward_sides(*loaded.mesh, {}).turned_facets, std::size_t(0));
            }
    }

    void sizes_are_as_stated() {
        const std::string png = PngMaker{.columns = 5, .rows = 3}.bytes();
        const auto box = [&](const Relief& relief, LengthUnit unit) {
            return relief_of(png, relief, "a.png", unit).mesh->box();
        };
        const double top = 240.0 / 255;
        for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
            QVERIFY((box({.width = 60, .height = 2}, unit).hi - Vec3(60, 30, 2 * top)).norm() < 1e-12);
            QVERIFY((box({.width = 60, .length = 7, .height = 2}, unit).hi - Vec3(60, 7, 2 * top)).norm()
                    < 1e-12);
            QVERIFY((box({}, unit).hi - Vec3(100, 50, 5 * top)).norm() < 1e-12);
            QVERIFY(box({}, unit).lo.norm() < 1e-12);
        }
        // Numbers of the report are in the unit that the job assumes.
        const MeshReport inch =
            relief_of(png, {.width = 50.8, .height = 2}, "a.png", LengthUnit::inch).report;
        QVERIFY(std::abs(inch.file_box.hi.x() - 2) < 1e-12);
        QVERIFY(inch.is_relief && !inch.unit_known && inch.assumed_unit == LengthUnit::inch);
        QCOMPARE(QString::fromStdString(words(relief_of(png, {.width = 60, .height = 2}))),
                 QString("picture_steps"));
        for (const Relief& relief : {Relief{}, Relief{.width = 60}, Relief{.height = 2}})
            QCOMPARE(QString::fromStdString(words(relief_of(png, relief))),
                     QString("picture_size_assumed,picture_steps"));
        // Never "may be in another unit", and no word about the border of a sheet.
        QCOMPARE(
            QString::fromStdString(words(relief_of(png, {.width = 0.5, .height = 0.1, .smoothing = 1e-3}))),
            QString());
    }

    void smoothing_keeps_its_bound() {
        PngMaker png{.columns = 60, .rows = 50};
        std::mt19937 random(3);
        std::vector<unsigned> noise(60 * 50);
        for (unsigned& v : noise)
            v = unsigned(random() % 30);
        png.pixel = [&](unsigned c, unsigned r, int) {
            return 2 * c + noise[r * 60 + c] + (c > 30 ? 80 : 0);
        };
        const std::string bytes = png.bytes();
        const LoadedMesh given = relief_of(bytes, usual);
        const auto roughness = [](const Mesh& mesh) {
            double sum = 0;
            for (std::size_t f = 0; f < mesh.facets.size(); ++f)
                sum += 1 - mesh.facet_normal(f).z();
            return sum;
        };
        double before = roughness(*given.mesh);
        for (const double bound : {0.01, 0.1, 0.4}) {
            Relief relief = usual;
            relief.smoothing = bound;
            const LoadedMesh smooth = relief_of(bytes, relief);
            QVERIFY(smooth.mesh->facets.size() == given.mesh->facets.size());
            double moved = 0;
            std::size_t all = 0;
            for (const Vec3& v : smooth.mesh->vertices)
                for (const Vec3& w : given.mesh->vertices)
                    if (std::abs(v.x() - w.x()) < 1e-9 && std::abs(v.y() - w.y()) < 1e-9) {
                        moved = std::max(moved, std::abs(v.z() - w.z()));
                        ++all;
                    }
            QCOMPARE(all, given.mesh->vertices.size());
            QVERIFY2(moved <= bound + 1e-12 && moved > 0.5 * bound, qPrintable(QString::number(moved)));
            const double after = roughness(*smooth.mesh);
            QVERIFY(after < before);
            before = after;
        }
        // The steps of few greys go: a slope of eight pixels a step becomes one slope.
        PngMaker steps{.columns = 161, .rows = 5};
        steps.pixel = [](unsigned c, unsigned, int) { return 100 + c / 8; };
        const LoadedMesh slope =
            relief_of(steps.bytes(), {.width = 160, .height = 25.5, .smoothing = 0.0501});
        double steepest = 0;
        for (std::size_t f = 0; f < slope.mesh->facets.size(); ++f) {
            const Vec3 n = slope.mesh->facet_normal(f);
            steepest = std::max(steepest, std::abs(n.x() / n.z()));
        }
        QVERIFY2(steepest < 1.7 * 0.1 / 8, qPrintable(QString::number(steepest))); // it was 0.1
    }

    /// A slope stays one however the picture is thinned, and every point is a mean.
    void large_pictures_are_thinned() {
        const MeshReading reading = reading_of({.width = 2599, .height = 1000});
        const detail::MeshSource source{{}, "a.png", 1e7, reading};
        for (const bool wide : {false, true}) {
            const std::size_t columns = wide ? 99999 : 2600, rows = wide ? 54 : 2101;
            detail::ReliefBuilder builder(source, columns, rows);
            std::vector<double> row(columns);
            for (std::size_t r = 0; r < rows; ++r) {
                for (std::size_t c = 0; c < columns; ++c)
                    row[c] = 0.4 * double(c) / double(columns - 1) + 0.5 * double(r) / double(rows - 1);
                builder.add_row(row);
            }
            const detail::TriangleSoup soup = builder.finish("PNG", {}, {});
            QVERIFY(soup.warnings.contains("picture_reduced"));
            QVERIFY(soup.points.size() <= 4'000'000 && soup.points.size() > 3'900'000);
            Box3 box;
            double off = 0;
            for (const Vec3& p : soup.points)
                box.add(p);
            const double length = 2599 * double(rows - 1) / double(columns - 1);
            for (const Vec3& p : soup.points)
                off = std::max(off, std::abs(p.z() - 400 * p.x() / 2599 - 500 * (1 - p.y() / length)));
            QVERIFY(std::abs(box.hi.x() - 2599) < 1e-9 && std::abs(box.hi.y() - length) < 1e-9);
            // At most about half a row's or column's height.
            QVERIFY2(off < 0.6 * (400.0 / double(columns) + 500.0 / double(rows)),
                     qPrintable(QString::number(off)));
        }
        const std::string bytes = PngMaker{.columns = 700, .rows = 500, .interlaced = true}.bytes();
        for (const double fraction : {0.02, 0.1, 0.2, 0.35, 0.5, 0.9}) {
            Job job;
            Relief relief = usual;
            relief.smoothing = 0.1;
            QVERIFY(cancelled_at(
                job, fraction, [&](const Progress& p) { read_mesh(bytes, "a.png", reading_of(relief), p); }));
        }
    }

    void tiff_heights() {
        for (const bool big : {false, true})
            for (const unsigned tile : {0u, 16u})
                for (const unsigned bits : {8u, 16u})
                    for (const unsigned photometric : {0u, 1u}) {
                        TiffMaker tiff{.columns = 37,
                                       .rows = 21,
                                       .bits = bits,
                                       .photometric = photometric,
                                       .tile = tile,
                                       .big_endian = big};
                        tiff.value = [](unsigned c, unsigned r) { return 6 * c + r; };
                        const double full = (1u << bits) - 1;
                        const LoadedMesh loaded = relief_of(tiff.bytes(), usual, "a.tif");
                        const auto height = [&](unsigned c, unsigned r) {
                            const double v = (6 * c + r) / full;
                            return 4 * (photometric == 0 ? 1 - v : v);
                        };
                        QVERIFY(farthest(*loaded.mesh, 37, 21, 20, 20.0 * 20 / 36, height) < 1e-12);
                        QCOMPARE(QString::fromStdString(words(loaded)),
                                 bits == 8 ? QString("picture_steps") : QString());
                    }
        // Floats: from the lowest to the highest.
        for (const bool invert : {false, true}) {
            TiffMaker tiff{.columns = 9, .rows = 5, .bits = 32, .format = 3};
            tiff.value = [](unsigned c, unsigned r) { return -300 + 50.0 * c + 100.0 * r; };
            Relief relief = usual;
            relief.invert = invert;
            const LoadedMesh loaded = relief_of(tiff.bytes(), relief, "a.tiff");
            const auto height = [&](unsigned c, unsigned r) {
                const double v = (c + 2.0 * r) / 16;
                return 4 * (invert ? 1 - v : v);
            };
            QVERIFY(farthest(*loaded.mesh, 9, 5, 20, 10, height) < 1e-12);
        }
    }

    void odd_pictures_that_are_sound_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* tag, const std::string& bytes, const char* expected,
                            const char* name = "a.png") {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name << expected;
        };
        const PngMaker png;
        row("smallest", PngMaker{.columns = 2, .rows = 2}.bytes(), "ok,picture_steps");
        row("black all over", PngMaker{.pixel = [](unsigned, unsigned, int) { return 0u; }}.bytes(),
            "ok,picture_steps");
        row("white all over, 16 bits",
            PngMaker{.bits = 16, .pixel = [](unsigned, unsigned, int) { return 65535u; }}.bytes(), "ok");
        row("one bit", PngMaker{.bits = 1, .pixel = [](unsigned c, unsigned, int) { return c % 2; }}.bytes(),
            "ok,picture_steps");
        row("long and narrow", PngMaker{.columns = 3000, .rows = 2}.bytes(), "ok,picture_steps");
        row("tall and narrow", PngMaker{.columns = 2, .rows = 3000}.bytes(), "ok,picture_steps");
        row("interlaced, small", PngMaker{.columns = 2, .rows = 2, .interlaced = true}.bytes(),
            "ok,picture_steps");
        PngMaker palette{.colour = 3, .pixel = [](unsigned c, unsigned, int) { return c % 2; }};
        palette.before_data = png_chunk("PLTE", std::string("\0\0\0\xFF\x80\x10", 6));
        row("palette", palette.bytes(), "ok,picture_colours,picture_steps");
        palette.before_data += png_chunk("tRNS", std::string("\xFF\x40", 2));
        row("palette with transparency", palette.bytes(),
            "ok,picture_colours,picture_steps,picture_transparent");
        PngMaker opaque{.colour = 4,
                        .pixel = [](unsigned c, unsigned, int k) { return k == 1 ? 255u : 9 * c; }};
        row("opaque alpha", opaque.bytes(), "ok,picture_steps");
        PngMaker hidden{.colour = 4,
                        .pixel = [](unsigned c, unsigned, int k) { return k == 1 ? 0u : 9 * c; }};
        row("transparent all over", hidden.bytes(), "ok,picture_steps,picture_transparent");
        PngMaker keyed = png;
        keyed.before_data = png_chunk("tRNS", std::string("\0\x0A", 2));
        row("one grey is transparent", keyed.bytes(), "ok,picture_steps,picture_transparent");
        PngMaker gamma = png;
        gamma.before_data = png_chunk("gAMA", std::string("\0\0\xB1\x8F", 4));
        row("gamma is told", gamma.bytes(), "ok,picture_steps");
        PngMaker texts = png;
        for (int k = 0; k < 300; ++k)
            texts.before_data += png_chunk("tEXt", std::string("Comment\0", 8) + std::string(200, 'x'));
        row("many texts", texts.bytes(), "ok,picture_steps");
        PngMaker unknown = png;
        unknown.before_data = png_chunk("abCd", "what it says");
        row("a chunk that nobody knows", unknown.bytes(), "ok,picture_steps");
        PngMaker profile = png;
        profile.before_data = png_chunk("iCCP", std::string("x\0\0", 3) + "no profile");
        row("a broken colour profile", profile.bytes(), "ok,picture_steps");
        PngMaker behind = png;
        behind.behind_end = "more bytes";
        row("bytes behind the end", behind.bytes(), "ok,picture_steps,trailing_data");
        std::string two = png_chunk("IDAT", zlib_stored(png.raw()).substr(5));
        row("data in two chunks",
            "\x89PNG\r\n\x1A\n" + png.header() + png_chunk("IDAT", zlib_stored(png.raw()).substr(0, 5)) + two
                + png_chunk("IEND", ""),
            "ok,picture_steps");
        row("by its content", png.bytes(), "ok,picture_steps", "picture");
        row("its name in capitals", png.bytes(), "ok,picture_steps", "A.PNG");
        row("TIFF by its content", TiffMaker().bytes(), "ok,picture_steps", "picture");
        row("TIFF, floats all alike",
            TiffMaker{.bits = 32, .format = 3, .value = [](unsigned, unsigned) { return -7.0; }}.bytes(),
            "ok", "a.tif");
        row("TIFF, tiles larger than it is", TiffMaker{.tile = 64}.bytes(), "ok,picture_steps", "a.TIF");
        row("TIFF, white is low", TiffMaker{.photometric = 0}.bytes(), "ok,picture_steps", "a.tif");
    }
    void odd_pictures_that_are_sound() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QString, expected);
        const std::string text = bytes.toStdString();
        const LoadedMesh loaded = read_mesh(text, name.toStdString(), reading_of(usual), Progress());
        const std::string found = words(loaded);
        QCOMPARE(QString::fromStdString("ok" + (found.empty() ? "" : "," + found)), expected);
        for (const std::string& word : loaded.report.warnings)
            QVERIFY2(!explain_warning(word).empty(), word.c_str());
        // Cut anywhere it is an error, not half a relief. The last four bytes of a TIFF say that nothing
        // follows.
        const bool png = text.starts_with("\x89PNG");
        const std::size_t end =
            expected.contains("trailing") ? text.size() - 10 : text.size() - (png ? 0 : 4);
        for (std::size_t n = 0; n < end; n += 1 + end / 97)
            try {
                read_mesh(text.substr(0, n), name.toStdString(), reading_of(usual), Progress());
                QVERIFY2(false, qPrintable(QString("cut at %1").arg(n)));
            } catch (const Error& e) {
                QVERIFY(!e.remedy().empty());
            }
    }

    void broken_pictures_are_refused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* tag, const std::string& bytes, const char* expected,
                            const char* name = "a.png") {
            QTest::newRow(tag) << QByteArray(bytes.data(), qsizetype(bytes.size())) << name << expected;
        };
        const PngMaker png;
        const std::string sound = png.bytes();
        const auto changed = [&](std::size_t at, char to) {
            std::string bytes = sound;
            bytes[at] = to;
            return bytes;
        };
        row("30 000 x 30 000", PngMaker{.columns = 30000, .rows = 30000}.with_data(zlib_stored(png.raw())),
            "too_large");
        row("as large as numbers are",
            PngMaker{.columns = 0x7FFFFFFF, .rows = 0x7FFFFFFF}.with_data(zlib_stored(png.raw())),
            "too_large");
        row("interlaced and large",
            PngMaker{.columns = 9000, .rows = 9000, .bits = 16, .colour = 6, .interlaced = true}.with_data(
                zlib_stored(png.raw())),
            "too_large");
        row("long beyond measure", PngMaker{.columns = 100001, .rows = 2}.with_data(zlib_stored(png.raw())),
            "too_large");
        row("one column", PngMaker{.columns = 1, .rows = 9}.bytes(), "no_facets");
        row("one row", PngMaker{.columns = 9, .rows = 1}.bytes(), "no_facets");
        row("no column", PngMaker{.columns = 0}.with_data(zlib_stored("")), "syntax");
        row("7 bits", PngMaker{.bits = 7}.with_data(zlib_stored(png.raw())), "syntax");
        row(
            "colour type 5",
            [&] {
                std::string data = PngMaker{.bits = 8}.header();
                data[17] = 5;
                return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", data.substr(8, 13)) + png_chunk("IEND", "");
            }(),
            "syntax");
        row("header's sum is wrong", changed(30, 'x'), "syntax");
        row("data's sum is wrong", changed(45, 'x'), "syntax");
        row("a chunk as long as 2 GB", changed(33, '\x7F'), "truncated");
        row("no picture in it", "\x89PNG\r\n\x1A\n" + png.header() + png_chunk("IEND", ""), "syntax");
        row("a palette that is missing", PngMaker{.colour = 3}.bytes(), "syntax");
        row("too few rows", png.with_data(zlib_stored(png.raw().substr(0, 5))), "syntax");
        row("a filter that does not exist", png.with_data(zlib_stored("\x09" + png.raw().substr(1))),
            "syntax");
        row("data that is not compressed", png.with_data("these are no pixels"), "syntax");
        row("signature alone", sound.substr(0, 8), "truncated");
        row("header alone", sound.substr(0, 33), "truncated");
        row("cut in the data", sound.substr(0, sound.size() - 20), "truncated");
        row("cut before the end", sound.substr(0, sound.size() - 12), "truncated");
        row(
            "sent as text",
            [&] {
                std::string bytes = sound;
                bytes.insert(5, "\r");
                return bytes;
            }(),
            "syntax");
        row("a JPEG by another name", "\xFF\xD8\xFF\xE0 JFIF", "syntax");
        row("an STL by another name", binary_stl(box_mesh(Vec3(0, 0, 0), Vec3(1, 1, 1))), "syntax");
        row("empty", "", "empty_file");
        row("garbage behind the signature", sound.substr(0, 8) + std::string(200, '\x55'), "truncated");
        const auto tiff = [&](const char* tag, const TiffMaker& maker, const char* expected) {
            row(tag, maker.bytes(), expected, "a.tif");
        };
        tiff("TIFF, 30 000 x 30 000 and more", {.claimed_columns = 1'000'000'000}, "too_large");
        tiff("TIFF, half floats", {.bits = 16, .format = 3}, "unsupported_format");
        tiff("TIFF, not a number",
             {.bits = 32,
              .format = 3,
              .value = [](unsigned c,
                          unsigned) { return c == 1 ? std::numeric_limits<double>::quiet_NaN() : 1.0; }},
             "non_finite");
        tiff("TIFF, infinite",
             {.bits = 32, .format = 3, .value = [](unsigned, unsigned) { return infinity; }}, "non_finite");
        tiff("TIFF, one row", {.rows = 1}, "no_facets");
        row("TIFF, cut", TiffMaker{.columns = 40, .rows = 40}.bytes().substr(0, 900), "truncated,syntax",
            "a.tif");
        row("TIFF, header alone", TiffMaker().bytes().substr(0, 8), "truncated,syntax", "a.tif");
        row("a PNG as TIFF", sound, "syntax", "a.tif");
        row("a TIFF as PNG", TiffMaker().bytes(), "syntax");
    }
    void broken_pictures_are_refused() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(QString, expected);
        try {
            read_mesh(bytes.toStdString(), name.toStdString(), reading_of(usual), Progress());
            QVERIFY2(false, "must be refused");
        } catch (const Error& e) {
            QVERIFY2(expected.split(',').contains(QString::fromStdString(std::string(code_name(e.code())))),
                     e.what());
            const std::string line = e.what();
            QVERIFY2(line.find(name.toStdString()) != std::string::npos && !e.remedy().empty(), e.what());
            QVERIFY(printable(line, line.size()) == line);
        }
    }

    /// Any byte changed, and any few: a mesh or an error.
    void damage_does_no_harm() {
        std::mt19937 random(11);
        TiffMaker tiles{.columns = 20, .rows = 20, .bits = 16, .tile = 16};
        for (const auto& [bytes, name] :
             {std::pair{PngMaker{.columns = 9, .rows = 7, .colour = 6, .interlaced = true}.bytes(), "a.png"},
              {PngMaker{
                   .columns = 9, .rows = 7, .bits = 4, .pixel = [](unsigned c, unsigned, int) { return c; }}
                   .bytes(),
               "a.png"},
              {TiffMaker{.columns = 9, .rows = 7}.bytes(), "a.tif"},
              {tiles.bytes(), "a.tif"}})
            for (int trial = 0; trial < 700; ++trial) {
                std::string damaged = bytes;
                for (std::uint32_t k = 0; k < 1 + random() % 3; ++k)
                    damaged[random() % damaged.size()] = char(random());
                try {
                    read_mesh(damaged, name, reading_of(usual), Progress());
                } catch (const Error& e) {
                    QVERIFY(!e.message().empty());
                }
            }
    }

    void readings_have_keys_of_their_own() {
        std::set<std::string> keys;
        std::vector<MeshReading> all(9);
        all[1].unit = LengthUnit::mm;
        all[2].unit = LengthUnit::inch;
        all[3].objects = "a";
        all[4].relief.width = 5;
        all[5].relief.length = 5;
        all[6].relief.height = 5;
        all[7].relief.smoothing = 5;
        all[8].relief.invert = true;
        for (const MeshReading& reading : all)
            QVERIFY(keys.insert(reading_key(reading)).second);
    }
};

FACETMILL_TEST(TestRelief)
#include "test_relief.moc"
