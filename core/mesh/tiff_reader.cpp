// TIFF pictures as reliefs, in strips or tiles, by any compression that libtiff knows. One channel of grey is
// taken as it is: 1, 2, 4, 8, 12 or 16 bits from black to white; integers with a sign or of 32 bits, and
// floats, which have no black and white of their own: their lowest is the ground and their highest the top.
// Whatever else there is (colours, palettes, opacity, pictures that are to be turned) libtiff makes 8-bit
// colours of.
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/relief.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/units.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <tiffio.h>

namespace facetmill::detail {

namespace {

/// What libtiff may allocate at once, and what a row of tiles may take.
constexpr std::uint64_t max_tiff_bytes = std::uint64_t(256) << 20;

bool sniff_tiff(std::string_view bytes) {
    using namespace std::string_view_literals;
    for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (bytes.starts_with(start)) return true;
    return false;
}

/// A file in memory, as libtiff reads it.
struct TiffFile {
    std::string_view bytes;
    std::uint64_t position = 0;
    bool cut = false; ///< something was to be read beyond the end
    char message[200] = {};
};

tmsize_t take_bytes(thandle_t handle, void* to, tmsize_t count) {
    auto& file = *static_cast<TiffFile*>(handle);
    const std::uint64_t left = file.bytes.size() - std::min<std::uint64_t>(file.position, file.bytes.size());
    const std::uint64_t taken = std::min<std::uint64_t>(left, std::uint64_t(std::max<tmsize_t>(count, 0)));
    if (taken > 0) std::memcpy(to, file.bytes.data() + file.position, std::size_t(taken));
    file.position += taken;
    file.cut = file.cut || taken < std::uint64_t(count);
    return tmsize_t(taken);
}
tmsize_t write_nothing(thandle_t /*handle*/, void* /*from*/, tmsize_t /*count*/) {
    return 0;
}
toff_t seek_to(thandle_t handle, toff_t offset, int from) {
    auto& file = *static_cast<TiffFile*>(handle);
    const std::uint64_t start = from == SEEK_CUR ? file.position : from == SEEK_END ? file.bytes.size() : 0;
    return file.position = start + offset;
}
int close_nothing(thandle_t /*handle*/) {
    return 0;
}
toff_t size_of(thandle_t handle) {
    return static_cast<TiffFile*>(handle)->bytes.size();
}
/// 1: no handler of the process is asked.
int keep_message(TIFF* /*tiff*/, void* user, const char* /*module*/, const char* format, va_list values) {
    auto& file = *static_cast<TiffFile*>(user);
    if (file.message[0] == '\0') std::vsnprintf(file.message, sizeof file.message, format, values);
    return 1;
}
int ignore_message(TIFF* /*tiff*/, void* /*user*/, const char* /*module*/, const char* /*format*/,
                   va_list /*values*/) {
    return 1;
}

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff open_tiff(TiffFile& file) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t(max_tiff_bytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &file);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
    // Not mapped: what lies beyond the end of a file that was cut is never touched.
    return Tiff(TIFFClientOpenExt("picture", "rm", &file, take_bytes, write_nothing, seek_to, close_nothing,
                                  size_of, nullptr, nullptr, options.get()));
}

class TiffPicture {
public:
    TiffPicture(const MeshSource& source, TiffFile& file)
        : source_(source), file_(file), tiff_(open_tiff(file)) {
        if (!tiff_) refuse();
        std::uint32_t width = 0, height = 0;
        if (TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width) == 0
            || TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height) == 0)
            refuse();
        check_picture_size(source, width, height);
        columns = width;
        rows = height;
        check_kind();
        if (!colours_.empty()) return;
        if (TIFFIsTiled(tiff_.get()) != 0)
            prepare_tiles();
        else
            prepare_lines();
    }

    /// The next row of the picture, its values as they are. A value that stands for none is not a number.
    void read_row(std::size_t r, std::vector<double>& values) {
        if (!colours_.empty()) return read_colours(r, values);
        const char* from = lines_.data();
        if (tile_rows_ > 0) {
            if (r % tile_rows_ == 0) read_tiles(r);
            from += (r % tile_rows_) * row_bytes(columns);
        } else if (TIFFReadScanline(tiff_.get(), lines_.data(), std::uint32_t(r)) != 1) {
            refuse();
        }
        for (std::size_t c = 0; c < columns; ++c) {
            double v = number(from, c);
            if (v == nothing_ || (nothing_ && std::isnan(v) && std::isnan(*nothing_))) {
                values[c] = std::numeric_limits<double>::quiet_NaN();
                continue;
            }
            if (!std::isfinite(v) || std::abs(v) > 1e30)
                throw Error(ErrorCode::non_finite,
                            source_.name + ", pixel " + std::to_string(c) + ", " + std::to_string(r),
                            "the value is not a finite number", "fill gaps of the picture with a height");
            if (!without_scale) v /= double((1U << bits) - 1);
            values[c] = !white_is_low_ ? v : without_scale ? -v : 1 - v;
        }
    }
    /// Some of libtiff's decoders complain about damage and go on: what they make of it is no picture. After
    /// the last row.
    void check_sound() const {
        if (file_.message[0] != '\0') refuse();
    }
    /// Whether another picture follows. The last that is asked.
    bool has_more() { return TIFFReadDirectory(tiff_.get()) == 1; }

    std::size_t columns = 0, rows = 0;
    unsigned bits = 0;          ///< of a number, as it comes out
    bool without_scale = false; ///< numbers that have no black and white of their own
    bool has_colours = false, has_gaps = false;

