// PNG pictures as reliefs. Grey, grey with alpha, colours (their luminance) and palettes, of 1 to 16 bits;
// brightness is taken as it is stored, whatever gamma the file tells.
//
// libpng leaves a call that fails by a jump to the last setjmp. Every such call therefore has a function of
// its own, which holds nothing that has a destructor; nor do the functions that libpng calls back.
#include "core/mesh/mesh_format.h"
#include "core/mesh/mesh_reader.h"
#include "core/mesh/relief.h"

#include "core/base/error.h"

#include <cstring>

#include <png.h>

namespace facetmill::detail {

namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1A\n";
/// Chunks beside the picture (texts, colour profiles) are not read beyond this.
constexpr png_alloc_size_t max_chunk_bytes = png_alloc_size_t(8) << 20;
/// A picture whose rows do not come in order has to be in memory as a whole.
constexpr std::uint64_t max_interlaced_bytes = std::uint64_t(256) << 20;

class PngDecoder {
public:
    explicit PngDecoder(std::string_view bytes) : bytes_(bytes) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
    }
    ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    bool made() const { return info_ != nullptr; }
    /// Up to the first row. False where it failed, as with all of them.
    bool read_header() {
        if (setjmp(png_jmpbuf(png_))) return false; // NOLINT(cert-err52-cpp)
        png_set_read_fn(png_, this, take);
        png_set_chunk_malloc_max(png_, max_chunk_bytes);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX); // told by their number
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
        png_read_info(png_, info_);
        return true;
    }
    /// Rows of 16-bit numbers from here on, brightness or red, green, blue, and opacity where there is any.
    bool start() {
        if (setjmp(png_jmpbuf(png_))) return false; // NOLINT(cert-err52-cpp)
        if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
        if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
        png_set_expand_16(png_);
        if constexpr (std::endian::native == std::endian::little) png_set_swap(png_);
        passes_ = png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_row(std::uint16_t* row) {
        if (setjmp(png_jmpbuf(png_))) return false; // NOLINT(cert-err52-cpp)
        png_read_row(png_, reinterpret_cast<png_bytep>(row), nullptr);
        return true;
    }
    bool read_end() {
        if (setjmp(png_jmpbuf(png_))) return false; // NOLINT(cert-err52-cpp)
        png_read_end(png_, nullptr);
        return true;
    }

    std::size_t columns() const { return png_get_image_width(png_, info_); }
    std::size_t rows() const { return png_get_image_height(png_, info_); }
    int bits() const { return png_get_bit_depth(png_, info_); }
    std::size_t channels() const { return png_get_channels(png_, info_); }
    std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
    int passes() const { return passes_; }
    bool has_colours() const { return (png_get_color_type(png_, info_) & PNG_COLOR_MASK_COLOR) != 0; }
    bool at_end() const { return position_ == bytes_.size(); }

    [[noreturn]] void refuse(const MeshSource& source) const {
        if (cut_)
            throw Error(ErrorCode::truncated, source.name, "the picture ends before its last row",
                        "the file was cut: copy or export it again");
        throw Error(ErrorCode::syntax, source.name, "is no sound PNG picture: " + printable(message_),
                    "the file is damaged: export it again");
    }

private:
    static void take(png_structp png, png_bytep to, png_size_t count) {
        auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
        if (count > self->bytes_.size() - self->position_) {
            self->cut_ = true;
            png_error(png, "the file ends too early");
        }
        std::memcpy(to, self->bytes_.data() + self->position_, count);
        self->position_ += count;
    }
    [[noreturn]] static void fail(png_structp png, png_const_charp message) {
        auto* self = static_cast<PngDecoder*>(png_get_error_ptr(png));
        std::strncpy(self->message_, message, sizeof self->message_ - 1);
        png_longjmp(png, 1);
    }
    static void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

    std::string_view bytes_;
    std::size_t position_ = 0;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    int passes_ = 1;
    bool cut_ = false;
    char message_[160] = {};
};

