#include "commands/key_sets.hpp"

#include <QString>

namespace pastoso::commands {
namespace {

constexpr KeySetText kSets[] = {
    {KeySet::Krita, "krita", QT_TRANSLATE_NOOP("Keys", "Like Krita"),
     QT_TRANSLATE_NOOP("Keys", "The keys of Krita, where it has the same command")},
    {KeySet::Photoshop, "photoshop", QT_TRANSLATE_NOOP("Keys", "Like Photoshop"),
     QT_TRANSLATE_NOOP("Keys", "The keys of Photoshop, where it has the same command")},
};

struct OtherKeys {
    Command command;
    const char* keys;  ///< in place of those in the list of commands
};

/// Where Photoshop has another key for the same command, or needs that of the list for another one.
constexpr OtherKeys kPhotoshop[] = {
    {Command::SavePaintingAs, "Ctrl+Shift+S; Ctrl+Alt+S"},
    {Command::SaveVersion, ""},
    {Command::Export, "Ctrl+Alt+Shift+S; Ctrl+Alt+Shift+W"},
    {Command::Undo, "Ctrl+Z; Ctrl+Alt+Z"},
    {Command::Redo, "Ctrl+Shift+Z"},
    {Command::PickPaint, "I"},
    {Command::PickColour, "Shift+I"},
    {Command::FillPaint, "Alt+Backspace"},
    {Command::FillSecond, "Ctrl+Backspace"},
    {Command::FillGradient, "Shift+Backspace"},
    {Command::AddLayer, "Ctrl+Shift+N; Ctrl+Alt+Shift+N"},
    {Command::RemoveLayer, "Shift+Del"},
    {Command::TransformLayer, "Ctrl+T; V"},
    {Command::UngroupLayers, "Ctrl+Shift+G"},
    {Command::ClipLayer, "Ctrl+Alt+G"},
    {Command::RaiseLayer, "Ctrl+]"},
    {Command::LowerLayer, "Ctrl+["},
    {Command::LayerAbove, "Alt+]"},
    {Command::LayerBelow, "Alt+["},
    {Command::SelectRectangle, "M"},
    {Command::SelectEverything, "Ctrl+D; Ctrl+A"},
    {Command::InvertSelection, "Ctrl+Shift+I; Shift+F7"},
    {Command::RemoveGuides, "Ctrl+;"},
    {Command::MirrorSymmetry, "Shift+M"},
    {Command::ActualPixels, "Ctrl+1"},
    {Command::TurnLeft, ""},
    {Command::TurnUpright, ""},
    {Command::TurnRight, ""},
    {Command::MirrorView, ""},
    {Command::SoftProof, "Ctrl+Y"},
    {Command::GamutWarning, "Ctrl+Shift+Y"},
    {Command::ColourPanel, "F6"},
    {Command::LayersPanel, "F7"},
    {Command::GuidesPanel, "F8"},
    {Command::NavigatorPanel, "Ctrl+F7"},
};

const char* keys_text(KeySet set, Command command) {
    if (set == KeySet::Photoshop)
        for (const OtherKeys& other : kPhotoshop)
            if (other.command == command) return other.keys;
    return text_of(command).keys;
}

}  // namespace

std::span<const KeySetText> key_sets() {
    return kSets;
}

QList<QKeySequence> keys_in(KeySet set, Command command) {
    QList<QKeySequence> keys = QKeySequence::listFromString(QString::fromUtf8(keys_text(set, command)));
    keys.removeAll(QKeySequence());
    return keys;
}

}  // namespace pastoso::commands
