#include "install/installed.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace pastoso::install {

namespace fs = std::filesystem;

void Installed::install(const fs::path& prefix, const std::vector<std::string>& components) const {
    const fs::path root = folder / "root";
    std::vector<std::vector<std::string>> calls;
    for (const std::string& component : components)
        calls.push_back({"--component", component});
    if (components.empty()) calls.emplace_back();
    ::setenv("DESTDIR", root.c_str(), 1);
    for (const std::vector<std::string>& call : calls) {
        std::vector<std::string> words = {"--install", PASTOSO_BUILD, "--prefix", "/usr"};
        words.insert(words.end(), call.begin(), call.end());
        const cli::RunResult result = cli::run_program(PASTOSO_CMAKE, words);
        ASSERT_EQ(result.status, 0) << result.errors;
    }
    ::unsetenv("DESTDIR");
    fs::create_directories(prefix.parent_path());
    fs::rename(root / "usr", prefix);
    EXPECT_TRUE(fs::is_empty(root)) << "something is installed beside the prefix";
    fs::remove_all(root);
}

cli::RunResult Installed::run(const std::string& program,
                              const std::vector<std::string>& arguments) const {
    std::vector<std::string> words = {"-u",
                                      "PASTOSO_RESOURCES",
                                      "-C",
                                      folder.string(),
                                      "HOME=" + path("home"),
                                      "XDG_DATA_DIRS=" + path("moved/share") + ":/usr/share",
                                      program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return cli::run_program("/usr/bin/env", words);
}

std::set<std::string> files_below(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) files.insert(fs::relative(entry.path(), folder).string());
    return files;
}

}  // namespace pastoso::install
