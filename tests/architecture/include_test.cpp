// Every source file of the engine and of the programs keeps to the table of ARCHITECTURE.md.
#include "architecture/include_rules.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> source_files() {
    std::vector<fs::path> files;
    for (const char* part : {"engine", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(pastoso::tests::source_file(part))) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".cpp" || extension == ".hpp" || extension == ".h")
                files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(Includes, PointDownTheLevels) {
    const std::vector<fs::path> files = source_files();
    EXPECT_GT(files.size(), 20U);
    for (const fs::path& file : files) {
        const std::string path = fs::relative(file, pastoso::tests::source_file("")).generic_string();
        for (const std::string& violation :
             pastoso::tests::include_violations(path, pastoso::core::read_text_file(file))) {
            ADD_FAILURE() << violation;
        }
    }
}

}  // namespace
