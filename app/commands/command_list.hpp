// Every command of the window: its words, its keys and its place in the menus, in one table.
#pragma once

#include <span>

namespace pastoso::commands {

enum class Command {
    NewCanvas,
    OpenPainting,
    StartPage,
    SavePainting,
    SavePaintingAs,
    Export,
    ExportAgain,
    StopExport,
    SaveRecording,
    Play,
    MakeTimelapse,
    Quit,
    Undo,
    Redo,
    UndoMemory,
    CanvasSize,
    CropToSelection,
    SmallerBrush,
    LargerBrush,
    NextBrush,
    PreviousBrush,
    ReloadBrush,
    TopUpBrush,
    BlotBrush,
    CleanBrush,
    SwapPaints,
    PopupPalette,
    PickPaint,
    PickColour,
    ReloadEachStroke,
    TurnWithStroke,
    SaveBrush,
    RenameBrush,
    DeleteBrush,
    Pause,
    DryNow,
    MixingWell,
    SqueezePaint,
    CleanWell,
    AddLayer,
    LayerFromPicture,
    DuplicateLayer,
    RenameLayer,
    RemoveLayer,
    ClearLayer,
    TransformLayer,
    MergeDown,
    FlattenLayers,
    GroupLayers,
    UngroupLayers,
    ShowLayer,
    LockLayer,
    LayerAbove,
    LayerBelow,
    RaiseLayer,
    LowerLayer,
    SelectRectangle,
    SelectLasso,
    SelectEverything,
    InvertSelection,
    SelectHeight,
    SelectWetness,
    ShowOutline,
    MirrorSymmetry,
    MirrorLevel,
    MoreCopies,
    FewerCopies,
    Ruler,
    Ellipse,
    GuideHandles,
    RemoveGuides,
    TracePicture,
    ShowTracing,
    FitTracing,
    RemoveTracing,
    FitCanvas,
    ActualPixels,
    ZoomIn,
    ZoomOut,
    TurnLeft,
    TurnUpright,
    TurnRight,
    MirrorView,
    CanvasOnly,
    LookLit,
    LookWet,
    LookHeight,
    LookNormals,
    LookFlat,
    ToolPanel,
    ColourPanel,
    PhysicsPanel,
    GuidesPanel,
    LayersPanel,
    TracingPanel,
    HistoryPanel,
    NavigatorPanel,
    LightPanel,
    RecorderPanel,
    MessagesPanel,
    ResetPanels,
    SpaceSrgb,
    SpaceDisplayP3,
    LightD65,
    LightD50,
    LightA,
    LightLed,
    LightFile,
    MoveLight,
    FindCommand,
    EditKeys,
    EditSettings,
    PenSettings,
    MilkTea,
    TeaNewGlass,
    TeaOpenScene,
    TeaSaveScene,
    TeaExportMesh,
    TeaRender,
    TeaPause,
    TeaFullSpeed,
    TeaForce,
    TeaRecentre,
    TeaReverse,
    TeaAxisLeft,
    TeaAxisRight,
    TeaAxisAway,
    TeaAxisNear,
    TeaFrontView,
    GlassTank,
    TankFalling,
    TankTwoLiquids,
    TankOpenScene,
    TankRestart,
    TankBall,
    TankDrain,
    TankWind,
    TankWindLeft,
    TankWindRight,
    TankWindStronger,
    TankWindWeaker,
    TankVelocity,
    TankExportAll,
    TankRender,
    TankRecordPictures,
    TankRecordSurfaces,
};

/// What the window is about: the painting, or a liquid in its place. A command is given in one of them,
/// or in several.
enum class Mode { Painting = 1, Tea = 2, Tank = 4, Liquid = Tea | Tank, Everywhere = Painting | Liquid };

/// Whether both can be given at one time.
constexpr bool meet(Mode a, Mode b) {
    return (static_cast<int>(a) & static_cast<int>(b)) != 0;
}

struct CommandText {
    Command command;
    const char* menu;   ///< the menu it stands in, "" for none
    const char* words;  ///< with the mnemonic
    const char* keys;   ///< Qt key sequences, separated by "; "
    const char* hint;   ///< for the status bar and the tool tip
    bool checkable = false;
    bool starts_group = false;  ///< a separator stands above it
    Mode mode = Mode::Painting;
};

/// In the order of the menus.
std::span<const CommandText> command_list();

/// Its entry in that list.
const CommandText& text_of(Command command);

}  // namespace pastoso::commands
