#include "commands/command_list.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <iterator>

#include <QtGlobal>

namespace pastoso::commands {
namespace {

constexpr const char* kFile = QT_TR_NOOP("&File");
constexpr const char* kEdit = QT_TR_NOOP("&Edit");
constexpr const char* kBrush = QT_TR_NOOP("&Brush");
constexpr const char* kPaint = QT_TR_NOOP("&Paint");
constexpr const char* kLayer = QT_TR_NOOP("&Layer");
constexpr const char* kSelect = QT_TR_NOOP("&Select");
constexpr const char* kGuides = QT_TR_NOOP("&Guides");
constexpr const char* kView = QT_TR_NOOP("&View");
constexpr const char* kLight = QT_TR_NOOP("&Light");
constexpr const char* kSettings = QT_TR_NOOP("&Settings");

constexpr CommandText kCommands[] = {
    CommandText{Command::NewCanvas, kFile, QT_TR_NOOP("&New canvas..."), "Ctrl+N",
                QT_TR_NOOP("Put a fresh canvas on the easel")},
    CommandText{Command::OpenPainting, kFile, QT_TR_NOOP("&Open..."), "Ctrl+O",
                QT_TR_NOOP("Go on with a painting that was saved, wet as it was")},
    CommandText{Command::StartPage, kFile, QT_TR_NOOP("Start &page"), "",
                QT_TR_NOOP("New canvases, recent paintings and examples at a glance")},
    CommandText{Command::SavePainting, kFile, QT_TR_NOOP("&Save"), "Ctrl+S",
                QT_TR_NOOP("Save the painting with all its wet paint"), false, true},
    CommandText{Command::SavePaintingAs, kFile, QT_TR_NOOP("Save &as..."), "Ctrl+Shift+S",
                QT_TR_NOOP("Save the painting in another file")},
    CommandText{
        Command::Export, kFile, QT_TR_NOOP("&Export..."), "Ctrl+Alt+E",
        QT_TR_NOOP("Make a picture, layers, maps, a relief to print or a time-lapse of the painting"),
        false, true},
    CommandText{Command::ExportAgain, kFile, QT_TR_NOOP("Export a&gain"), "Ctrl+Alt+R",
                QT_TR_NOOP("The same export of the painting as it is now, into the same file")},
    CommandText{Command::StopExport, kFile, QT_TR_NOOP("S&top the export"), "Ctrl+.",
                QT_TR_NOOP("Give up the export that is being written; its file stays as it was")},
    CommandText{Command::SaveRecording, kFile, QT_TR_NOOP("Export &recording..."), "Ctrl+Alt+Shift+E",
                QT_TR_NOOP("Save all strokes, to be replayed at any resolution")},
    CommandText{
        Command::Play, kFile, QT_TR_NOOP("&Watch it grow..."), "Ctrl+Alt+P",
        QT_TR_NOOP(
            "See how the painting came about, in a window of its own; the painting stays as it is")},
    CommandText{Command::MakeTimelapse, kFile, QT_TR_NOOP("&Make a time-lapse..."), "Ctrl+Alt+L",
                QT_TR_NOOP("A film, or numbered pictures, of how the painting came about")},
    CommandText{Command::Quit, kFile, QT_TR_NOOP("&Quit"), "Ctrl+Q", QT_TR_NOOP("Close the window"),
                false, true},
    CommandText{Command::Undo, kEdit, QT_TR_NOOP("&Undo"), "Ctrl+Z",
                QT_TR_NOOP("Take the last stroke back")},
    CommandText{Command::Redo, kEdit, QT_TR_NOOP("&Redo"), "Ctrl+Shift+Z; Ctrl+Y",
                QT_TR_NOOP("Put the last stroke back")},
    CommandText{Command::UndoMemory, kEdit, QT_TR_NOOP("&Memory for undo..."), "Ctrl+Alt+U",
                QT_TR_NOOP("How much memory the steps may take that you can return to")},
    CommandText{Command::CanvasSize, kEdit, QT_TR_NOOP("&Canvas size..."), "Ctrl+Alt+C",
                QT_TR_NOOP("Make the canvas larger, or cut it, on any side"), false, true},
    CommandText{Command::CropToSelection, kEdit, QT_TR_NOOP("Crop to the &selection"), "",
                QT_TR_NOOP("Cut the canvas to the smallest one that holds what is selected")},
    CommandText{Command::SmallerBrush, kBrush, QT_TR_NOOP("&Narrower"), "[",
                QT_TR_NOOP("A narrower brush")},
    CommandText{Command::LargerBrush, kBrush, QT_TR_NOOP("&Wider"), "]", QT_TR_NOOP("A wider brush")},
    CommandText{Command::NextBrush, kBrush, QT_TR_NOOP("Next &brush"), "B",
                QT_TR_NOOP("Take the next brush of the list"), false, true},
    CommandText{Command::PreviousBrush, kBrush, QT_TR_NOOP("&Previous brush"), "Shift+B",
                QT_TR_NOOP("Take the brush before in the list")},
    CommandText{Command::ReloadBrush, kBrush, QT_TR_NOOP("&Reload"), "R",
                QT_TR_NOOP("Clean the brush and fill it with the paint"), false, true},
    CommandText{Command::TopUpBrush, kBrush, QT_TR_NOOP("&Top up"), "Ctrl+R",
                QT_TR_NOOP("Dip the brush without cleaning it: what it holds stays on it")},
    CommandText{Command::BlotBrush, kBrush, QT_TR_NOOP("B&lot"), "Shift+C",
                QT_TR_NOOP("Press the brush into a cloth: a quarter of its paint stays on it")},
    CommandText{Command::CleanBrush, kBrush, QT_TR_NOOP("&Clean"), "C",
                QT_TR_NOOP("Wipe the brush: an empty one moves the paint that lies there")},
    CommandText{Command::SwapPaints, kBrush, QT_TR_NOOP("S&wap the two paints"), "X",
                QT_TR_NOOP("Dip the brush in the second paint; the first takes its place"), false, true},
    CommandText{Command::PopupPalette, kBrush, QT_TR_NOOP("Pop-&up palette"), "Menu",
                QT_TR_NOOP("Tools and paints around the pointer; so does a right click on the canvas")},
    CommandText{Command::PickPaint, kBrush, QT_TR_NOOP("P&ick up the paint there"), "P",
                QT_TR_NOOP("The next click dips the brush in the mixture of pigments that lies there; "
                           "so does Ctrl and a click"),
                true},
    CommandText{
        Command::PickColour, kBrush, QT_TR_NOOP("Pick the c&olour seen there"), "Shift+P",
        QT_TR_NOOP(
            "The next click makes paint of the colour that is seen there; so does Alt and a click"),
        true},
    CommandText{Command::ReloadEachStroke, kBrush, QT_TR_NOOP("Reload before &each stroke"), "Shift+R",
                QT_TR_NOOP("Every stroke starts with a clean, full brush"), true, true},
    CommandText{
        Command::TurnWithStroke, kBrush, QT_TR_NOOP("&Turn with the stroke"), "Shift+T",
        QT_TR_NOOP("Flat brushes stand across their path, where the pen does not tell its rotation"),
        true},
    CommandText{Command::SaveBrush, kBrush, QT_TR_NOOP("&Save as my own..."), "Ctrl+B",
                QT_TR_NOOP("Keep the tool in hand, with its curves, among your own"), false, true},
    CommandText{Command::RenameBrush, kBrush, QT_TR_NOOP("Re&name..."), "Shift+F2",
                QT_TR_NOOP("Give your own tool another name")},
    CommandText{Command::DeleteBrush, kBrush, QT_TR_NOOP("&Delete..."), "Ctrl+Del",
                QT_TR_NOOP("Throw your own tool away")},
    CommandText{Command::Pause, kPaint, QT_TR_NOOP("&Pause the paint"), "F",
                QT_TR_NOOP("Wet paint stands still until you go on"), true},
    CommandText{Command::DryNow, kPaint, QT_TR_NOOP("&Dry now"), "D",
                QT_TR_NOOP("All wet paint dries at once: paint over it without stirring it up")},
    CommandText{
        Command::MixingWell, kPaint, QT_TR_NOOP("Mixing &well"), "W",
        QT_TR_NOOP("A palette of wet paint: mix there with any tool, and carry it to the canvas"), true,
        true},
    CommandText{
        Command::SqueezePaint, kPaint, QT_TR_NOOP("&Squeeze onto the well"), "S",
        QT_TR_NOOP(
            "Squeeze the paint that you chose onto the mixing well; Control and click says where")},
    CommandText{Command::CleanWell, kPaint, QT_TR_NOOP("&Clean the well"), "Shift+W",
                QT_TR_NOOP("Wipe the mixing well bare")},
    CommandText{Command::AddLayer, kLayer, QT_TR_NOOP("&New layer"), "Ins",
                QT_TR_NOOP("A bare layer above the one that you paint on")},
    CommandText{Command::LayerFromPicture, kLayer, QT_TR_NOOP("From a &picture..."), "Ctrl+Shift+O",
                QT_TR_NOOP("Put a picture onto the canvas as a layer of dry paint")},
    CommandText{Command::DuplicateLayer, kLayer, QT_TR_NOOP("&Duplicate"), "Ctrl+J",
                QT_TR_NOOP("The same paint once more, on a layer above")},
    CommandText{Command::RenameLayer, kLayer, QT_TR_NOOP("Na&me..."), "F2",
                QT_TR_NOOP("Give the layer or the group another name")},
    CommandText{Command::RemoveLayer, kLayer, QT_TR_NOOP("&Remove"), "Shift+Del",
                QT_TR_NOOP("Take the layer away with all its paint")},
    CommandText{Command::ClearLayer, kLayer, QT_TR_NOOP("&Clear"), "Del",
                QT_TR_NOOP("Wipe all paint off the layer")},
    CommandText{
        Command::TransformLayer, kLayer, QT_TR_NOOP("&Transform"), "Ctrl+T; T",
        QT_TR_NOOP(
            "Move, scale, turn and mirror the layer's paint, or what is selected of it, by a frame"),
        true},
    CommandText{Command::MergeDown, kLayer, QT_TR_NOOP("M&erge down"), "Ctrl+E",
                QT_TR_NOOP("Put the layer's paint on the layer below, and make them one"), false, true},
    CommandText{Command::FlattenLayers, kLayer, QT_TR_NOOP("&Flatten what is visible"), "Ctrl+Shift+E",
                QT_TR_NOOP("Make one layer of all that are visible; hidden ones stay")},
    CommandText{
        Command::GroupLayers, kLayer, QT_TR_NOOP("&Group"), "Ctrl+G",
        QT_TR_NOOP("Put the chosen layers into a group, which is hidden, locked and faded as one")},
    CommandText{Command::UngroupLayers, kLayer, QT_TR_NOOP("&Ungroup"), "Ctrl+Alt+G",
                QT_TR_NOOP("Dissolve the group; its layers stay where they are")},
    CommandText{Command::ShowLayer, kLayer, QT_TR_NOOP("&Visible"), "Ctrl+,",
                QT_TR_NOOP("Show or hide the layer or the group"), true, true},
    CommandText{Command::LockLayer, kLayer, QT_TR_NOOP("&Locked"), "Ctrl+/",
                QT_TR_NOOP("Keep the layer or the group from being painted on, cleared and merged"),
                true},
    CommandText{Command::LayerAbove, kLayer, QT_TR_NOOP("Choose the one &above"), "PgUp",
                QT_TR_NOOP("Paint on the layer above"), false, true},
    CommandText{Command::LayerBelow, kLayer, QT_TR_NOOP("Choose the one &below"), "PgDown",
                QT_TR_NOOP("Paint on the layer below")},
    CommandText{Command::RaiseLayer, kLayer, QT_TR_NOOP("Move u&p"), "Ctrl+PgUp",
                QT_TR_NOOP("Move the layer or the group one place up, into and out of groups")},
    CommandText{Command::LowerLayer, kLayer, QT_TR_NOOP("Move d&own"), "Ctrl+PgDown",
                QT_TR_NOOP("Move the layer or the group one place down, into and out of groups")},
    CommandText{
        Command::SelectRectangle, kSelect, QT_TR_NOOP("&Rectangle"), "A",
        QT_TR_NOOP(
            "Drag a rectangle that tools keep to; Shift adds, Alt takes away, Ctrl makes a square"),
        true},
    CommandText{Command::SelectLasso, kSelect, QT_TR_NOOP("&Lasso"), "L",
                QT_TR_NOOP("Draw around what tools keep to; Shift adds, Alt takes away"), true},
    CommandText{Command::SelectEverything, kSelect, QT_TR_NOOP("&Everything"), "Ctrl+A; Ctrl+Shift+A",
                QT_TR_NOOP("End the selection: tools work on all of the canvas"), false, true},
    CommandText{Command::InvertSelection, kSelect, QT_TR_NOOP("&Invert"), "Ctrl+Shift+I",
                QT_TR_NOOP("Select what is not selected")},
    CommandText{Command::SelectHeight, kSelect, QT_TR_NOOP("By &height..."), "Ctrl+Alt+H",
                QT_TR_NOOP("Select where the paint stands so high above the bare canvas"), false, true},
    CommandText{Command::SelectWetness, kSelect, QT_TR_NOOP("By &wetness..."), "Ctrl+Alt+W",
                QT_TR_NOOP("Select where the wet paint of the layer is so thick")},
    CommandText{Command::ShowOutline, kSelect, QT_TR_NOOP("Show the &outline"), "Ctrl+H",
                QT_TR_NOOP("Hidden, it is out of the way of what you paint; tools keep to it as before"),
                true, true},
    CommandText{Command::MirrorSymmetry, kGuides, QT_TR_NOOP("&Mirror left and right"), "Q; Shift+M",
                QT_TR_NOOP("Every stroke is painted on both sides of the upright line"), true},
    CommandText{Command::MirrorLevel, kGuides, QT_TR_NOOP("Mirror a&bove and below"), "Ctrl+Shift+M",
                QT_TR_NOOP("Every stroke is painted on both sides of the level line"), true},
    CommandText{Command::MoreCopies, kGuides, QT_TR_NOOP("M&ore copies around the middle"), ".",
                QT_TR_NOOP("Every stroke is painted once more around the middle of the canvas")},
    CommandText{Command::FewerCopies, kGuides, QT_TR_NOOP("&Fewer copies around the middle"), ",",
                QT_TR_NOOP("Every stroke is painted once less around the middle of the canvas")},
    CommandText{
        Command::Ruler, kGuides, QT_TR_NOOP("&Ruler along the last stroke"), "G",
        QT_TR_NOOP(
            "Strokes run along the ruler, or parallel to it; Shift and drag draw a straight line"),
        true, true},
    CommandText{Command::Ellipse, kGuides, QT_TR_NOOP("&Ellipse"), "Shift+G",
                QT_TR_NOOP("Strokes run along the ellipse, or along another of the same shape"), true},
    CommandText{Command::GuideHandles, kGuides, QT_TR_NOOP("&Handles"), "H",
                QT_TR_NOOP("Points by which guides are dragged; Shift keeps to steps and proportions"),
                true, true},
    CommandText{Command::RemoveGuides, kGuides, QT_TR_NOOP("&No guides"), "Ctrl+Shift+G",
                QT_TR_NOOP("Take mirrors, copies, ruler and ellipse away")},
    CommandText{
        Command::TracePicture, kGuides, QT_TR_NOOP("&Trace a picture..."), "Ctrl+Alt+T",
        QT_TR_NOOP(
            "Lay a picture below the paint, and beside the canvas; it is in no picture that you save"),
        false, true},
    CommandText{Command::ShowTracing, kGuides, QT_TR_NOOP("&Show it below the paint"), "Shift+F9",
                QT_TR_NOOP("Show or hide the picture that you trace"), true},
    CommandText{Command::FitTracing, kGuides, QT_TR_NOOP("F&it it to the canvas"), "Ctrl+Alt+F",
                QT_TR_NOOP("In the middle of the canvas, as large as it fits")},
    CommandText{Command::RemoveTracing, kGuides, QT_TR_NOOP("Ta&ke it away"), "Ctrl+Alt+Shift+T",
                QT_TR_NOOP("Take the picture that you trace away")},
    CommandText{Command::FitCanvas, kView, QT_TR_NOOP("&Fit the canvas"), "Ctrl+0",
                QT_TR_NOOP("Show the whole canvas")},
    CommandText{Command::ActualPixels, kView, QT_TR_NOOP("&Actual pixels"), "1",
                QT_TR_NOOP("One screen pixel for every pixel of the saved picture")},
    CommandText{Command::ZoomIn, kView, QT_TR_NOOP("Zoom &in"), "Ctrl++; Ctrl+=", QT_TR_NOOP("Closer"),
                false, true},
    CommandText{Command::ZoomOut, kView, QT_TR_NOOP("Zoom &out"), "Ctrl+-", QT_TR_NOOP("Farther")},
    CommandText{
        Command::TurnLeft, kView, QT_TR_NOOP("Turn &left"), "4",
        QT_TR_NOOP("Turn the canvas a little to the left on the screen; so does Shift+Space and a drag"),
        false, true},
    CommandText{Command::TurnUpright, kView, QT_TR_NOOP("&Upright"), "5",
                QT_TR_NOOP("The canvas stands again as it is saved")},
    CommandText{
        Command::TurnRight, kView, QT_TR_NOOP("Turn &right"), "6",
        QT_TR_NOOP(
            "Turn the canvas a little to the right on the screen; so does Shift+Space and a drag")},
    CommandText{Command::MirrorView, kView, QT_TR_NOOP("&Mirror the view"), "M",
                QT_TR_NOOP("See the painting as in a mirror, and paint on it so; it is saved as it is"),
                true},
    CommandText{Command::CanvasOnly, kView, QT_TR_NOOP("Canvas &only"), "Tab",
                QT_TR_NOOP("Nothing but the canvas; Tab or Escape brings the panels back"), true, true},
    CommandText{Command::LookLit, kView, QT_TR_NOOP("In its l&ight"), "Alt+1",
                QT_TR_NOOP("The paint as it hangs in its light"), true, true},
    CommandText{Command::LookWet, kView, QT_TR_NOOP("Show &wet"), "Alt+2",
                QT_TR_NOOP("Tints what is still wet, the more the thicker it is"), true},
    CommandText{Command::LookHeight, kView, QT_TR_NOOP("Show &height"), "Alt+3",
                QT_TR_NOOP("How high the paint stands above the bare canvas, in steps of colour"), true},
    CommandText{Command::LookNormals, kView, QT_TR_NOOP("Show &normals"), "Alt+4",
                QT_TR_NOOP("Where the surface faces: red to the right, green up, blue towards you"),
                true},
    CommandText{Command::LookFlat, kView, QT_TR_NOOP("&Flat colour"), "Alt+5",
                QT_TR_NOOP("The paint's colours alone, without light and relief"), true},
    CommandText{Command::ToolPanel, kView, QT_TR_NOOP("&Tool panel"), "F5",
                QT_TR_NOOP("What the brush holds, and how it answers to the hand"), false, true},
    CommandText{Command::ColourPanel, kView, QT_TR_NOOP("&Colour panel"), "F6",
                QT_TR_NOOP("A paint of any colour, and its recipe from the tubes")},
    CommandText{Command::PhysicsPanel, kView, QT_TR_NOOP("P&hysics panel"), "Shift+F6",
                QT_TR_NOOP("What the paint is like: how it flows, holds and dries")},
    CommandText{Command::GuidesPanel, kView, QT_TR_NOOP("&Guides panel"), "F7",
                QT_TR_NOOP("Mirrors, ruler and ellipse in millimetres")},
    CommandText{Command::LayersPanel, kView, QT_TR_NOOP("&Layers panel"), "F8",
                QT_TR_NOOP("The layers of the painting: seen, locked, faded, in what order")},
    CommandText{Command::TracingPanel, kView, QT_TR_NOOP("Tr&acing panel"), "F9",
                QT_TR_NOOP("The picture that you trace, to look at and to pick colours from")},
    CommandText{Command::HistoryPanel, kView, QT_TR_NOOP("&History panel"), "Shift+F8",
                QT_TR_NOOP("What was done, to go back to any of it")},
    CommandText{Command::NavigatorPanel, kView, QT_TR_NOOP("&Navigator"), "Shift+F7",
                QT_TR_NOOP("The whole canvas, to see where the window is and to go elsewhere")},
    CommandText{Command::LightPanel, kView, QT_TR_NOOP("Li&ghts panel"), "F4",
                QT_TR_NOOP("The lamp, its light, and a coat of varnish to look through")},
    CommandText{
        Command::RecorderPanel, kView, QT_TR_NOOP("Recor&der panel"), "Shift+F4",
        QT_TR_NOOP("What is recorded of the painting: watch it grow again, or make a time-lapse")},
    CommandText{Command::ResetPanels, kView, QT_TR_NOOP("&Reset the panels"), "Shift+F5",
                QT_TR_NOOP("Panels and mixing well as they stood at the first start")},
    CommandText{Command::SpaceSrgb, kView, QT_TR_NOOP("Colours for s&RGB"), "Ctrl+Alt+6",
                QT_TR_NOOP("Shows the painting for common screens"), true, true},
    CommandText{Command::SpaceDisplayP3, kView, QT_TR_NOOP("Colours for Display &P3"), "Ctrl+Alt+7",
                QT_TR_NOOP("Shows the painting for a screen of wide gamut"), true},
    CommandText{Command::LightD65, kLight, QT_TR_NOOP("&Daylight (D65)"), "Ctrl+Alt+1",
                QT_TR_NOOP("The light that screens are made for"), true},
    CommandText{Command::LightD50, kLight, QT_TR_NOOP("&Print booth (D50)"), "Ctrl+Alt+2",
                QT_TR_NOOP("The light that prints are judged in"), true},
    CommandText{Command::LightA, kLight, QT_TR_NOOP("Light &bulb (A)"), "Ctrl+Alt+3",
                QT_TR_NOOP("Incandescent lamplight"), true},
    CommandText{Command::LightLed, kLight, QT_TR_NOOP("&LED lamp"), "Ctrl+Alt+4",
                QT_TR_NOOP("A white LED with its blue peak"), true},
    CommandText{Command::LightFile, kLight, QT_TR_NOOP("From a &file..."), "Ctrl+Alt+5",
                QT_TR_NOOP("A lamp that you have measured, as a CSV file"), true},
    CommandText{Command::MoveLight, kLight, QT_TR_NOOP("&Move the light"), "Shift+L",
                QT_TR_NOOP("Drag the lamp over the canvas: towards the rim it rakes over the relief"),
                true, true},
    CommandText{Command::FindCommand, kSettings, QT_TR_NOOP("&Find a command..."),
                "Ctrl+Return; Ctrl+Enter", QT_TR_NOOP("Type a few letters of what you want to do")},
    CommandText{Command::EditKeys, kSettings, QT_TR_NOOP("&Keys..."), "Ctrl+Alt+K",
                QT_TR_NOOP("Choose a set of keys, and give any command keys of your own"), false, true},
    CommandText{Command::EditSettings, kSettings, QT_TR_NOOP("&Settings..."), "Ctrl+Alt+O",
                QT_TR_NOOP("The look of the window, what is kept, and how much of the machine is used")},
    CommandText{
        Command::PenSettings, kSettings, QT_TR_NOOP("&Pen and tablet..."), "Ctrl+Shift+T",
        QT_TR_NOOP("How pens and mouse press, what their buttons do, and a sheet to try them on")},
};

}  // namespace

std::span<const CommandText> command_list() {
    return kCommands;
}

const CommandText& text_of(Command command) {
    const auto* found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                     [&](const CommandText& text) { return text.command == command; });
    PASTOSO_CHECK(found != std::end(kCommands));
    return *found;
}

}  // namespace pastoso::commands
