// The panels around the canvas, put where they stand at first: tool bar above, docks on both sides, the
// canvas in the rest.
#pragma once

#include "commands/command_list.hpp"

#include <map>

#include <QSize>

class QComboBox;
class QDockWidget;

namespace pastoso::panels {
class BrushPanel;
class ColourPanel;
class CurvesPanel;
class EaselPanel;
class GuidesPanel;
class HistoryPanel;
class LayerPanel;
class LightPanel;
class LoadPanel;
class MediumBox;
class MediumPanel;
class MessagePanel;
class NavigatorPanel;
class PaintPanel;
class RecorderPanel;
class ReferencePanel;
class StatusReadings;
class ThinningSlider;
class ToolBar;
class TracingPanel;
}  // namespace pastoso::panels

namespace pastoso::main {

class Studio;

/// The window owns them all.
struct PanelSet {
    panels::ToolBar* bar = nullptr;
    panels::BrushPanel* brushes = nullptr;
    panels::PaintPanel* paints = nullptr;
    panels::EaselPanel* stand = nullptr;
    panels::ColourPanel* colours = nullptr;
    panels::LoadPanel* load = nullptr;
    panels::MediumPanel* physics = nullptr;
    panels::CurvesPanel* curves = nullptr;
    panels::HistoryPanel* history = nullptr;
    panels::GuidesPanel* guides = nullptr;
    panels::LayerPanel* layers = nullptr;
    panels::TracingPanel* tracing = nullptr;
    panels::ReferencePanel* references = nullptr;
    panels::NavigatorPanel* navigator = nullptr;
    panels::LightPanel* lights = nullptr;
    panels::RecorderPanel* recorder = nullptr;
    panels::MessagePanel* messages = nullptr;
    panels::StatusReadings* readings = nullptr;
    panels::MediumBox* medium = nullptr;
    panels::ThinningSlider* thinning = nullptr;  ///< beside it
    QComboBox* time = nullptr;  ///< how fast it passes for the paint
    QDockWidget* well = nullptr;
    std::map<commands::Command, QDockWidget*> docks;  ///< by the command that shows them
};

/// Builds menus, tool bar and panels of the studio's window, and puts its views among them.
PanelSet lay_out(Studio& studio);

/// Before a size is remembered: most of what is free of the screen, but enough to paint in, and no more
/// than is looked over at once. In pixels of the layout.
QSize first_window_size(const QSize& screen);

/// The part of it that stands in docks.
void add_docks(Studio& studio, PanelSet& panels);

}  // namespace pastoso::main
