#include "core/output_file.hpp"

#include "core/disk.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace pastoso::core {
namespace {

using Path = std::filesystem::path;

/// As many as Linux follows.
constexpr int kMostLinks = 40;

/// In bytes, as names have an end. A longer extension is no file format's.
constexpr std::size_t kMostStem = 100, kMostExtension = 16;

/// In bytes. Libraries write a few at a time.
constexpr std::size_t kMostWaiting = std::size_t{1} << 16;

constexpr mode_t kRights = 0777, kNewRights = 0666, kAnyMayWrite = 0222;

[[noreturn]] void refuse_writing(const Path& path, const Message& why) {
    throw InputError("%1: cannot be written (%2).", path.string(), why);
}

/// What the user can do where the system's own words leave that open.
Message words_of(int reason) {
    if (reason == ENOSPC) return message("the disk is full; make room on it, or choose another place");
    if (reason == EDQUOT)
        return message("your share of the disk is used up; make room on it, or choose another place");
    return Message::verbatim(std::strerror(reason));
}

/// Where a link leads, though there may be no file yet.
Path followed(const Path& path) {
    Path target = path;
    for (int link = 0; link < kMostLinks; ++link) {
        std::error_code no_link;
        const Path next = std::filesystem::read_symlink(target, no_link);
        if (no_link) return target;
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    refuse_writing(path, words_of(ELOOP));
}

/// The file at `target`, if there is one.
bool stands(const Path& target, struct stat& status) {
    return ::stat(target.c_str(), &status) == 0;
}

/// Root may write what nobody may; it is protected all the same.
bool is_protected(const Path& target, const struct stat& status) {
    return (status.st_mode & kAnyMayWrite) == 0 ||
           (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0 && errno == EACCES);
}

void check_replaceable(const Path& path, const Path& target, Replaced replaced) {
    struct stat status {};
    if (!stands(target, status)) {
        if (errno != ENOENT) refuse_writing(path, words_of(errno));
        return;
    }
    if (replaced == Replaced::None) refuse_writing(path, words_of(EEXIST));
    if (!S_ISREG(status.st_mode))
        throw InputError("%1: is %2, not a file.", path.string(), kind_of_file(status.st_mode));
    if (replaced == Replaced::Writable && is_protected(target, status))
        throw InputError("%1: is write-protected; allow writing to it, or choose another name.",
                         path.string());
}

Path folder_of(const Path& file) {
    return file.has_parent_path() ? file.parent_path() : Path(".");
}

/// The beginning of a name, up to a whole character of UTF-8.
std::string shortened(std::string stem) {
    std::size_t end = std::min(stem.size(), kMostStem);
    while (end > 0 && end < stem.size() && (stem[end] & 0xC0) == 0x80)
        --end;
    stem.resize(end);
    return stem;
}

/// No other file of this process has it; the extension stays for programs that go by it.
Path part_name(const Path& target) {
    static std::atomic<unsigned> count = 0;
    const std::string extension = target.extension().string();
    return folder_of(target) /
           ("." + shortened(target.stem().string()) + "-" + std::to_string(::getpid()) + "-" +
            std::to_string(++count) + ".part" + (extension.size() <= kMostExtension ? extension : ""));
}

}  // namespace

OutputFile::OutputFile(Path path, Replaced replaced)
    : path_(std::move(path)), replaced_(replaced), target_(followed(path_)) {
    check_replaceable(path_, target_, replaced);
    waiting_.reserve(kMostWaiting);
    create_part();
    take_over_rights();
}

OutputFile::~OutputFile() {
    if (file_ >= 0) ::close(file_);
    if (!part_.empty()) ::unlink(part_.c_str());
}

/// A name may be taken by what a process of the same number left when it was killed.
void OutputFile::create_part() {
    struct stat old {};
    const mode_t rights = stands(target_, old) ? old.st_mode & kRights : kNewRights;
    do {
        part_ = part_name(target_);
        file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, rights);
    } while (file_ < 0 && errno == EEXIST);
    if (file_ >= 0) return;
    const int reason = errno;
    part_.clear();
    refuse(reason);
}

/// The owner is kept where that is allowed, which it is to root alone, else the group. Rights come last:
/// a change of owner may take some. Disks that know no owners and rights refuse; there nothing is lost
/// by it.
void OutputFile::take_over_rights() {
    struct stat old {};
    if (!stands(target_, old)) return;
    if (::fchown(file_, old.st_uid, old.st_gid) != 0)
        (void)!::fchown(file_, static_cast<uid_t>(-1), old.st_gid);
    (void)!::fchmod(file_, old.st_mode & kRights);
}

void OutputFile::refuse(int reason) const {
    refuse_writing(path_, words_of(reason));
}

void OutputFile::write_at(std::uint64_t place, std::span<const std::byte> bytes) noexcept {
    end_ = std::max(end_, place + bytes.size());
    const bool follows = place == waiting_place_ + waiting_.size();
    if (!follows || waiting_.size() + bytes.size() > kMostWaiting) write_waiting();
    if (bytes.size() > kMostWaiting) return write_now(place, bytes);
    if (waiting_.empty()) waiting_place_ = place;
    waiting_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void OutputFile::write_waiting() noexcept {
    write_now(waiting_place_, std::as_bytes(std::span(waiting_)));
    waiting_.clear();
}

void OutputFile::write_now(std::uint64_t place, std::span<const std::byte> bytes) noexcept {
    if (reason_ == 0 && !write_all(file_, bytes, place)) reason_ = errno;
}

void OutputFile::check() const {
    if (reason_ != 0) refuse(reason_);
}

void OutputFile::put_in_place() {
    write_waiting();
    check();
    if (::fsync(file_) != 0) refuse(errno);
    if (::close(std::exchange(file_, -1)) != 0) refuse(errno);
    if (!take_place()) refuse(errno);
    part_.clear();
    flush_folder();
}

/// False: it could not, and errno says why. Disks that cannot rename without replacing are left with a
/// moment between the look and the rename.
bool OutputFile::take_place() const {
    if (replaced_ != Replaced::None) return ::rename(part_.c_str(), target_.c_str()) == 0;
    if (::renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0)
        return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    struct stat status {};
    if (stands(target_, status)) {
        errno = EEXIST;
        return false;
    }
    return ::rename(part_.c_str(), target_.c_str()) == 0;
}

/// Some network drives cannot flush a folder, and some folders cannot be opened: the file stands there
/// nevertheless.
void OutputFile::flush_folder() const {
    const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    const int reason = ::fsync(folder) == 0 ? 0 : errno;
    ::close(folder);
    if (reason == EIO || says_full(reason))
        throw InputError("%1: is written, but may be lost in a power cut (%2).", path_.string(),
                         std::strerror(reason));
}

bool is_write_protected(const Path& path) {
    struct stat status {};
    return stands(path, status) && S_ISREG(status.st_mode) && is_protected(path, status);
}

bool write_aside_unless(const Path& path, const std::function<bool(OutputFile&)>& write) {
    OutputFile file(path);
    if (!write(file)) return false;
    file.put_in_place();
    return true;
}

void write_aside(const Path& path, const std::function<void(OutputFile&)>& write, Replaced replaced) {
    OutputFile file(path, replaced);
    write(file);
    file.put_in_place();
}

}  // namespace pastoso::core
