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

std::vector<std::string> notes_of(const document::Recording& strokes, const std::string& name) {
    std::vector<std::string> notes;
    const std::string older = document::arithmetic_note(strokes.arithmetic);
    if (!older.empty()) notes.push_back(name + ": its strokes " + older);
    if (holds<document::PaintPicture>(strokes))
        notes.push_back(name + ": holds a picture, which has no strokes: it comes no finer than it is.");
    if (strokes.canvas.support == "image")
        notes.push_back(name + ": its support is a picture, and comes no finer than that.");
    return notes;
}

}  // namespace

Repainting repainting_of(document::Recording strokes, const std::string& name, double px_per_mm,
                         std::size_t available_bytes) {
    if (strokes.events.empty())
        throw core::InputError(name + ": holds no strokes that could be painted again.");
    strokes.canvas.px_per_mm = px_per_mm;
    core::naming(name, [&] { document::check_canvas_fits(strokes.canvas, available_bytes); });
    Repainting repainting{std::move(strokes)};
    repainting.notes = notes_of(repainting.strokes, name);
    repainting.memory_bytes =
        document::estimated_bytes(document::canvas_shape(repainting.strokes.canvas));
    return repainting;
}

std::optional<Project> repaint(const Repainting& repainting, const std::string& name,
                               core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    const document::Recording& strokes = repainting.strokes;
    const std::unique_ptr<document::Painting> painting =
        core::naming(name, [&] { return recordings::make_painting(strokes.canvas, pool); });
    painting->keep_undo_steps(document::undo_depth(strokes));
    document::Player player(*painting, strokes);
    while (!player.finished()) {
        if (!keep_going(player.progress())) return std::nullopt;
        try {
            player.play_tick();
        } catch (const core::InputError& error) {
            throw core::InputError(name + ", " + error.what());
        }
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
