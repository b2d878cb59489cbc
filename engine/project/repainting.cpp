#include "project/repainting.hpp"

#include "core/error.hpp"
#include "core/naming.hpp"
#include "document/canvas.hpp"
#include "document/player.hpp"
#include "recordings/canvas_support.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace pastoso::project {
namespace {

template <class Kind>
bool holds(const document::Recording& strokes) {
    return std::any_of(strokes.events.begin(), strokes.events.end(), [](const document::Event& event) {
        return std::holds_alternative<Kind>(event.action);
    });
}

std::vector<core::Message> notes_of(const document::Recording& strokes) {
    std::vector<core::Message> notes;
    const core::Message older = document::arithmetic_note(strokes.arithmetic);
    if (!older.empty()) notes.push_back(core::message("its strokes %1", older));
    if (holds<document::PaintPicture>(strokes))
        notes.push_back(core::message("a picture on it has no strokes, and comes no finer than it is."));
    if (strokes.canvas.support == "image")
        notes.push_back(core::message("its support is a picture, and comes no finer than that."));
    return notes;
}

/// The one that it begins on, and what changes of its size make of it.
std::vector<document::CanvasSettings> canvases_of(const document::Recording& strokes) {
    std::vector<document::CanvasSettings> canvases{strokes.canvas};
    for (const document::Event& event : strokes.events)
        if (const auto* resize = std::get_if<document::ResizeCanvas>(&event.action))
            canvases.push_back(document::resized(*resize, canvases.back()));
    return canvases;
}

}  // namespace

RepaintingTerms repainting_terms(const document::Recording& strokes, const std::string& name,
                                 std::size_t available_bytes) {
    if (strokes.events.empty())
        throw core::InputError("%1: holds no strokes that could be painted again.", name);
    RepaintingTerms terms;
    terms.notes = notes_of(strokes);
    for (const document::CanvasSettings& canvas : canvases_of(strokes)) {
        core::naming(name, [&] { document::check_canvas_fits(canvas, available_bytes); });
        terms.cells = document::canvas_shape(canvas);
        terms.memory_bytes = std::max(terms.memory_bytes, document::estimated_bytes(terms.cells));
    }
    return terms;
}

std::optional<Project> repaint(const document::Recording& strokes, const std::string& name,
                               core::ThreadPool& pool, const files::KeepGoing& keep_going,
                               const PaintingViewer& view) {
    const std::unique_ptr<document::Painting> painting =
        core::naming(name, [&] { return recordings::make_painting(strokes.canvas, pool); });
    painting->keep_undo_steps(document::undo_depth(strokes));
    document::Player player(*painting, strokes, name);
    while (!player.finished()) {
        if (!keep_going(player.progress())) return std::nullopt;
        player.play_tick();
        view(*painting);
    }
    return finished_project(*painting, strokes);
}

Project finished_project(document::Painting& painting, document::Recording played) {
    if (painting.stroke_in_progress()) {
        painting.apply(document::PenUp{});
        played.events.push_back({painting.tick(), document::PenUp{}});
    }
    played.arithmetic = document::kArithmetic;
    return {painting.state(), std::move(played)};
}

}  // namespace pastoso::project
