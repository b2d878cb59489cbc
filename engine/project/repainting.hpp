// A painting painted once more from its strokes, on finer or coarser cells.
#pragma once

#include "document/painting.hpp"
#include "files/keep_going.hpp"
#include "project/project.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::project {

/// What is painted, and what should be known before.
struct Repainting {
    document::Recording strokes;       ///< on the canvas that they are painted on
    std::vector<std::string> notes{};  ///< what will be otherwise than it was, in sentences
    std::size_t memory_bytes = 0;      ///< about what it needs
};

/// The strokes on a canvas of `px_per_mm` cells a millimetre. `name` stands for them in sentences.
/// Throws InputError where there are none, and for a canvas that cannot be or needs more than
/// `available_bytes`.
Repainting repainting_of(document::Recording strokes, const std::string& name, double px_per_mm,
                         std::size_t available_bytes);

/// The painting, or nothing where `keep_going` said so. Throws InputError "NAME, event N: ..." for what
/// cannot be painted there.
std::optional<Project> repaint(const Repainting& repainting, const std::string& name,
                               core::ThreadPool& pool, const files::KeepGoing& keep_going);

/// What a recording has been played on, to be kept: a pen that is still down is lifted, since files hold
/// paintings between two strokes.
Project finished_project(document::Painting& painting, document::Recording played);

}  // namespace pastoso::project
