#include "viz/picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>

namespace facetmill {

std::string encode_png(const Picture& picture) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const std::size_t row = 3 * std::size_t(picture.width);
    for (int y = 0; y < picture.height; ++y) // VTK's rows run from the bottom up
        std::memcpy(image->GetScalarPointer(0, picture.height - 1 - y, 0), picture.pixel(0, y), row);
    vtkNew<vtkPNGWriter> writer;
    writer->WriteToMemoryOn();
    writer->SetInputData(image);
    writer->Write();
    const vtkUnsignedCharArray* result = writer->GetResult();
    if (!result) throw Error(ErrorCode::internal, "", "the picture could not be encoded", "make it smaller");
    auto* bytes = const_cast<vtkUnsignedCharArray*>(result);
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)), std::size_t(bytes->GetNumberOfValues())};
}

void write_png(const Picture& picture, const std::filesystem::path& path) {
    const std::string bytes = encode_png(picture);
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

Picture read_png(const std::filesystem::path& path) {
    const std::string name = printable(path.string(), 400);
    const InputFile file(path); // for its errors
    if (!file.bytes().starts_with("\x89PNG\r\n\x1a\n"))
        throw Error(ErrorCode::unsupported_format, name, "is not a PNG picture", "give a .png file");
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    int size[3];
    image->GetDimensions(size);
    const int components = image->GetNumberOfScalarComponents();
    if (reader->GetErrorCode() != 0 || size[0] < 1 || size[1] < 1
        || image->GetScalarType() != VTK_UNSIGNED_CHAR || components < 1 || components > 4)
        throw Error(ErrorCode::unsupported_format, name, "the PNG picture cannot be read",
                    "save it with 8 bits a channel");
    Picture picture{size[0], size[1],
                    std::vector<std::uint8_t>(3 * std::size_t(size[0]) * std::size_t(size[1]))};
    for (int y = 0; y < size[1]; ++y) {
        const auto* in = static_cast<const std::uint8_t*>(image->GetScalarPointer(0, size[1] - 1 - y, 0));
        for (int x = 0; x < size[0]; ++x, in += components)
            for (int c = 0; c < 3; ++c)
                picture.pixel(x, y)[c] = in[components >= 3 ? c : 0];
    }
    return picture;
}

} // namespace facetmill
