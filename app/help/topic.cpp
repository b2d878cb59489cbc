#include "help/topic.hpp"

#include <algorithm>
#include <string_view>

#include <QVariant>
#include <QWidget>

namespace pastoso::help {
namespace {

constexpr Topic kTopics[] = {
    {"pastoso::start::StartPage", "README#the-first-minutes"},
    {"pastoso::view::CanvasView", "brushes"},
    {"pastoso::panels::BrushPanel", "brushes"},
    {"pastoso::panels::BrushEditor", "brushes#the-brush-editor"},
    {"pastoso::panels::LoadPanel", "brushes#what-the-brush-holds"},
    {"pastoso::panels::CurvesPanel", "brushes#how-it-responds-to-the-hand"},
    {"pastoso::panels::PaintPanel", "paint#tubes-and-colours"},
    {"pastoso::panels::ColourPanel", "paint#tubes-and-colours"},
    {"pastoso::panels::MediumBox", "paint#kinds-of-paint"},
    {"pastoso::panels::MediumPanel", "paint#kinds-of-paint"},
    {"pastoso::panels::ThinningSlider", "paint#from-paste-to-stain"},
    {"pastoso::panels::EaselPanel", "paint#tilt-and-drying"},
    {"pastoso::panels::PenDialog", "pen"},
    {"pastoso::panels::PopupPalette", "pen#the-pop-up-palette"},
    {"pastoso::panels::NavigatorPanel", "view"},
    {"pastoso::panels::LightPanel", "view#light"},
    {"pastoso::panels::LayerPanel", "layers#layers"},
    {"pastoso::panels::GuidesPanel", "layers#guides"},
    {"pastoso::panels::TracingPanel", "layers#tracing"},
    {"pastoso::panels::ReferencePanel", "layers#references"},
    {"pastoso::dialogs::TransformDialog", "layers#moving-scaling-and-turning"},
    {"pastoso::dialogs::AdjustDialog", "layers#adjusting-dry-paint"},
    {"pastoso::dialogs::ScaleDialog", "layers#another-size-or-resolution"},
    {"pastoso::dialogs::RotateDialog", "layers#the-whole-painting-mirrored-and-turned"},
    {"pastoso::dialogs::CanvasSizeDialog", "layers#the-size-of-the-canvas"},
    {"pastoso::dialogs::SelectRangeDialog", "layers#selections"},
    {"pastoso::dialogs::MarginDialog", "layers#selections"},
    {"pastoso::dialogs::ThicknessDialog", "paint#filling"},
    {"pastoso::dialogs::TextureDialog", "paint#texture-paste"},
    {"pastoso::panels::HistoryPanel", "history-and-files#undo"},
    {"pastoso::panels::RecorderPanel", "history-and-files#the-recorder"},
    {"pastoso::panels::MessagePanel", "history-and-files#when-something-fails"},
    {"pastoso::dialogs::RecoveryDialog", "history-and-files#when-something-fails"},
    {"pastoso::dialogs::CrashDialog", "history-and-files#when-something-fails"},
    {"pastoso::dialogs::ExportDialog", "history-and-files#export"},
    {"pastoso::main::WatchedWindow", "history-and-files#the-recorder"},
    {"pastoso::dialogs::RepaintDialog", "history-and-files#the-recorder"},
    {"pastoso::dialogs::NewCanvasDialog", "README#the-first-minutes"},
    {"pastoso::dialogs::SettingsDialog", "settings"},
    {"pastoso::dialogs::KeysDialog", "settings#keys"},
    {"pastoso::dialogs::CommandPalette", "keys"},
    {"pastoso::glass::TeaView", "milk-tea"},
    {"pastoso::glass::TeaPanel", "milk-tea#what-you-can-do"},
    {"pastoso::glass::TankView", "glass-tank"},
    {"pastoso::glass::TankPanel", "glass-tank#while-it-runs"},
    {"pastoso::glass::LiquidPictureDialog", "milk-tea-pictures"},
};

constexpr char kOwnTopic[] = "help_topic";

/// Of its class, or of one that it is derived from.
const char* page_of(const QWidget& widget) {
    for (const QMetaObject* type = widget.metaObject(); type != nullptr; type = type->superClass()) {
        const auto* found = std::find_if(
            std::begin(kTopics), std::end(kTopics),
            [&](const Topic& topic) { return std::string_view(topic.widget) == type->className(); });
        if (found != std::end(kTopics)) return found->page;
    }
    return nullptr;
}

}  // namespace

std::span<const Topic> topics() {
    return kTopics;
}

void set_topic(QWidget& widget, const char* page) {
    widget.setProperty(kOwnTopic, QString::fromLatin1(page));
}

QString topic_of(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        if (const QVariant own = widget->property(kOwnTopic); own.isValid()) return own.toString();
        if (const char* page = page_of(*widget)) return QString::fromLatin1(page);
    }
    return {};
}

}  // namespace pastoso::help
