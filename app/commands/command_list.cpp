#include "commands/command_list.hpp"

#include <array>

namespace pastoso::commands {
namespace {

constexpr std::array kCommands = {
    CommandText{Command::NewCanvas, "&File", "&New canvas...", "Ctrl+N",
                "Put a fresh canvas on the easel"},
    CommandText{Command::SavePicture, "&File", "&Save picture...", "Ctrl+S",
                "Save what the canvas looks like as an image", false, true},
    CommandText{Command::SaveRecording, "&File", "Save &recording...", "Ctrl+Shift+S",
                "Save all strokes, to be replayed at any resolution"},
    CommandText{Command::Quit, "&File", "&Quit", "Ctrl+Q", "Close the window", false, true},
    CommandText{Command::Undo, "&Edit", "&Undo", "Ctrl+Z", "Take the last stroke back"},
    CommandText{Command::Redo, "&Edit", "&Redo", "Ctrl+Shift+Z; Ctrl+Y", "Put the last stroke back"},
    CommandText{Command::SmallerBrush, "&Brush", "&Narrower", "[", "A narrower brush"},
    CommandText{Command::LargerBrush, "&Brush", "&Wider", "]", "A wider brush"},
    CommandText{Command::NextBrush, "&Brush", "Next &brush", "B", "Take the next brush of the list",
                false, true},
    CommandText{Command::PreviousBrush, "&Brush", "&Previous brush", "Shift+B",
                "Take the brush before in the list"},
    CommandText{Command::ReloadBrush, "&Brush", "&Reload", "R",
                "Clean the brush and fill it with the paint", false, true},
    CommandText{Command::CleanBrush, "&Brush", "&Clean", "C",
                "Wipe the brush: an empty one moves the paint that lies there"},
    CommandText{Command::ReloadEachStroke, "&Brush", "Reload before &each stroke", "Shift+R",
                "Every stroke starts with a clean, full brush", true},
    CommandText{Command::TurnWithStroke, "&Brush", "&Turn with the stroke", "T",
                "Flat brushes stand across their path, where the pen does not tell its rotation", true},
    CommandText{Command::Pause, "&Paint", "&Pause the paint", "P",
                "Wet paint stands still until you go on", true},
    CommandText{Command::DryNow, "&Paint", "&Dry now", "D",
                "All wet paint dries at once: paint over it without stirring it up"},
    CommandText{Command::MixingWell, "&Paint", "Mixing &well", "W",
                "A palette of wet paint: mix there with any tool, and carry it to the canvas", true,
                true},
    CommandText{Command::SqueezePaint, "&Paint", "&Squeeze onto the well", "S",
                "Squeeze the paint that you chose onto the mixing well; Control and click says where"},
    CommandText{Command::CleanWell, "&Paint", "&Clean the well", "Shift+W", "Wipe the mixing well bare"},
    CommandText{Command::MirrorSymmetry, "&Guides", "&Mirror", "Shift+M",
                "Every stroke is painted on both sides of the canvas's middle line", true},
    CommandText{Command::MoreCopies, "&Guides", "M&ore copies around the middle", ".",
                "Every stroke is painted once more around the middle of the canvas"},
    CommandText{Command::FewerCopies, "&Guides", "&Fewer copies around the middle", ",",
                "Every stroke is painted once less around the middle of the canvas"},
    CommandText{Command::Ruler, "&Guides", "&Ruler along the last stroke", "G",
                "Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line",
                true, true},
    CommandText{Command::FitCanvas, "&View", "&Fit the canvas", "Ctrl+0", "Show the whole canvas"},
    CommandText{Command::ActualPixels, "&View", "&Actual pixels", "1",
                "One screen pixel for every pixel of the saved picture"},
    CommandText{Command::ZoomIn, "&View", "Zoom &in", "Ctrl++; Ctrl+=", "Closer", false, true},
    CommandText{Command::ZoomOut, "&View", "Zoom &out", "Ctrl+-", "Farther"},
};

}  // namespace

std::span<const CommandText> command_list() {
    return kCommands;
}

}  // namespace pastoso::commands