private:
    [[noreturn]] void refuse() const {
        if (file_.cut)
            throw Error(ErrorCode::truncated, source_.name, "the picture ends before its last row",
                        "the file was cut: copy or export it again");
        throw Error(ErrorCode::syntax, source_.name,
                    "is no TIFF picture that can be read: " + printable(file_.message, 160),
                    "export it again, without compression");
    }
    [[noreturn]] void refuse_kind(const std::string& what) const {
        throw Error(ErrorCode::unsupported_format, source_.name, what,
                    "save it as one channel of grey: 8 or 16 bits, or 32-bit floats");
    }

    void check_kind() {
        std::uint16_t depth = 0, samples = 0, kind = 0, photometric = PHOTOMETRIC_MINISBLACK, turned = 0;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &depth);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLEFORMAT, &kind);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_ORIENTATION, &turned);
        TIFFGetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, &photometric);
        const bool is_grey =
            samples == 1 && (photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE);
        if (!is_grey || turned != ORIENTATION_TOPLEFT) return take_colours(is_grey);
        kind_ = kind == SAMPLEFORMAT_VOID ? std::uint16_t(SAMPLEFORMAT_UINT) : kind;
        bool known = false;
        if (kind_ == SAMPLEFORMAT_IEEEFP)
            known = depth == 32 || depth == 64;
        else if (kind_ == SAMPLEFORMAT_INT)
            known = depth == 8 || depth == 16 || depth == 32;
        else if (kind_ == SAMPLEFORMAT_UINT)
            known = depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 12 || depth == 16
                    || depth == 32;
        if (!known)
            refuse_kind("the picture has " + std::to_string(depth) + " bits a pixel"
                        + (kind_ == SAMPLEFORMAT_IEEEFP ? ", as floats"
                           : kind_ == SAMPLEFORMAT_INT  ? ", with a sign"
                           : kind_ == SAMPLEFORMAT_UINT ? ""
                                                        : ", which are no plain numbers"));
        bits = depth;
        without_scale = kind_ != SAMPLEFORMAT_UINT || depth == 32;
        white_is_low_ = photometric == PHOTOMETRIC_MINISWHITE;
        find_gaps();
    }

    /// Grids of heights may have a value that stands for none, which GDAL writes down as a text.
    void find_gaps() {
        constexpr std::uint32_t gdal_nodata = 42113;
        std::uint32_t count = 0;
        const char* text = nullptr;
        if (TIFFGetField(tiff_.get(), gdal_nodata, &count, &text) != 1 || !text || count == 0) return;
        double v = 0;
        const std::string_view stated = trimmed({text, strnlen(text, count)});
        if (stated == "nan")
            v = std::numeric_limits<double>::quiet_NaN();
        else if (read_number(stated, v) != NumberForm::number)
            return;
        // As the picture's own numbers have it.
        nothing_ = kind_ == SAMPLEFORMAT_IEEEFP && bits == 32 ? double(float(v)) : v;
        has_gaps = true;
    }

    /// All of it at once, as libtiff turns it into colours, black where it is transparent.
    void take_colours(bool is_grey) {
        if (std::uint64_t(columns) * rows * sizeof(std::uint32_t) > max_tiff_bytes)
            throw Error(ErrorCode::too_large, source_.name,
                        "the picture is not plain grey and has " + std::to_string(columns) + " × "
                            + std::to_string(rows) + " pixels",
                        "save it as one channel of grey, upright");
        char why[1024] = {};
        if (TIFFRGBAImageOK(tiff_.get(), why) == 0)
            refuse_kind("the picture's colours cannot be read: " + printable(why, 160));
        colours_.resize(columns * rows);
        if (TIFFReadRGBAImageOriented(tiff_.get(), std::uint32_t(columns), std::uint32_t(rows),
                                      colours_.data(), ORIENTATION_TOPLEFT, 1)
            != 1)
            refuse();
        bits = 8;
        has_colours = !is_grey;
    }
    void read_colours(std::size_t r, std::vector<double>& values) const {
        for (std::size_t c = 0; c < columns; ++c) {
            const std::uint32_t v = colours_[r * columns + c];
            values[c] = (2126.0 * TIFFGetR(v) + 7152.0 * TIFFGetG(v) + 722.0 * TIFFGetB(v)) / (10000.0 * 255);
        }
    }

    std::size_t row_bytes(std::size_t pixels) const { return (pixels * bits + 7) / 8; }

    template <class Number>
    static double number_at(const char* from, std::size_t c) {
        Number v{};
        std::memcpy(&v, from + c * sizeof v, sizeof v);
        return double(v);
    }
    /// The number of pixel `c` of a row, in the machine's own order of bytes.
    double number(const char* from, std::size_t c) const {
        if (kind_ == SAMPLEFORMAT_IEEEFP)
            return bits == 32 ? number_at<float>(from, c) : number_at<double>(from, c);
        const bool has_sign = kind_ == SAMPLEFORMAT_INT;
        switch (bits) {
        case 8:
            return has_sign ? number_at<std::int8_t>(from, c) : number_at<std::uint8_t>(from, c);
        case 16:
            return has_sign ? number_at<std::int16_t>(from, c) : number_at<std::uint16_t>(from, c);
        case 32:
            return has_sign ? number_at<std::int32_t>(from, c) : number_at<std::uint32_t>(from, c);
        default: // packed, the highest bit first
            unsigned v = 0;
            for (std::size_t bit = c * bits; bit < (c + 1) * bits; ++bit)
                v = 2 * v + ((static_cast<unsigned char>(from[bit / 8]) >> (7 - bit % 8)) & 1U);
            return v;
        }
    }

    void prepare_lines() {
        if (TIFFScanlineSize64(tiff_.get()) != row_bytes(columns)) refuse();
        lines_.resize(row_bytes(columns));
    }

    void prepare_tiles() {
        std::uint32_t width = 0, height = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
        TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &height);
        const std::uint64_t tile = std::uint64_t(row_bytes(width)) * height;
        if (width == 0 || height == 0 || width * bits % 8 != 0 || TIFFTileSize64(tiff_.get()) != tile)
            refuse();
        const std::uint64_t across = (columns + width - 1) / width * std::uint64_t(width);
        if (tile > max_tiff_bytes || across * height * bits / 8 > max_tiff_bytes)
            throw Error(ErrorCode::too_large, source_.name,
                        "the picture's tiles of " + std::to_string(width) + " × " + std::to_string(height)
                            + " pixels are too large",
                        "save it in strips or smaller tiles");
        tile_columns_ = width;
        tile_rows_ = height;
        tile_.resize(std::size_t(tile));
        lines_.resize(row_bytes(columns) * height);
    }

    /// All tiles of one height, from row `r` on.
    void read_tiles(std::size_t r) {
        const std::size_t line = row_bytes(columns), tile_line = row_bytes(tile_columns_);
        for (std::size_t left = 0; left < columns; left += tile_columns_) {
            if (TIFFReadTile(tiff_.get(), tile_.data(), std::uint32_t(left), std::uint32_t(r), 0, 0) < 0)
                refuse();
            // A tile's width is a multiple of sixteen, so every tile begins at a whole byte of the row.
            const std::size_t count = row_bytes(std::min(tile_columns_, columns - left));
            for (std::size_t k = 0; k < tile_rows_; ++k)
                std::memcpy(&lines_[k * line + row_bytes(left)], &tile_[k * tile_line], count);
        }
    }

    const MeshSource& source_;
    TiffFile& file_;
    Tiff tiff_;
    std::uint16_t kind_ = SAMPLEFORMAT_UINT;
    bool white_is_low_ = false;
    std::optional<double> nothing_; ///< the number that stands for no height
    std::vector<std::uint32_t> colours_;
    std::size_t tile_columns_ = 0, tile_rows_ = 0; ///< 0: it is in strips
    std::vector<char> tile_, lines_;
};

