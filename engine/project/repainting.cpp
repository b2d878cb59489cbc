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

bool puts_a_picture_on(const document::Action& action) {
    const auto* texture = std::get_if<document::LayTexture>(&action);
    return std::holds_alternative<document::PaintPicture>(action) ||
           (texture != nullptr && std::holds_alternative<layers::PressedTexture>(texture->texture));
}

bool brings_paint(const document::Action& action) {
    return std::holds_alternative<document::BringPaint>(action);
}

bool holds_any(const document::Recording& strokes, bool (*is_such)(const document::Action& action)) {
    return std::any_of(strokes.events.begin(), strokes.events.end(),
                       [&](const document::Event& event) { return is_such(event.action); });
}

std::vector<core::Message> notes_of(const document::Recording& strokes) {
    std::vector<core::Message> notes;
    const core::Message older = document::arithmetic_note(strokes.arithmetic);
    if (!older.empty()) notes.push_back(core::message("its strokes %1", older));
    if (holds_any(strokes, &puts_a_picture_on))
        notes.push_back(core::message("a picture on it has no strokes, and comes no finer than it is."));
    if (holds_any(strokes, &brings_paint))
        notes.push_back(
            core::message("paint that was copied in another painting has no strokes here, and comes no "
                          "finer than it is."));
    if (strokes.canvas.support == "image")
        notes.push_back(core::message("its support is a picture, and comes no finer than that."));
    return notes;
}

document::CanvasSettings after(const document::Action& action, const document::CanvasSettings& canvas) {
    if (const auto* resize = std::get_if<document::ResizeCanvas>(&action))
        return document::resized(*resize, canvas);
    if (const auto* turn = std::get_if<document::TurnCanvas>(&action))
        return document::turned(turn->turn, canvas);
    if (const auto* scale = std::get_if<document::ScaleCanvas>(&action))
        return document::scaled(*scale, canvas);
    if (const auto* rotate = std::get_if<document::RotateCanvas>(&action))
        return document::rotated(*rotate, canvas);
    return canvas;
}

/// The one that it begins on, and those that it comes to have one after another, some of them again
/// where changes were undone.
std::vector<document::CanvasSettings> canvases_of(const document::Recording& strokes) {
    using document::UndoRole;
    std::vector<document::CanvasSettings> canvases{strokes.canvas}, after_step{strokes.canvas};
    std::size_t step = 0;
    for (const document::Event& event : strokes.events) {
        const UndoRole role = document::undo_role(event.action);
        if (role == UndoRole::Undo && step > 0) --step;
        if (role == UndoRole::Redo && step + 1 < after_step.size()) ++step;
        if (role == UndoRole::Step || role == UndoRole::MaybeStep) {
            after_step.resize(step + 1);
            after_step.push_back(after(event.action, after_step[step]));
            ++step;
        }
        if (after_step[step] != canvases.back()) canvases.push_back(after_step[step]);
    }
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
