// Where journals lie, and whose they are.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::journal {

/// The folder of all journals of this user, whether it exists or not (core::user_state_path()); empty
/// where there is no home.
std::filesystem::path journals_path();

/// A journal's folder in this program's hands. Ends with the program, however it ends: the system
/// itself releases the lock.
class Claim {
  public:
    /// Makes a new folder in `root`, which is made too. Throws InputError where that cannot be.
    static Claim on_new_folder(const std::filesystem::path& root);

    /// None while another program, or another claim of this one, holds it, or where it is gone.
    static std::optional<Claim> on(const std::filesystem::path& folder);

    Claim(Claim&& other) noexcept;
    Claim& operator=(Claim&& other) noexcept;
    ~Claim();

    const std::filesystem::path& folder() const { return folder_; }

    /// Removes the folder with everything in it.
    void discard();

  private:
    Claim(std::filesystem::path folder, int lock) : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_ = -1;
};

/// The folders of journals in `root` that nobody holds, the latest first.
std::vector<std::filesystem::path> abandoned_journals(const std::filesystem::path& root);

/// When something was last written to it.
std::chrono::system_clock::time_point last_written(const std::filesystem::path& folder);

}  // namespace pastoso::journal