/// The lowest and the highest of all heights; zeros where there is none.
std::pair<double, double> heights_between(TiffPicture& picture, const Progress& progress) {
    std::vector<double> row(picture.columns);
    double low = infinity, high = -infinity;
    for (std::size_t r = 0; r < picture.rows; ++r) {
        progress.set(double(r) / double(picture.rows));
        picture.read_row(r, row);
        for (const double v : row)
            if (!std::isnan(v)) {
                low = std::min(low, v);
                high = std::max(high, v);
            }
    }
    return low <= high ? std::pair(low, high) : std::pair(0.0, 0.0);
}

TriangleSoup read_tiff(const MeshSource& source, const Progress& progress) {
    if (!sniff_tiff(source.bytes)) {
        const std::string_view what = content_of(source.bytes, "TIFF");
        throw Error(ErrorCode::syntax, source.name,
                    what.empty() ? "is not a TIFF picture" : "is not a TIFF picture but " + std::string(what),
                    "save the picture as TIFF, 16 bits of grey");
    }
    TiffFile file{.bytes = source.bytes};
    TiffPicture picture(source, file);
    ReliefBuilder builder(source, picture.columns, picture.rows);
    std::vector<double> row(picture.columns);
    // Where there is no height lies the ground, whether or not the relief is inverted.
    double ground = 0;
    if (picture.has_gaps) {
        const auto [low, high] = heights_between(picture, progress.part(0, 0.3));
        ground = source.reading.relief.invert ? high : low;
    }
    std::set<std::string> warnings;
    for (std::size_t r = 0; r < picture.rows; ++r) {
        progress.set(0.3 + 0.3 * double(r) / double(picture.rows));
        picture.read_row(r, row);
        for (double& v : row)
            if (std::isnan(v)) {
                v = ground;
                warnings.insert("picture_transparent");
            }
        builder.add_row(row);
    }
    picture.check_sound();
    if (picture.without_scale) builder.stretch();
    if (picture.bits <= 8) warnings.insert("picture_steps");
    if (picture.has_colours) warnings.insert("picture_colours");
    if (picture.has_more()) warnings.insert("picture_pages");
    return builder.finish("TIFF", std::move(warnings), progress.part(0.6, 1));
}

} // namespace

MeshFormat tiff_format() {
    return {.name = "TIFF",
            .label = "a TIFF picture",
            .extensions = {".tif", ".tiff"},
            .sniff = sniff_tiff,
            .read = read_tiff,
            .is_picture = true};
}

} // namespace facetmill::detail
