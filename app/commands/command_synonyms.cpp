#include "commands/command_synonyms.hpp"

#include "commands/command_words.hpp"

#include <algorithm>
#include <iterator>

#include <QtGlobal>

namespace pastoso::commands {
namespace {

struct Synonyms {
    Command command;
    const char* words;  ///< separated by commas
};

constexpr Synonyms kSynonyms[] = {
    {Command::SaveVersion, QT_TR_NOOP("save incremental, iteration")},
    {Command::Export, QT_TR_NOOP("png, jpeg, tiff, save as a picture")},
    {Command::Play, QT_TR_NOOP("replay, playback")},
    {Command::MakeTimelapse, QT_TR_NOOP("video, mp4, speed painting")},
    {Command::PaintAgain, QT_TR_NOOP("upscale, higher resolution, enlarge")},
    {Command::CopyMerged, QT_TR_NOOP("copy visible, copy flattened")},
    {Command::ScaleImage, QT_TR_NOOP("resize image, resolution, dpi")},
    {Command::CanvasSize, QT_TR_NOOP("resize canvas, extend, expand")},
    {Command::CropToSelection, QT_TR_NOOP("trim to selection")},
    {Command::MirrorImageHorizontally, QT_TR_NOOP("flip")},
    {Command::MirrorImageVertically, QT_TR_NOOP("flip")},
    {Command::RotateImage, QT_TR_NOOP("straighten")},
    {Command::SmallerBrush, QT_TR_NOOP("brush size, smaller")},
    {Command::LargerBrush, QT_TR_NOOP("brush size, larger, bigger")},
    {Command::ReloadBrush, QT_TR_NOOP("dip, load")},
    {Command::CleanBrush, QT_TR_NOOP("rinse, wash, smudge, blend")},
    {Command::MoreMedium, QT_TR_NOOP("dilute, water, thinner, solvent")},
    {Command::PopupPalette, QT_TR_NOOP("quick menu, radial menu")},
    {Command::PickPaint, QT_TR_NOOP("eyedropper, colour picker, color picker, pipette")},
    {Command::PickColour, QT_TR_NOOP("eyedropper, color picker, pipette")},
    {Command::BrushEditor, QT_TR_NOOP("brush settings, brush studio, brush engine")},
    {Command::ImportBrushes, QT_TR_NOOP("bundle, brush set, resources")},
    {Command::ExportBrushes, QT_TR_NOOP("bundle, brush set, resources")},
    {Command::DryNow, QT_TR_NOOP("dryer, fast dry, dry layer")},
    {Command::MixingWell, QT_TR_NOOP("mixing palette, mixer, scratchpad")},
    {Command::FillPaint, QT_TR_NOOP("bucket, flood fill")},
    {Command::FillSecond, QT_TR_NOOP("bucket, background fill")},
    {Command::ToneGround, QT_TR_NOOP("imprimatura, background, gesso")},
    {Command::LayerFromPicture, QT_TR_NOOP("import layer, insert image, place image")},
    {Command::RemoveLayer, QT_TR_NOOP("delete layer")},
    {Command::TransformLayer,
     QT_TR_NOOP("free transform, scale, rotate, distort, perspective, skew, move tool")},
    {Command::AdjustDryPaint, QT_TR_NOOP("saturation, hsv, colour balance, color balance")},
    {Command::FlattenLayers, QT_TR_NOOP("merge visible, merge all")},
    {Command::GroupLayers, QT_TR_NOOP("folder, quick group")},
    {Command::LockBare, QT_TR_NOOP("alpha lock, lock transparency")},
    {Command::ClipLayer, QT_TR_NOOP("clipping mask, clipping group, inherit alpha")},
    {Command::SelectRectangle, QT_TR_NOOP("marquee, rectangular selection")},
    {Command::SelectEllipse, QT_TR_NOOP("marquee, elliptical selection, oval, circle")},
    {Command::SelectLasso, QT_TR_NOOP("freehand selection")},
    {Command::SelectContiguous, QT_TR_NOOP("magic wand, automatic selection")},
    {Command::SelectSimilar, QT_TR_NOOP("magic wand, colour range, color range")},
    {Command::SelectEverything, QT_TR_NOOP("deselect, select none, select all")},
    {Command::InvertSelection, QT_TR_NOOP("inverse")},
    {Command::GrowSelection, QT_TR_NOOP("expand")},
    {Command::ShrinkSelection, QT_TR_NOOP("contract")},
    {Command::FeatherSelection, QT_TR_NOOP("soften, blur edge")},
    {Command::SelectPaint, QT_TR_NOOP("select opaque, alpha to selection")},
    {Command::MaskingFluid, QT_TR_NOOP("frisket, liquid mask, drawing gum")},
    {Command::MaskingTape, QT_TR_NOOP("frisket, stencil")},
    {Command::MaskSelection, QT_TR_NOOP("frisket, stencil, protect")},
    {Command::PeelMasking, QT_TR_NOOP("remove frisket")},
    {Command::ShowOutline, QT_TR_NOOP("marching ants, display selection")},
    {Command::MirrorSymmetry, QT_TR_NOOP("symmetry tool, multibrush")},
    {Command::MirrorLevel, QT_TR_NOOP("symmetry tool, multibrush")},
    {Command::MoreCopies, QT_TR_NOOP("radial symmetry, multibrush, mandala")},
    {Command::Ruler, QT_TR_NOOP("assistant, straight line, drawing guide")},
    {Command::ParallelRuler, QT_TR_NOOP("assistant, drawing guide")},
    {Command::Ellipse, QT_TR_NOOP("assistant, drawing guide")},
    {Command::ConcentricEllipse, QT_TR_NOOP("assistant, drawing guide")},
    {Command::OnePointPerspective, QT_TR_NOOP("assistant, vanishing point")},
    {Command::TwoPointPerspective, QT_TR_NOOP("assistant, vanishing point")},
    {Command::ThreePointPerspective, QT_TR_NOOP("assistant, vanishing point")},
    {Command::GuideGrid, QT_TR_NOOP("assistant, drawing guide")},
    {Command::SnapToGuide, QT_TR_NOOP("assistant, snapping")},
    {Command::TracePicture, QT_TR_NOOP("tracing paper, light table, template")},
    {Command::AddReference, QT_TR_NOOP("reference image, mood board")},
    {Command::MirrorView, QT_TR_NOOP("flip canvas")},
    {Command::CanvasOnly, QT_TR_NOOP("hide panels, canvas-only mode")},
    {Command::ValueCheck, QT_TR_NOOP("greyscale, grayscale, black and white, desaturate")},
    {Command::SoftProof, QT_TR_NOOP("cmyk, print preview")},
    {Command::BrushesPanel, QT_TR_NOOP("brush library, presets")},
    {Command::EaselPanel, QT_TR_NOOP("gravity, drips, canvas tilt")},
    {Command::ColourPanel, QT_TR_NOOP("color wheel, colour selector, swatches")},
    {Command::LightPanel, QT_TR_NOOP("gloss, impasto, bump")},
    {Command::NavigatorPanel, QT_TR_NOOP("overview")},
    {Command::ResetPanels, QT_TR_NOOP("default layout, reset workspace")},
    {Command::FindCommand, QT_TR_NOOP("search actions")},
    {Command::EditKeys, QT_TR_NOOP("shortcuts, hotkeys, keyboard")},
    {Command::EditSettings, QT_TR_NOOP("preferences, configure, options, theme, language")},
    {Command::PenSettings, QT_TR_NOOP("stylus, pressure curve")},
    {Command::Tour, QT_TR_NOOP("tutorial, getting started")},
};

}  // namespace

QString synonyms_of(Command command) {
    const auto* found = std::find_if(std::begin(kSynonyms), std::end(kSynonyms),
                                     [&](const Synonyms& one) { return one.command == command; });
    if (found == std::end(kSynonyms)) return {};
    return words_of(found->words) + QStringLiteral(", ") + QString::fromUtf8(found->words);
}

}  // namespace pastoso::commands
