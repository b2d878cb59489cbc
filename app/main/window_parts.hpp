// The parts of the window, one for each concern. They work on what they share, the Studio; whoever wants
// something of one of them asks it.
#pragma once

#include "main/canvas/canvas_sizing.hpp"
#include "main/canvas/masking_commands.hpp"
#include "main/canvas/message_place.hpp"
#include "main/canvas/navigation.hpp"
#include "main/canvas/range_selection.hpp"
#include "main/canvas/selection_commands.hpp"
#include "main/canvas/selection_margins.hpp"
#include "main/canvas/undo_commands.hpp"
#include "main/canvas/view_commands.hpp"
#include "main/dock_heights.hpp"
#include "main/files/dropped_files.hpp"
#include "main/files/exporting.hpp"
#include "main/files/loading.hpp"
#include "main/files/painting_again.hpp"
#include "main/files/project_files.hpp"
#include "main/files/recorder.hpp"
#include "main/files/start_commands.hpp"
#include "main/layers/clipboard.hpp"
#include "main/layers/dry_adjusting.hpp"
#include "main/layers/layer_commands.hpp"
#include "main/layers/layer_pictures.hpp"
#include "main/layers/layer_transform.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/layers/tracing_commands.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/paint/fill_commands.hpp"
#include "main/paint/keeping_up.hpp"
#include "main/paint/light_choice.hpp"
#include "main/paint/media_swatches.hpp"
#include "main/paint/paint_picking.hpp"
#include "main/paint/paint_settings.hpp"
#include "main/paint/paint_time.hpp"
#include "main/paint/swatches.hpp"
#include "main/paint/texture_commands.hpp"
#include "main/paint/tube_commands.hpp"
#include "main/paint/well_commands.hpp"
#include "main/panel_set.hpp"
#include "main/pen/brush_bundles.hpp"
#include "main/pen/brush_editing.hpp"
#include "main/pen/brush_jar.hpp"
#include "main/pen/brush_shelving.hpp"
#include "main/pen/guide_commands.hpp"
#include "main/pen/hand_controls.hpp"
#include "main/pen/pen_commands.hpp"
#include "main/pen/popup_commands.hpp"
#include "main/program/colour_commands.hpp"
#include "main/program/help_commands.hpp"
#include "main/program/key_commands.hpp"
#include "main/program/new_window.hpp"
#include "main/program/preference_commands.hpp"
#include "main/program/tour_commands.hpp"
#include "main/program/window_settings.hpp"
#include "main/program/workspace_commands.hpp"
#include "main/references/reference_commands.hpp"

namespace pastoso::main {

/// What is published is shown in this order.
struct WindowParts {
    WindowParts(Studio& studio, const PanelSet& panels, bool keeps_journal);

    MessagePlace messages;
    Loading loading;
    CanvasSizing sizing;
    LayerCommands layers;
    LayerPictures layer_pictures;
    SelectionCommands selection;
    RangeSelection ranges;
    SelectionMargins margins;
    MaskingCommands masking;
    FillCommands fills;
    TextureCommands textures;
    DryAdjusting dry_adjusting;
    TracingCommands tracing;
    ReferenceCommands references;
    WellCommands well;
    HandControls hand;
    PaintTime time;
    KeepingUp keeping_up;
    BrushJar brushes;
    BrushEditing brush_editing;
    BrushShelving brush_shelf;
    BrushBundles brush_bundles;
    GuideCommands guides;
    LayerTransform transform;
    UndoCommands undo;
    PaintPicking picking;
    PenCommands pens;
    Swatches swatches;
    MediaSwatches media;
    PopupCommands popup;
    ProjectFiles files;
    StartCommands start;
    ViewCommands view;
    Navigation navigation;
    LightChoice light;
    PictureLayers pictures;
    Clipboard clipboard;
    Exporting exporting;
    Recorder recorder;
    PaintingAgain again;
    PaintSettings paints;
    TubeCommands tubes;
    TourCommands tour;
    DockHeights heights;
    WindowSettings memory;
    WorkspaceCommands workspaces;
    NewWindow new_window;
    DroppedFiles dropped;
    KeyCommands keys;
    ColourCommands colours;
    PreferenceCommands preferences;
    HelpCommands help;
    CanvasPlace place;
    TeaMode tea;
    TankMode tank;
};

}  // namespace pastoso::main
