// Locales with other numbers and letters than C, built for a test, so that none need be installed.
#pragma once

#include "core/temporary_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

namespace pastoso::tests {

/// German, with a comma in its numbers, and Turkish, whose i is another letter; LOCPATH leads to them
/// for as long as this lives. Needs the package locales. They sort as POSIX does: the tables of real
/// sorting take most of the time that a locale takes to build, and no file or output is sorted by them.
class LocaleFolder {
  public:
    LocaleFolder() {
        for (const char* language : {"de_DE", "tr_TR"}) {
            const std::string locale = (folder_.path() / language).string() + ".UTF-8";
            const std::string source = locale + ".source";
            write_source(source, language);
            const std::string command = "localedef -i '" + source + "' -f UTF-8 '" + locale + "'";
            is_whole_ = std::system(command.c_str()) == 0 && is_whole_;
        }
        ::setenv("LOCPATH", folder_.path().c_str(), 1);
    }
    ~LocaleFolder() { ::unsetenv("LOCPATH"); }
    LocaleFolder(const LocaleFolder&) = delete;
    LocaleFolder& operator=(const LocaleFolder&) = delete;

    bool is_whole() const { return is_whole_; }
    std::string path() const { return folder_.path().string(); }

    static constexpr const char* kNames[] = {"de_DE.UTF-8", "tr_TR.UTF-8"};

  private:
    static void write_source(const std::string& file, const char* language) {
        std::ofstream source(file);
        for (const std::string category :
             {"CTYPE", "COLLATE", "MONETARY", "NUMERIC", "TIME", "MESSAGES", "PAPER", "NAME", "ADDRESS",
              "TELEPHONE", "MEASUREMENT", "IDENTIFICATION"})
            source << "LC_" << category << "\ncopy \"" << (category == "COLLATE" ? "POSIX" : language)
                   << "\"\nEND LC_" << category << '\n';
    }

    TemporaryFolder folder_;
    bool is_whole_ = true;
};

}  // namespace pastoso::tests
