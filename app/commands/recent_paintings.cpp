#include "commands/recent_paintings.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/text_file.hpp"
#include "core/user_data.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <system_error>

namespace pastoso::commands {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;

std::filesystem::path list_path() {
    return core::user_data_path("recent-paintings");
}

/// A list for convenience, and no reason to disturb anybody where it cannot be kept.
void write_list(const std::vector<std::filesystem::path>& paintings) {
    std::string text;
    for (const std::filesystem::path& painting : paintings)
        text += painting.string() + "\n";
    try {
        std::error_code ignored;
        std::filesystem::create_directories(list_path().parent_path(), ignored);
        core::write_text_file(list_path(), text);
    } catch (const core::InputError&) {
        return;
    }
}

}  // namespace

std::vector<std::filesystem::path> known_paintings() {
    std::vector<std::filesystem::path> paintings;
    try {
        std::istringstream lines(core::read_text_file(list_path(), kMostBytes));
        for (std::string line; std::getline(lines, line) && paintings.size() < kMostRecent;)
            if (!line.empty()) paintings.emplace_back(line);
    } catch (const core::InputError&) {
        paintings.clear();
    }
    return paintings;
}

std::vector<std::filesystem::path> recent_paintings() {
    std::vector<std::filesystem::path> paintings = known_paintings();
    std::erase_if(paintings, [](const std::filesystem::path& painting) {
        return !core::is_regular_file(painting);
    });
    return paintings;
}

void remember_painting(const std::filesystem::path& path) {
    if (list_path().empty()) return;
    const std::filesystem::path whole = core::absolute_path(path);
    std::vector<std::filesystem::path> paintings = known_paintings();
    std::erase(paintings, whole);
    paintings.insert(paintings.begin(), whole);
    write_list(paintings);
}

void forget_painting(const std::filesystem::path& path) {
    if (list_path().empty()) return;
    std::vector<std::filesystem::path> paintings = known_paintings();
    std::erase(paintings, path);
    write_list(paintings);
}

}  // namespace pastoso::commands
