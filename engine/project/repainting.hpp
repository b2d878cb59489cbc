// A painting painted once more from its strokes, on finer or coarser cells.
#pragma once

#include "core/message.hpp"
#include "document/painting.hpp"
#include "files/keep_going.hpp"
#include "project/project.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::project {

/// What painting it takes and makes.
struct RepaintingTerms {
    grid::Shape cells;                 ///< of the canvas at its end
    std::size_t memory_bytes = 0;      ///< about what it needs where it is largest, for one layer
    std::vector<core::Message> notes{};  ///< what will be otherwise; sentences that begin small
};

/// Of strokes on the canvas that they are to be painted on. `name` stands for them in sentences. Throws
/// InputError where there are none, and for a canvas that cannot be or needs more than
/// `available_bytes`.
RepaintingTerms repainting_terms(const document::Recording& strokes, const std::string& name,
                                 std::size_t available_bytes);

/// Is shown the painting after every tick.
using PaintingViewer = std::function<void(const document::Painting& painting)>;

/// The painting, or nothing where `keep_going` said so. Throws InputError "NAME, event N: ..." for what
/// cannot be painted there.
std::optional<Project> repaint(
    const document::Recording& strokes, const std::string& name, core::ThreadPool& pool,
    const files::KeepGoing& keep_going, const PaintingViewer& view = [](const document::Painting&) {});

/// What a recording has been played on, to be kept: a pen that is still down is lifted, since files hold
/// paintings between two strokes.
Project finished_project(document::Painting& painting, document::Recording played);

}  // namespace pastoso::project
