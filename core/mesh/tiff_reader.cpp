// TIFF pictures as reliefs: one channel of grey, 8 or 16 bits without a sign or 32-bit floats, in strips or
// tiles, by any compression that libtiff knows. Floats have no black and white of their own: their lowest is
// the ground and their highest the top.
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/relief.h"

#include "core/base/error.h"
#include "core/base/units.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

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
        if (TIFFIsTiled(tiff_.get()) != 0)
            prepare_tiles();
        else
            prepare_lines();
    }

    /// The next row of the picture, its values as they are.
    void read_row(std::size_t r, std::vector<double>& values) {
        const char* from = lines_.data();
        if (tile_rows_ > 0) {
            if (r % tile_rows_ == 0) read_tiles(r);
            from += (r % tile_rows_) * columns * bits / 8;
        } else if (TIFFReadScanline(tiff_.get(), lines_.data(), std::uint32_t(r)) != 1) {
            refuse();
        }
        for (std::size_t c = 0; c < columns; ++c) {
            if (is_float) {
                float v = 0;
                std::memcpy(&v, from + c * sizeof v, sizeof v);
                if (!std::isfinite(v) || std::abs(v) > 1e30F)
                    throw Error(ErrorCode::non_finite,
                                source_.name + ", pixel " + std::to_string(c) + ", " + std::to_string(r),
                                "the value is not a finite number", "fill gaps of the picture with a height");
                values[c] = double(v);
            } else if (bits == 16) {
                std::uint16_t v = 0;
                std::memcpy(&v, from + c * sizeof v, sizeof v);
                values[c] = v / 65535.0;
            } else {
                values[c] = static_cast<unsigned char>(from[c]) / 255.0;
            }
            if (white_is_low_) values[c] = is_float ? -values[c] : 1 - values[c];
        }
    }
    /// Whether another picture follows. The last that is asked.
    bool has_more() { return TIFFReadDirectory(tiff_.get()) == 1; }

    std::size_t columns = 0, rows = 0;
    unsigned bits = 0;
    bool is_float = false;

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
                    "save it as one channel of grey: 8 or 16 bits without a sign, or 32-bit floats");
    }

    void check_kind() {
        std::uint16_t depth = 0, samples = 0, kind = 0, photometric = PHOTOMETRIC_MINISBLACK, turned = 0;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &depth);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLEFORMAT, &kind);
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_ORIENTATION, &turned);
        TIFFGetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, &photometric);
        if (samples != 1) refuse_kind("the picture has " + std::to_string(samples) + " channels");
        if (photometric != PHOTOMETRIC_MINISBLACK && photometric != PHOTOMETRIC_MINISWHITE)
            refuse_kind("the picture is not one of grey");
        is_float = kind == SAMPLEFORMAT_IEEEFP;
        if (!is_float && kind != SAMPLEFORMAT_UINT && kind != SAMPLEFORMAT_VOID)
            refuse_kind("its numbers have a sign, or are no numbers");
        if (is_float ? depth != 32 : depth != 8 && depth != 16)
            refuse_kind("the picture has " + std::to_string(depth) + " bits a pixel"
                        + (is_float ? ", as floats" : ""));
        if (turned != ORIENTATION_TOPLEFT)
            refuse_kind("the picture says that it is to be turned or mirrored");
        bits = depth;
        white_is_low_ = photometric == PHOTOMETRIC_MINISWHITE;
    }

    void prepare_lines() {
        if (TIFFScanlineSize64(tiff_.get()) != columns * bits / 8) refuse();
        lines_.resize(columns * bits / 8);
    }

    void prepare_tiles() {
        std::uint32_t width = 0, height = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
        TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &height);
        if (width == 0 || height == 0
            || TIFFTileSize64(tiff_.get()) != std::uint64_t(width) * height * bits / 8)
            refuse();
        const std::uint64_t tile = std::uint64_t(width) * height * bits / 8;
        if (tile > max_tiff_bytes || std::uint64_t(columns) * height * bits / 8 > max_tiff_bytes)
            throw Error(ErrorCode::too_large, source_.name,
                        "the picture's tiles of " + std::to_string(width) + " × " + std::to_string(height)
                            + " pixels are too large",
                        "save it in strips or smaller tiles");
        tile_columns_ = width;
        tile_rows_ = height;
        tile_.resize(std::size_t(tile));
        lines_.resize(std::size_t(columns) * height * bits / 8);
    }

    /// All tiles of one height, from row `r` on.
    void read_tiles(std::size_t r) {
        const std::size_t bytes = bits / 8;
        for (std::size_t left = 0; left < columns; left += tile_columns_) {
            if (TIFFReadTile(tiff_.get(), tile_.data(), std::uint32_t(left), std::uint32_t(r), 0, 0) < 0)
                refuse();
            const std::size_t count = std::min(tile_columns_, columns - left) * bytes;
            for (std::size_t k = 0; k < tile_rows_; ++k)
                std::memcpy(&lines_[(k * columns + left) * bytes], &tile_[k * tile_columns_ * bytes], count);
        }
    }

    const MeshSource& source_;
    TiffFile& file_;
    Tiff tiff_;
    bool white_is_low_ = false;
    std::size_t tile_columns_ = 0, tile_rows_ = 0; ///< 0: it is in strips
    std::vector<char> tile_, lines_;
};

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
    for (std::size_t r = 0; r < picture.rows; ++r) {
        progress.set(0.6 * double(r) / double(picture.rows));
        picture.read_row(r, row);
        builder.add_row(row);
    }
    if (picture.is_float) builder.stretch();
    std::set<std::string> warnings;
    if (picture.bits == 8) warnings.insert("picture_steps");
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
