#include "commands/command_names.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace pastoso::commands {
namespace {

struct Name {
    Command command;
    std::string_view text;
};

constexpr Name kNames[] = {
    {Command::NewCanvas, "new_canvas"},
    {Command::OpenPainting, "open_painting"},
    {Command::CancelLoading, "cancel_loading"},
    {Command::StartPage, "start_page"},
    {Command::SavePainting, "save_painting"},
    {Command::SavePaintingAs, "save_painting_as"},
    {Command::SaveCopy, "save_copy"},
    {Command::Export, "export"},
    {Command::ExportAgain, "export_again"},
    {Command::StopExport, "stop_export"},
    {Command::SaveRecording, "save_recording"},
    {Command::Play, "play"},
    {Command::MakeTimelapse, "make_timelapse"},
    {Command::PaintAgain, "paint_again"},
    {Command::Quit, "quit"},
    {Command::Undo, "undo"},
    {Command::Redo, "redo"},
    {Command::UndoMemory, "undo_memory"},
    {Command::CanvasSize, "canvas_size"},
    {Command::CropToSelection, "crop_to_selection"},
    {Command::SmallerBrush, "smaller_brush"},
    {Command::LargerBrush, "larger_brush"},
    {Command::NextBrush, "next_brush"},
    {Command::PreviousBrush, "previous_brush"},
    {Command::ReloadBrush, "reload_brush"},
    {Command::TopUpBrush, "top_up_brush"},
    {Command::BlotBrush, "blot_brush"},
    {Command::CleanBrush, "clean_brush"},
    {Command::SwapPaints, "swap_paints"},
    {Command::MoreMedium, "more_medium"},
    {Command::MorePaint, "more_paint"},
    {Command::ThinWash, "thin_wash"},
    {Command::PopupPalette, "popup_palette"},
    {Command::PickPaint, "pick_paint"},
    {Command::PickColour, "pick_colour"},
    {Command::ReloadEachStroke, "reload_each_stroke"},
    {Command::TurnWithStroke, "turn_with_stroke"},
    {Command::TiltTool, "tilt_tool"},
    {Command::SaveBrush, "save_brush"},
    {Command::RenameBrush, "rename_brush"},
    {Command::DeleteBrush, "delete_brush"},
    {Command::Pause, "pause"},
    {Command::TimeFaster, "time_faster"},
    {Command::TimeSlower, "time_slower"},
    {Command::TimeReal, "time_real"},
    {Command::DryNow, "dry_now"},
    {Command::MixingWell, "mixing_well"},
    {Command::SqueezePaint, "squeeze_paint"},
    {Command::CleanWell, "clean_well"},
    {Command::AddLayer, "add_layer"},
    {Command::LayerFromPicture, "layer_from_picture"},
    {Command::DuplicateLayer, "duplicate_layer"},
    {Command::RenameLayer, "rename_layer"},
    {Command::RemoveLayer, "remove_layer"},
    {Command::ClearLayer, "clear_layer"},
    {Command::TransformLayer, "transform_layer"},
    {Command::MergeDown, "merge_down"},
    {Command::FlattenLayers, "flatten_layers"},
    {Command::GroupLayers, "group_layers"},
    {Command::UngroupLayers, "ungroup_layers"},
    {Command::ShowLayer, "show_layer"},
    {Command::LockLayer, "lock_layer"},
    {Command::LayerAbove, "layer_above"},
    {Command::LayerBelow, "layer_below"},
    {Command::RaiseLayer, "raise_layer"},
    {Command::LowerLayer, "lower_layer"},
    {Command::SelectRectangle, "select_rectangle"},
    {Command::SelectLasso, "select_lasso"},
    {Command::SelectEverything, "select_everything"},
    {Command::InvertSelection, "invert_selection"},
    {Command::SelectHeight, "select_height"},
    {Command::SelectWetness, "select_wetness"},
    {Command::ShowOutline, "show_outline"},
    {Command::MirrorSymmetry, "mirror_symmetry"},
    {Command::MirrorLevel, "mirror_level"},
    {Command::MoreCopies, "more_copies"},
    {Command::FewerCopies, "fewer_copies"},
    {Command::Ruler, "ruler"},
    {Command::Ellipse, "ellipse"},
    {Command::GuideHandles, "guide_handles"},
    {Command::RemoveGuides, "remove_guides"},
    {Command::TracePicture, "trace_picture"},
    {Command::ShowTracing, "show_tracing"},
    {Command::FitTracing, "fit_tracing"},
    {Command::RemoveTracing, "remove_tracing"},
    {Command::FitCanvas, "fit_canvas"},
    {Command::ActualPixels, "actual_pixels"},
    {Command::ZoomIn, "zoom_in"},
    {Command::ZoomOut, "zoom_out"},
    {Command::TurnLeft, "turn_left"},
    {Command::TurnUpright, "turn_upright"},
    {Command::TurnRight, "turn_right"},
    {Command::MirrorView, "mirror_view"},
    {Command::CanvasOnly, "canvas_only"},
    {Command::LookLit, "look_lit"},
    {Command::LookWet, "look_wet"},
    {Command::LookHeight, "look_height"},
    {Command::LookNormals, "look_normals"},
    {Command::LookFlat, "look_flat"},
    {Command::SoftProof, "soft_proof"},
    {Command::GamutWarning, "gamut_warning"},
    {Command::ValueCheck, "value_check"},
    {Command::ToolPanel, "tool_panel"},
    {Command::ColourPanel, "colour_panel"},
    {Command::PhysicsPanel, "physics_panel"},
    {Command::GuidesPanel, "guides_panel"},
    {Command::LayersPanel, "layers_panel"},
    {Command::TracingPanel, "tracing_panel"},
    {Command::HistoryPanel, "history_panel"},
    {Command::NavigatorPanel, "navigator_panel"},
    {Command::LightPanel, "light_panel"},
    {Command::RecorderPanel, "recorder_panel"},
    {Command::MessagesPanel, "messages_panel"},
    {Command::ResetPanels, "reset_panels"},
    {Command::SpaceSrgb, "space_srgb"},
    {Command::SpaceDisplayP3, "space_display_p3"},
    {Command::LightD65, "light_d65"},
    {Command::LightD50, "light_d50"},
    {Command::LightA, "light_a"},
    {Command::LightLed, "light_led"},
    {Command::LightFile, "light_file"},
    {Command::MoveLight, "move_light"},
    {Command::FindCommand, "find_command"},
    {Command::EditKeys, "edit_keys"},
    {Command::EditSettings, "edit_settings"},
    {Command::PenSettings, "pen_settings"},
    {Command::MilkTea, "milk_tea"},
    {Command::TeaPour, "tea_pour"},
    {Command::TeaNewGlass, "tea_new_glass"},
    {Command::TeaOpenScene, "tea_open_scene"},
    {Command::TeaSaveScene, "tea_save_scene"},
    {Command::LiquidExportMesh, "liquid_export_mesh"},
    {Command::TeaRender, "tea_render"},
    {Command::LiquidPause, "liquid_pause"},
    {Command::LiquidFullSpeed, "liquid_full_speed"},
    {Command::TeaForce, "tea_force"},
    {Command::TeaRecentre, "tea_recentre"},
    {Command::TeaReverse, "tea_reverse"},
    {Command::TeaAxisLeft, "tea_axis_left"},
    {Command::TeaAxisRight, "tea_axis_right"},
    {Command::TeaAxisAway, "tea_axis_away"},
    {Command::TeaAxisNear, "tea_axis_near"},
    {Command::LiquidFrontView, "liquid_front_view"},
    {Command::GlassTank, "glass_tank"},
    {Command::TankFalling, "tank_falling"},
    {Command::TankTwoLiquids, "tank_two_liquids"},
    {Command::TankOpenScene, "tank_open_scene"},
    {Command::TankRestart, "tank_restart"},
    {Command::TankBall, "tank_ball"},
    {Command::TankDrain, "tank_drain"},
    {Command::TankWind, "tank_wind"},
    {Command::TankWindLeft, "tank_wind_left"},
    {Command::TankWindRight, "tank_wind_right"},
    {Command::TankWindStronger, "tank_wind_stronger"},
    {Command::TankWindWeaker, "tank_wind_weaker"},
    {Command::TankVelocity, "tank_velocity"},
    {Command::TankExportAll, "tank_export_all"},
    {Command::TankRender, "tank_render"},
    {Command::TankRecordPictures, "tank_record_pictures"},
    {Command::TankRecordSurfaces, "tank_record_surfaces"},
    {Command::Manual, "manual"},
    {Command::WhatIsNew, "what_is_new"},
    {Command::About, "about"},
};

/// Files of before may have these; the keys in them go on giving the same.
constexpr Name kFormerNames[] = {
    {Command::LiquidExportMesh, "tea_export_mesh"},
    {Command::LiquidPause, "tea_pause"},
    {Command::LiquidFullSpeed, "tea_full_speed"},
    {Command::LiquidFrontView, "tea_front_view"},
};

std::optional<Command> command_in(std::span<const Name> names, std::string_view text) {
    const auto found = std::ranges::find(names, text, &Name::text);
    return found != names.end() ? std::optional(found->command) : std::nullopt;
}

}  // namespace

std::string_view name_of(Command command) {
    const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                     [&](const Name& name) { return name.command == command; });
    PASTOSO_CHECK(found != std::end(kNames));
    return found->text;
}

std::optional<Command> command_named(std::string_view name) {
    const std::optional<Command> command = command_in(kNames, name);
    return command ? command : command_in(kFormerNames, name);
}

}  // namespace pastoso::commands
