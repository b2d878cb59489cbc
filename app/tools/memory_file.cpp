#include "tools/memory_file.hpp"

#include "core/looking.hpp"
#include "core/text_file.hpp"

namespace pastoso::tools {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 20;

}  // namespace

void read_memory(const std::filesystem::path& file, int version,
                 const std::function<void(const files::JsonPlace& root)>& read) {
    if (!core::is_there(file)) return;
    const std::string name = file.string();
    const files::Json json = files::parse_json(core::read_text_file(file, kMostBytes), name);
    const files::JsonPlace root(json, name);
    root.entry("version").integer(version, version);
    read(root);
}

files::Json memory_in(const std::filesystem::path& file) {
    try {
        if (!core::is_there(file)) return {};
        return files::parse_json(core::read_text_file(file, kMostBytes), file.string());
    } catch (const core::InputError&) {
        return {};  // whoever reads it tells the painter
    }
}

void write_memory(const files::Json& root, const std::filesystem::path& file) {
    std::error_code failure;
    std::filesystem::create_directories(file.parent_path(), failure);
    if (failure)
        throw core::InputError("Cannot make the folder %1: %2.", file.parent_path().string(),
                               failure.message());
    core::write_text_file(file, root.dump(1, '\t', false, files::Json::error_handler_t::replace) + "\n");
}

}  // namespace pastoso::tools
