#include "commands/key_sets.hpp"

#include <QString>

namespace pastoso::commands {
namespace {

constexpr KeySetText kSets[] = {
    {KeySet::Pastoso, "pastoso", QT_TRANSLATE_NOOP("Keys", "Pastoso"),
     QT_TRANSLATE_NOOP("Keys", "Krita's keys, but for short ones of what only wet paint has")},
    {KeySet::Krita, "krita", QT_TRANSLATE_NOOP("Keys", "Like Krita"),
     QT_TRANSLATE_NOOP("Keys", "The keys of Krita, where it has the same command")},
    {KeySet::Photoshop, "photoshop", QT_TRANSLATE_NOOP("Keys", "Like Photoshop"),
     QT_TRANSLATE_NOOP("Keys", "The keys of Photoshop, where it has the same command")},
};

struct OtherKeys {
    Command command;
    const char* keys;  ///< in place of those in the list of commands
};

/// Where Krita has another key for the same command, or needs that of the list for another one.
constexpr OtherKeys kKrita[] = {
    {Command::TopUpBrush, "Ctrl+Shift+R"},    {Command::FillGradient, "G; Ctrl+Backspace"},
    {Command::ClipLayer, "Ctrl+Shift+G"},     {Command::SelectRectangle, "Ctrl+R; A"},
    {Command::SelectEllipse, "J; Shift+A"},   {Command::SelectContiguous, "Shift+J"},
    {Command::SelectSimilar, "Ctrl+Shift+J"}, {Command::Ruler, "Y"},
    {Command::RemoveGuides, "Ctrl+;"},
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

std::span<const OtherKeys> other_keys(KeySet set) {
    if (set == KeySet::Krita) return kKrita;
    if (set == KeySet::Photoshop) return kPhotoshop;
    return {};
}

const char* keys_text(KeySet set, Command command) {
    for (const OtherKeys& other : other_keys(set))
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
