#include "commands/recent_paintings.hpp"

#include "core/error.hpp"
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

}  // namespace

std::vector<std::filesystem::path> recent_paintings() {
    std::vector<std::filesystem::path> paintings;
    try {
        std::istringstream lines(core::read_text_file(list_path(), kMostBytes));
        std::error_code ignored;
        for (std::string line; std::getline(lines, line) && paintings.size() < kMostRecent;)
            if (std::filesystem::is_regular_file(line, ignored)) paintings.emplace_back(line);
    } catch (const core::InputError&) {
        paintings.clear();
    }
    return paintings;
}

void remember_painting(const std::filesystem::path& path) {
    if (list_path().empty()) return;
    const std::filesystem::path whole = std::filesystem::absolute(path);
    std::string text = whole.string() + "\n";
    for (const std::filesystem::path& painting : recent_paintings())
        if (painting != whole) text += painting.string() + "\n";
    try {
        std::error_code ignored;
        std::filesystem::create_directories(list_path().parent_path(), ignored);
        core::write_text_file(list_path(), text);
    } catch (const core::InputError&) {
        return;  // a list for convenience, and no reason to disturb anybody
    }
}

}  // namespace pastoso::commands
