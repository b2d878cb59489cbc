// Libraries are linked to what they need alone: a painting is saved without what liquids take.
#include "architecture/architecture_page.hpp"
#include "architecture/link_closures.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

using Closures = std::map<std::string, std::set<std::string>, std::less<>>;

Closures closures() {
    Closures result;
    std::istringstream lines{link_closures_text()};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string folder;
        words >> folder;
        folder.pop_back();
        for (std::string name; words >> name;)
            result[folder].insert(name);
    }
    return result;
}

constexpr const char* kEmbree = "embree";
constexpr const char* kFftw = "PkgConfig::Fftw3f";

/// Otherwise a library that CMake calls by another name would pass unseen.
TEST(LinkClosure, NamesTheLibrariesOfLiquids) {
    const Closures all = closures();
    EXPECT_TRUE(all.at("trace").contains(kEmbree));
    EXPECT_TRUE(all.at("trace").contains(kFftw));
    EXPECT_TRUE(all.at("liquid_files").contains(kEmbree));
    EXPECT_TRUE(all.at("liquid_files").contains(kFftw));
}

TEST(LinkClosure, PaintingsAreKeptWithoutThem) {
    const Closures all = closures();
    for (const char* folder : {"files", "recordings", "project", "journal"}) {
        std::printf("%s:", folder);
        for (const std::string& name : all.at(folder))
            std::printf(" %s", name.c_str());
        std::printf("\n");
        EXPECT_FALSE(all.at(folder).contains(kEmbree)) << folder;
        EXPECT_FALSE(all.at(folder).contains(kFftw)) << folder;
    }
}

TEST(LinkClosure, HoldsWhatTheRowsAllow) {
    const ArchitecturePage page =
        read_architecture_page(core::read_text_file(source_file("ARCHITECTURE.md")));
    const Closures all = closures();
    for (const auto& [folder, row] : page.folders) {
        if (!row.path.starts_with("engine/")) continue;
        ASSERT_TRUE(all.contains(folder)) << folder;
        for (const std::string& name : all.at(folder)) {
            if (!name.starts_with("pastoso_") || name == "pastoso_options") continue;
            const std::string used = name.substr(std::string("pastoso_").size());
            EXPECT_TRUE(used == folder || row.may_use.contains(used))
                << folder << " is linked to " << used;
        }
    }
}

}  // namespace
}  // namespace pastoso::tests
