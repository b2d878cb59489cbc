// Every source file of the engine and of the programs keeps to the tables of ARCHITECTURE.md.
#include "architecture/include_rules.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

namespace fs = std::filesystem;

ArchitecturePage page() {
    return read_architecture_page(core::read_text_file(source_file("ARCHITECTURE.md")));
}

bool is_source(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".cpp" || extension == ".hpp" || extension == ".h";
}

std::vector<fs::path> source_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (is_source(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// "engine/film" and its like: those that hold sources.
std::vector<std::string> folders_with_sources() {
    std::vector<std::string> folders;
    for (const std::string part : {"engine", "app"})
        for (const auto& entry : fs::directory_iterator(source_file(part)))
            if (entry.is_directory() && !source_files(entry.path()).empty())
                folders.push_back(part + "/" + entry.path().filename().string());
    std::sort(folders.begin(), folders.end());
    return folders;
}

TEST(Includes, EveryFolderHasARowAndEveryRowAFolder) {
    for (const std::string& violation : folder_violations(page(), folders_with_sources()))
        ADD_FAILURE() << violation;
}

TEST(Includes, PointDownTheLevels) {
    const ArchitecturePage rules = page();
    int files = 0;
    for (const char* part : {"engine", "app"}) {
        for (const fs::path& file : source_files(source_file(part))) {
            ++files;
            const std::string path = fs::relative(file, source_file("")).generic_string();
            for (const std::string& violation :
                 include_violations(rules, path, core::read_text_file(file)))
                ADD_FAILURE() << violation;
        }
    }
    EXPECT_GT(files, 20);
}

}  // namespace
}  // namespace pastoso::tests
