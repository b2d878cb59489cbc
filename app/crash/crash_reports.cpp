#include "crash/crash_reports.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "core/user_data.hpp"

#include <algorithm>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <regex>
#include <vector>

namespace pastoso::crash {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKept = 5, kMostBytes = 1 << 20;
const char* const kTaken = ".seen";

std::string demangled(const std::string& name) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> words(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
    return status == 0 ? words.get() : name;
}

/// "pastoso(_ZN4film4stepEv+0x12)" -> "pastoso(film::step()+0x12)"
std::string with_names(const std::string& text) {
    static const std::regex kName("_Z[A-Za-z0-9_.]+");
    std::string result;
    auto rest = text.cbegin();
    for (std::sregex_iterator found(text.begin(), text.end(), kName), end; found != end; ++found) {
        result.append(rest, (*found)[0].first);
        result += demangled(found->str());
        rest = (*found)[0].second;
    }
    return result.append(rest, text.cend());
}

void mark_taken(const std::vector<fs::path>& reports) {
    std::error_code ignored;
    for (const fs::path& report : reports)
        fs::rename(report, fs::path(report).concat(kTaken), ignored);
}

void drop_old(const fs::path& folder) {
    const std::vector<fs::path> taken = core::files_in(folder, kTaken);
    std::error_code ignored;
    for (std::size_t i = 0; i + kKept < taken.size(); ++i)
        fs::remove(taken[i], ignored);
}

}  // namespace

fs::path reports_folder() {
    return core::user_state_path("crashes");
}

std::optional<Report> take_report(const fs::path& folder) {
    const std::vector<fs::path> reports = core::files_in(folder, ".txt");
    if (reports.empty()) return std::nullopt;
    std::optional<Report> latest;
    try {
        latest = Report{fs::path(reports.back()).concat(kTaken),
                        with_names(core::read_text_file(reports.back(), kMostBytes))};
    } catch (const core::InputError&) {
        latest.reset();
    }
    mark_taken(reports);
    drop_old(folder);
    return latest;
}

}  // namespace pastoso::crash