/// The rows of a picture, in order, whether or not the file has them so.
class PngRows {
public:
    PngRows(PngDecoder& decoder, const MeshSource& source, const Progress& progress)
        : decoder_(decoder), source_(source), stride_(decoder.row_bytes() / sizeof(std::uint16_t)) {
        const bool interlaced = decoder.passes() > 1;
        const std::size_t rows = decoder.rows();
        if (interlaced && std::uint64_t(rows) * decoder.row_bytes() > max_interlaced_bytes)
            throw Error(ErrorCode::too_large, source.name,
                        "the picture is interlaced and has " + std::to_string(decoder.columns()) + " × "
                            + std::to_string(rows) + " pixels",
                        "save it without interlacing");
        values_.resize(stride_ * (interlaced ? rows : 1));
        for (int pass = 0; interlaced && pass < decoder.passes(); ++pass)
            for (std::size_t r = 0; r < rows; ++r) {
                progress.set((pass + double(r) / double(rows)) / decoder.passes());
                if (!decoder.read_row(&values_[r * stride_])) decoder.refuse(source);
            }
        whole_ = interlaced;
    }
    const std::uint16_t* row(std::size_t r) {
        if (!whole_ && !decoder_.read_row(values_.data())) decoder_.refuse(source_);
        return whole_ ? &values_[r * stride_] : values_.data();
    }

private:
    PngDecoder& decoder_;
    const MeshSource& source_;
    std::size_t stride_; ///< numbers a row
    std::vector<std::uint16_t> values_;
    bool whole_ = false;
};

TriangleSoup read_png(const MeshSource& source, const Progress& progress) {
    if (!source.bytes.starts_with(png_signature)) {
        // The signature has a byte of eight bits and both kinds of line ends, to show just this.
        if (source.bytes.substr(1, 3) == "PNG")
            throw Error(ErrorCode::syntax, source.name,
                        "its first bytes are not those of a PNG picture, as after a transfer as text",
                        "send it again as a binary file");
        const std::string_view what = content_of(source.bytes, "PNG");
        throw Error(ErrorCode::syntax, source.name,
                    what.empty() ? "is not a PNG picture" : "is not a PNG picture but " + std::string(what),
                    "save the picture as PNG, 8 or 16 bits of grey");
    }
    PngDecoder decoder(source.bytes);
    if (!decoder.made()) throw std::bad_alloc();
    if (!decoder.read_header()) decoder.refuse(source);
    const std::size_t columns = decoder.columns(), rows = decoder.rows();
    check_picture_size(source, columns, rows);
    std::set<std::string> warnings;
    if (decoder.bits() <= 8) warnings.insert("picture_steps");
    if (decoder.has_colours()) warnings.insert("picture_colours");
    if (!decoder.start()) decoder.refuse(source);

    const std::size_t channels = decoder.channels();
    const bool has_opacity = channels % 2 == 0;
    PngRows picture(decoder, source, progress.part(0, decoder.passes() > 1 ? 0.3 : 0.0));
    ReliefBuilder builder(source, columns, rows);
    std::vector<double> brightness(columns), opacity(has_opacity ? columns : 0);
    constexpr double full = 65535;
    bool transparent = false;
    for (std::size_t r = 0; r < rows; ++r) {
        progress.set(0.3 + 0.3 * double(r) / double(rows));
        const std::uint16_t* value = picture.row(r);
        for (std::size_t c = 0; c < columns; ++c, value += channels) {
            brightness[c] = channels < 3
                                ? double(value[0]) / full
                                : (2126.0 * value[0] + 7152.0 * value[1] + 722.0 * value[2]) / (10000 * full);
            if (!has_opacity) continue;
            opacity[c] = double(value[channels - 1]) / full;
            transparent = transparent || opacity[c] < 1;
        }
        builder.add_row(brightness, opacity);
    }
    if (!decoder.read_end()) decoder.refuse(source);
    if (!decoder.at_end()) warnings.insert("trailing_data");
    if (transparent) warnings.insert("picture_transparent");
    return builder.finish("PNG", std::move(warnings), progress.part(0.6, 1));
}

bool sniff_png(std::string_view bytes) {
    return bytes.starts_with(png_signature);
}

} // namespace

MeshFormat png_format() {
    return {.name = "PNG",
            .label = "a PNG picture",
            .extensions = {".png"},
            .sniff = sniff_png,
            .read = read_png,
            .is_picture = true};
}

} // namespace facetmill::detail
