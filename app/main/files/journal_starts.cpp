#include "main/files/journal_starts.hpp"

#include "core/error.hpp"
#include "core/thread_pool.hpp"

#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace pastoso::main {
namespace {

/// A file that stays open, and what it holds readable, when its name goes to another one.
class OpenFile {
  public:
    explicit OpenFile(const std::filesystem::path& path)
        : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~OpenFile() {
        if (number_ >= 0) ::close(number_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

  private:
    int number_;
};

}  // namespace

WriteStart copied_start(const std::filesystem::path& file) {
    return [source = std::make_shared<const OpenFile>(file)](const std::filesystem::path& start) {
        std::error_code failure;
        std::filesystem::copy_file(source->path(), start, failure);
        if (failure)
            throw core::InputError("%1: cannot be written (%2).", start.string(), failure.message());
    };
}

WriteStart saved_start(std::shared_ptr<const project::Project> project) {
    return [project = std::move(project)](const std::filesystem::path& start) {
        core::ThreadPool pool;
        project::save_project(start, *project, pool);
    };
}

}  // namespace pastoso::main
