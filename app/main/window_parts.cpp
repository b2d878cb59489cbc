#include "main/window_parts.hpp"

namespace pastoso::main {

WindowParts::WindowParts(Studio& studio, const PanelSet& panels, bool keeps_journal)
    : messages(studio),
      sizing(studio, panels.readings),
      layers(studio, panels.layers, panels.docks.at(commands::Command::LayersPanel)),
      layer_pictures(studio, panels.layers, panels.docks.at(commands::Command::LayersPanel)),
      selection(studio, panels.brushes, panels.readings),
      ranges(studio),
      tracing(studio, panels.tracing),
      well(studio, panels.well),
      hand(studio, panels),
      time(studio, panels),
      keeping_up(studio, panels.readings),
      brushes(studio, panels.brushes, panels.curves),
      guides(studio, panels.guides),
      transform(studio, panels.brushes),
      undo(studio, panels.history, transform),
      picking(studio),
      pens(studio),
      swatches(studio, panels),
      media(studio, panels),
      popup(studio, brushes, swatches, panels.colours),
      files(studio, keeps_journal),
      start(studio, files, messages),
      view(studio, panels.readings),
      navigation(studio, panels.navigator, panels.docks.at(commands::Command::NavigatorPanel)),
      light(studio, panels.stand, panels.lights),
      pictures(studio),
      dropped(studio, files, pictures, tracing),
      exporting(studio, files, light),
      recorder(studio, panels.recorder),
      again(studio, files, light),
      paints(studio, panels.colours),
      memory(studio, panels, light, undo, well, start),
      keys(studio),
      preferences(studio, undo),
      place(studio, panels.readings),
      tea(studio, pictures, place),
      tank(studio, pictures, place) {}

}  // namespace pastoso::main
