// The paintings that journals begin with (journal::Beginning::write_start), for as long as a journal may
// be late to begin.
#pragma once

#include "project/project.hpp"

#include <filesystem>
#include <functional>
#include <memory>

namespace pastoso::main {

using WriteStart = std::function<void(const std::filesystem::path& start)>;

/// Copies a project as it is now, whatever is saved in its place meanwhile.
WriteStart copied_start(const std::filesystem::path& file);

/// Saves what stands in no project.
WriteStart saved_start(std::shared_ptr<const project::Project> project);

}  // namespace pastoso::main
