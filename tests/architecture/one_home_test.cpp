// What has one home in the code, so that what it takes care of cannot be forgotten elsewhere.
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

namespace fs = std::filesystem;

struct Rule {
    std::vector<std::string> words;
    std::set<std::string> homes;  ///< where they may stand
    const char* instead;
};

const std::vector<Rule> kRules = {
    // The second of the homes reads what the system tells.
    {{"std::ifstream", "std::fstream", "fopen(", "zip_source_file_create", "zip_source_file(",
      "ImageInput::open"},
     {"engine/core/regular_file.cpp", "engine/core/memory.cpp"},
     "files are opened to be read by core::RegularFile, which refuses what is none"},
    // A journal grows while it is kept, and a report is left by a program that fails.
    {{"std::ofstream", "O_CREAT", "::rename(", "QSaveFile"},
     {"engine/core/output_file.cpp", "engine/journal/journal_writer.cpp", "engine/journal/journal_folder.cpp",
      "app/crash/crash_guard.cpp", "app/crash/crash_reports.cpp"},
     "files are written by core::OutputFile, which hears of every failure"},
    {{"filesystem::exists(", "filesystem::is_directory(", "filesystem::is_regular_file(",
      "filesystem::absolute(", "directory_iterator(", "fs::exists(", "fs::is_directory(",
      "fs::is_regular_file(", "fs::absolute("},
     {"engine/core/looking.cpp"},
     "core/looking.hpp asks the same and throws nothing"},
    {{".add_option("},
     {"app/cli/option.cpp", "app/cli/option.hpp", "app/main/arguments.cpp"},
     "cli/option.hpp adds options with the values they may be given"},
    {{"std::printf(", "std::puts(", ", stdout)", "std::cout <<"},
     {"app/cli/printing.cpp", "app/main/main.cpp"},
     "cli/printing.hpp prints so that no text commands a terminal"},
    // Their result depends on the locale of the process.
    {{"strtod(", "strtof(", "std::stod(", "std::stof(", "atof(", "std::setlocale("},
     {"app/main/program/application.cpp"},
     "numbers are read by std::from_chars() and written by core::number_text()"},
};

std::string code_of(const std::string& line) {
    return line.substr(0, line.find("//"));
}

void check_file(const fs::path& file, const std::string& path) {
    std::istringstream lines(core::read_text_file(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        for (const Rule& rule : kRules)
            for (const std::string& word : rule.words)
                EXPECT_FALSE(code_of(line).find(word) != std::string::npos &&
                             rule.homes.count(path) == 0)
                    << path << ":" << number << ": " << word << ": " << rule.instead;
    }
}

TEST(OneHome, OfReadingWritingLookingAndPrinting) {
    int files = 0;
    for (const char* part : {"engine", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(source_file(part))) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".cpp" && ending != ".hpp") continue;
            check_file(entry.path(), fs::relative(entry.path(), source_file("")).generic_string());
            ++files;
        }
    }
    EXPECT_GT(files, 20);
}

}  // namespace
}  // namespace pastoso::tests
