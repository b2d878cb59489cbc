#include "journal/journal_folder.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/user_data.hpp"
#include "journal/journal_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace pastoso::journal {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLockFile = "lock";
constexpr const char* kPrefix = "painting-";

/// The lock, or -1.
int locked(const fs::path& folder, int flags) {
    const int file = ::open((folder / kLockFile).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
    if (file >= 0) ::close(file);
    return -1;
}

/// Names sort by time.
std::string name_of_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &parts);
    return kPrefix + std::string(text) + "-" + std::to_string(::getpid());
}

[[noreturn]] void fail(const fs::path& path) {
    throw core::InputError(
        "%1: cannot be written (%2); what is painted now can be saved, but not recovered.",
        path.string(), std::strerror(errno));
}

void make_folders(const fs::path& root) {
    std::error_code failure;
    fs::create_directories(root, failure);
    if (!failure) return;
    errno = failure.value();
    fail(root);
}

}  // namespace

fs::path journals_path() {
    return core::user_state_path("journals");
}

Claim Claim::on_new_folder(const fs::path& root) {
    make_folders(root);
    const std::string name = name_of_now();
    for (int count = 1;; ++count) {
        const fs::path folder = root / (name + "-" + std::to_string(count));
        if (::mkdir(folder.c_str(), 0700) != 0) {
            if (errno == EEXIST) continue;
            fail(folder);
        }
        const int lock = locked(folder, O_CREAT | O_EXCL);
        // Another program may have cleared the empty folder away.
        if (lock < 0 && errno == ENOENT) continue;
        if (lock < 0) fail(folder);
        return {folder, lock};
    }
}

std::optional<Claim> Claim::on(const fs::path& folder) {
    const int lock = locked(folder, 0);
    if (lock < 0) return std::nullopt;
    return Claim{folder, lock};
}

Claim::Claim(Claim&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}

Claim& Claim::operator=(Claim&& other) noexcept {
    std::swap(folder_, other.folder_);
    std::swap(lock_, other.lock_);
    return *this;
}

Claim::~Claim() {
    if (lock_ >= 0) ::close(lock_);
}

/// The lock's file goes last: until then nobody else takes what is left for a journal of their own.
void Claim::discard() {
    std::error_code ignored;
    fs::remove(folder_ / kStrokesFile, ignored);
    for (const fs::path& entry : core::entries_of(folder_))
        if (entry.filename() != kLockFile) fs::remove_all(entry, ignored);
    fs::remove(folder_ / kLockFile, ignored);
    fs::remove(folder_, ignored);
}

std::vector<fs::path> abandoned_journals(const fs::path& root) {
    std::vector<fs::path> folders;
    std::error_code ignored;
    for (const fs::path& folder : core::entries_of(root)) {
        if (!folder.filename().string().starts_with(kPrefix)) continue;
        auto claim = Claim::on(folder);
        if (claim && core::is_there(folder / kStrokesFile))
            folders.push_back(folder);
        else if (claim)
            claim->discard();  // its program was killed before it began, or while it discarded
        else
            fs::remove(folder, ignored);  // the same, if it is empty
    }
    std::sort(folders.begin(), folders.end(), std::greater<>());
    return folders;
}

std::chrono::system_clock::time_point last_written(const fs::path& folder) {
    struct stat file {};
    if (::stat((folder / kStrokesFile).c_str(), &file) != 0) return {};
    return std::chrono::system_clock::from_time_t(file.st_mtime);
}

}  // namespace pastoso::journal
