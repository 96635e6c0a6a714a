#include "tests/support/picture_compare.h"

#include "tests/support/test_runner.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

namespace facetmill::test {

namespace fs = std::filesystem;

PictureDifference compare_pictures(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height || a.width < 1 || a.height < 1) return {0.0, 0, 0};
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255; // as in the paper
    const int w = std::min(8, a.width), h = std::min(8, a.height);
    const double n = w * h;
    PictureDifference result;
    for (int y = 0; y + h <= a.height; ++y)
        for (int x = 0; x + w <= a.width; ++x)
            for (int c = 0; c < 3; ++c) {
                long sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
                for (int j = 0; j < h; ++j)
                    for (int i = 0; i < w; ++i) {
                        const int p = a.pixel(x + i, y + j)[c], q = b.pixel(x + i, y + j)[c];
                        sa += p;
                        sb += q;
                        saa += p * p;
                        sbb += q * q;
                        sab += p * q;
                    }
                const double ma = double(sa) / n, mb = double(sb) / n;
                const double va = double(saa) / n - ma * ma, vb = double(sbb) / n - mb * mb;
                const double vab = double(sab) / n - ma * mb;
                const double s =
                    (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
                if (s < result.worst) result = {s, x, y};
            }
    return result;
}

std::size_t different_pixels(const Picture& a, const Picture& b) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3)
        n += a.rgb[i] != b.rgb[i] || a.rgb[i + 1] != b.rgb[i + 1] || a.rgb[i + 2] != b.rgb[i + 2];
    return n;
}

Picture difference_picture(const Picture& a, const Picture& b) {
    Picture d{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
    for (std::size_t i = 0; i < d.rgb.size() && i < b.rgb.size(); ++i)
        d.rgb[i] = std::uint8_t(std::min(255, 4 * std::abs(int(a.rgb[i]) - int(b.rgb[i]))));
    return d;
}

std::string check_picture(const Picture& picture, const std::string& name, const std::string& out_folder) {
    const fs::path baseline = data_path("screenshot/baseline/" + name + ".png");
    std::optional<Picture> expected;
    if (fs::exists(baseline)) expected = read_png(baseline);
    const PictureDifference difference =
        expected ? compare_pictures(*expected, picture) : PictureDifference{0.0, 0, 0};
    if (expected && difference.worst >= min_similarity) return {};

    const char* update = std::getenv("FACETMILL_UPDATE_PICTURES");
    if (update && std::strcmp(update, "1") == 0) {
        fs::create_directories(baseline.parent_path());
        write_png(picture, baseline);
        return {};
    }
    fs::create_directories(out_folder);
    const fs::path out = fs::path(out_folder) / (name + "-out.png");
    write_png(picture, out);
    if (!expected) return name + ": there is no baseline; the picture is in " + out.string();
    if (expected->width != picture.width || expected->height != picture.height)
        return name + ": " + std::to_string(picture.width) + "x" + std::to_string(picture.height)
               + " instead of " + std::to_string(expected->width) + "x" + std::to_string(expected->height)
               + "; see " + out.string();
    write_png(difference_picture(*expected, picture), fs::path(out_folder) / (name + "-diff.png"));
    return name + ": the window at " + std::to_string(difference.x) + ", " + std::to_string(difference.y)
           + " has similarity " + std::to_string(difference.worst) + ", wanted "
           + std::to_string(min_similarity) + "; see " + out.string();
}

} // namespace facetmill::test
