// A folder for the outputs of a job that may fail.
#pragma once

#include <filesystem>
#include <vector>

namespace facetmill {

/// Makes a folder and those above it; on its end removes the ones it made that are empty: the job failed.
class NewFolder {
public:
    /// Throws Error(unwritable).
    explicit NewFolder(const std::filesystem::path& path);
    ~NewFolder() { remove(); }
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

private:
    void remove();
    std::vector<std::filesystem::path> made_;
};

} // namespace facetmill
