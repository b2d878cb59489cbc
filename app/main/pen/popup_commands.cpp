#include "main/pen/popup_commands.hpp"

#include "appearance/picture_view.hpp"
#include "core/user_data.hpp"
#include "main/paint/swatches.hpp"
#include "main/pen/brush_jar.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/popup/popup_palette.hpp"
#include "pigment/box.hpp"
#include "tools/colour_paint.hpp"
#include "tools/drawdown.hpp"

#include <algorithm>

#include <QAction>
#include <QCursor>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr std::size_t kPaints = 16, kMostKept = 8;

panels::SwatchGrid::Patch patch_of(const document::PaintRecipe& paint, const tools::SwatchView& view) {
    return {panels::shown_colour(paint, view),
            panels::paint_words(paint, tools::hiding_of(paint, view))};
}

/// Some of those that the painter keeps, then the latest, then tubes of the box: each once.
std::vector<document::PaintRecipe> paints_at_hand(const tools::PaintShelf& shelf) {
    std::vector<document::PaintRecipe> paints;
    const auto add = [&](const document::PaintRecipe& paint, std::size_t most) {
        const bool known = std::find(paints.begin(), paints.end(), paint) != paints.end();
        if (!known && paints.size() < most) paints.push_back(paint);
    };
    for (const document::PaintRecipe& paint : shelf.kept)
        add(paint, kMostKept);
    for (const document::PaintRecipe& paint : shelf.recent)
        add(paint, kPaints);
    for (const pigment::Pigment& tube : pigment::default_box())
        add({{{tube.ci_name, 1.0}}, 1.0}, kPaints);
    return paints;
}

}  // namespace

PopupCommands::PopupCommands(Studio& studio, BrushJar& brushes, const Swatches& swatches,
                             const panels::ColourPanel* colours)
    : studio_(studio),
      brushes_(brushes),
      swatches_(swatches),
      colours_(colours),
      file_(studio, core::user_data_path("popup.json"),
            [](const auto& file) { tools::read_tool_slots(file); }) {
    studio_.commands().on(Command::PopupPalette, [this](bool) { open_at_pointer(); });
    for (const interactions::OnCanvas* on : studio_.on_views())
        connect(&on->buttons, &interactions::Buttons::palette_wanted, this, &PopupCommands::open);
    connect(&studio_, &Studio::hand_changed, this,
            [this](const tools::Hand& hand) { tools::note_use(hand.brush, slots_); });
}

void PopupCommands::recall() {
    file_.recall([this](const auto& file) { slots_ = tools::read_tool_slots(file); });
}

void PopupCommands::remember() {
    file_.remember([this](const auto& file) { tools::write_tool_slots(slots_, file); });
}

void PopupCommands::make_palette() {
    const commands::CommandRegistry& commands = studio_.commands();
    commands.action(Command::MirrorView)->setIconText(tr("Mirror"));
    commands.action(Command::FitCanvas)->setIconText(tr("Fit"));
    palette_ = new panels::PopupPalette(
        static_cast<int>(tools::kToolSlots), static_cast<int>(kPaints),
        {commands.action(Command::Undo), commands.action(Command::DryNow),
         commands.action(Command::MirrorView), commands.action(Command::FitCanvas)},
        &studio_.window());
    connect(palette_, &panels::PopupPalette::tool_chosen, &brushes_, &BrushJar::take);
    connect(palette_, &panels::PopupPalette::paint_chosen, this,
            [this](int index) { studio_.choose_paint(paints_[static_cast<std::size_t>(index)]); });
    connect(palette_, &panels::PopupPalette::paints_swapped, this,
            [this] { studio_.commands().action(Command::SwapPaints)->trigger(); });
    connect(palette_, &panels::PopupPalette::width_stepped, this, [this](int steps) {
        const auto step = steps > 0 ? Command::LargerBrush : Command::SmallerBrush;
        studio_.commands().action(step)->trigger();
        palette_->show_width(studio_.easel().hand().brush_width_mm);
    });
    connect(palette_, &panels::PopupPalette::share_chosen, this, [this](double share) {
        studio_.easel().set_paint_share(share);
        studio_.show_hand();
        show_content();
    });
    const double pixels = studio_.window().devicePixelRatioF();
    const int side = static_cast<int>(panels::PopupPalette::kThumbnail * pixels);
    thumbnails_ = std::make_unique<session::ThumbnailPainter>(
        side, side,
        [palette = palette_](const std::string& name, const pigment::Image8& thumbnail) {
            const QImage image = appearance::view_of(thumbnail).copy();
            QMetaObject::invokeMethod(palette, [palette, name = QString::fromStdString(name), image] {
                palette->set_thumbnail(name, image);
            });
        },
        studio_.teller());
}

void PopupCommands::open_at_pointer() {
    const view::CanvasView& canvas = studio_.canvas();
    const QPoint pointer = QCursor::pos();
    const bool above = canvas.rect().contains(canvas.mapFromGlobal(pointer));
    open(above ? pointer : canvas.mapToGlobal(canvas.rect().center()));
}

void PopupCommands::open(const QPoint& place) {
    if (palette_ == nullptr) make_palette();
    show_content();
    palette_->open_at(place);
    want_thumbnails();
}

/// A tool that is there no more leaves its place to another.
void PopupCommands::show_content() {
    const tools::Hand& hand = studio_.easel().hand();
    panels::PopupPalette::Content content;
    for (const tools::ToolSlot& slot : slots_)
        if (brush::find_entry(brushes_.library(), slot.tool) != nullptr)
            content.tools.push_back(QString::fromStdString(slot.tool));
    content.tool_in_hand = QString::fromStdString(hand.brush);
    paints_ = paints_at_hand(colours_->shelf());
    for (const document::PaintRecipe& paint : paints_)
        content.paints.push_back(patch_of(paint, swatches_.view()));
    content.paint = patch_of(hand.paint, swatches_.view());
    content.second_paint = patch_of(hand.second_paint, swatches_.view());
    palette_->show_content(content);
    palette_->show_width(hand.brush_width_mm);
    palette_->show_thinning(hand);
}

/// Each once, as long as the palette has its tool.
void PopupCommands::want_thumbnails() {
    for (const tools::ToolSlot& slot : slots_) {
        const auto* entry = brush::find_entry(brushes_.library(), slot.tool);
        if (entry == nullptr || shown_.contains(slot.tool)) continue;
        thumbnails_->want(entry->preset);
    }
    shown_.clear();
    for (const tools::ToolSlot& slot : slots_)
        shown_.insert(slot.tool);
}

}  // namespace pastoso::main
