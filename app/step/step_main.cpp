// facetmill-step: STEP and IGES files to facets, see core/mesh/tessellated.h for what goes in and out.
#include "app/step/surface_file.h"
#include "app/step/tessellation.h"
#include "core/base/error.h"
#include "core/mesh/tessellated.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <OSD.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <new>
#include <utility>

#include <fcntl.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace facetmill::step {

namespace {

struct Request {
    SurfaceFormat format = SurfaceFormat::step;
    double chord = 0, angle = 0; ///< mm, radians
    double memory = 0;           ///< MB; 0: no limit
    std::string input, output;
};

constexpr std::string_view usage =
    "usage: facetmill-step --format step|iges --chord MM --angle DEGREES [--memory MB] INPUT OUTPUT\n";

double number_of(const char* text) {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    return *text && !*end ? value : std::nan("");
}

/// False where the words make no request.
bool parse(int argc, char** argv, Request& request) {
    std::map<std::string, std::string> options;
    std::vector<std::string> operands;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word.rfind("--", 0) != 0)
            operands.push_back(word);
        else if (i + 1 < argc)
            options[word] = argv[++i];
        else
            return false;
    }
    const std::string format = options["--format"];
    if (operands.size() != 2 || (format != "step" && format != "iges")) return false;
    request.format = format == "step" ? SurfaceFormat::step : SurfaceFormat::iges;
    request.chord = number_of(options["--chord"].c_str());
    request.angle = number_of(options["--angle"].c_str()) * std::acos(-1.0) / 180;
    if (options.count("--memory")) request.memory = number_of(options["--memory"].c_str());
    request.input = operands[0];
    request.output = operands[1];
    return request.chord > 0 && std::isfinite(request.chord) && request.angle > 0 && request.angle < 3
           && request.memory >= 0;
}

void limit_resources(double megabytes) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (megabytes <= 0) return;
    ::mallopt(M_ARENA_MAX, 4); // each reserves room of its own, which counts
    const auto bytes = rlim_t(megabytes * 1024 * 1024);
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return text.substr(0, 200);
}

class BinaryFile {
public:
    explicit BinaryFile(const std::string& path) : file_(std::fopen(path.c_str(), "wb")) {
        if (!file_) fail();
    }
    ~BinaryFile() {
        if (file_) std::fclose(file_);
    }
    BinaryFile(const BinaryFile&) = delete;
    BinaryFile& operator=(const BinaryFile&) = delete;

    void write(const void* bytes, std::size_t count) {
        if (count > 0 && std::fwrite(bytes, 1, count, file_) != count) fail();
    }
    void close() {
        if (std::fclose(std::exchange(file_, nullptr)) != 0) fail();
    }

private:
    [[noreturn]] void fail() const {
        throw Error(ErrorCode::unwritable, "",
                    std::string("the facets cannot be written: ") + std::strerror(errno), "free some room");
    }
    std::FILE* file_;
};

void write_result(const std::string& path, const SurfaceFile& file, const Tessellation& made) {
    std::string head(detail::tessellated_magic);
    head += "\n";
    const auto add = [&](const std::string& key, const std::string& value) {
        head += key + " " + value + "\n";
    };
    const auto number = [](double v) {
        char text[32];
        std::snprintf(text, sizeof text, "%.17g", v);
        return std::string(text);
    };
    add("vertices", std::to_string(made.vertices.size()));
    add("facets", std::to_string(made.facets.size()));
    add("faces", std::to_string(file.numbers));
    add("unit", one_line(file.unit));
    add("mm_per_unit", number(file.mm_per_unit));
    add("out", number(made.out));
    add("in", number(made.in));
    add("chord", number(made.chord));
    add("solids", std::to_string(file.bodies));
    add("loose_faces", std::to_string(file.loose_faces));
    add("missing_faces", std::to_string(made.missing_faces));
    add("sewn", file.sewn ? "1" : "0");
    add("part_count", std::to_string(file.parts.size()));
    for (std::size_t i = 0; i < file.parts.size() && i < detail::max_part_names; ++i)
        add("part", one_line(file.parts[i]));
    head += "\n";
    BinaryFile out(path);
    out.write(head.data(), head.size());
    out.write(made.vertices.data(), made.vertices.size() * sizeof made.vertices[0]);
    out.write(made.facets.data(), made.facets.size() * sizeof made.facets[0]);
    out.write(made.face_of.data(), made.face_of.size() * sizeof made.face_of[0]);
    out.close();
}

Error out_of_memory(const Request& request) {
    return Error(ErrorCode::too_large, "",
                 request.memory > 0 ? "it does not fit into the " + std::to_string(long(request.memory))
                                          + " MB of memory that reading it may take"
                                    : "it does not fit into memory",
                 "allow a larger chord tolerance, or export the parts one by one");
}

/// Whether the memory that may be taken was as good as used up: the library leaves a surface out then and
/// goes on.
bool memory_ran_out(const Request& request) {
    constexpr double share = 0.8;
    std::ifstream status("/proc/self/status");
    for (std::string word; request.memory > 0 && status >> word;)
        if (double peak = 0; word == "VmPeak:" && status >> peak) return peak / 1024 > share * request.memory;
    return false;
}

/// Surfaces that are left out for want of memory are no result.
Tessellation tessellated(const SurfaceFile& file, const Request& request, StepProgress& progress) {
    try {
        Tessellation made = tessellate(file, request.chord, request.angle, progress);
        if (made.missing_faces == 0 || !memory_ran_out(request)) return made;
    } catch (const Error& e) {
        if (e.code() != ErrorCode::no_facets || !memory_ran_out(request)) throw;
    }
    throw out_of_memory(request);
}

void run(const Request& request, StepProgress& progress) {
    // Messages of the library would stand between the lines.
    Message::DefaultMessenger()->ChangePrinters().Clear();
    OSD::SetSignal(Standard_False); // faults in it become exceptions where they can
    const SurfaceFile file = read_surface_file(request.input, request.format, request.chord, progress);
    const Tessellation made = tessellated(file, request, progress);
    write_result(request.output, file, made);
}

int report(const StepProgress& progress, const Error& e) {
    progress.line("error " + std::string(code_name(e.code())));
    progress.line("what " + one_line(e.message()));
    progress.line("remedy " + one_line(e.remedy()));
    return 1;
}

int guarded_run(const Request& request, StepProgress& progress) {
    try {
        run(request, progress);
        return 0;
    } catch (const Error& e) {
        return report(progress, e);
    } catch (const Standard_OutOfMemory&) {
        return report(progress, out_of_memory(request));
    } catch (const std::bad_alloc&) {
        return report(progress, out_of_memory(request));
    } catch (const Standard_Failure& e) {
        return report(progress,
                      Error(ErrorCode::syntax, "",
                            std::string("OpenCASCADE cannot work with it: ") + e.DynamicType()->Name() + " "
                                + (e.GetMessageString() ? e.GetMessageString() : ""),
                            "export the part again, or as STL"));
    } catch (const std::exception& e) {
        return report(progress, Error(ErrorCode::internal, "", e.what(), "export the part as STL"));
    }
}

} // namespace

} // namespace facetmill::step

int main(int argc, char** argv) {
    using namespace facetmill::step;
    Request request;
    if (!parse(argc, argv, request)) {
        std::fwrite(usage.data(), 1, usage.size(), stderr);
        return 2;
    }
    limit_resources(request.memory);
    // What the library prints itself goes where errors go.
    const int lines = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 10);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    StepProgress progress(lines);
    const int status = guarded_run(request, progress);
    // Taking everything apart again takes as long as a part of the work.
    std::_Exit(status);
}
