// A folder for the outputs of a job that may fail.
#pragma once

#include <filesystem>
#include <vector>

namespace facetmill {

/// Makes a folder and the missing ones above it. The destructor removes those it made that are still empty:
/// outputs appear on commit (OutputSet), so an empty folder is one of a job that failed.
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
