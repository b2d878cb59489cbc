#include "panels/colour/colour_panel.hpp"

#include "appearance/shown_number.hpp"
#include "appearance/terms.hpp"
#include "panels/colour/colour_picker.hpp"
#include "panels/colour/mixes_part.hpp"
#include "panels/colour/opened_palette.hpp"
#include "panels/paint/paint_swatch.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/parts/section.hpp"
#include "pigment/paint_name.hpp"
#include "pigment/recipe.hpp"
#include "tools/colour_paint.hpp"
#include "tools/drawdown.hpp"
#include "tools/picked_paint.hpp"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kColumns = 8;

}  // namespace

ColourPanel::ColourPanel(const std::vector<QAction*>& picks, QWidget* parent) : QWidget(parent) {
    picker_ = new ColourPicker(recipe_part());
    auto* column = section(this, tr("Mix a colour"));
    column->addWidget(picker_);
    column->addWidget(button_row(picks));
    column->addWidget(kept_part());
    column->addWidget(mixes_part());
    column->addWidget(recent_part());
    column->addWidget(palette_part());
    column->addStretch(1);
    connect(picker_, &ColourPicker::looked_at, this, &ColourPanel::show_colour);
    connect(picker_, &ColourPicker::chosen, this,
            [this](const pigment::Srgb8& colour) { Q_EMIT paint_chosen(tools::colour_paint(colour)); });
    connect(picker_, &ColourPicker::aids_changed, this, [this] {
        shelf_.aids = picker_->aids();
        Q_EMIT shelf_changed();
    });
    connect(picker_, &ColourPicker::refused, this, &ColourPanel::refused);
    show_colour(picker_->colour());
    show_kept();
    show_mixes();
}

QWidget* ColourPanel::recipe_part() {
    auto* part = new QWidget;
    auto* column = section(part, tr("Nearest from the tubes"));
    wanted_ = new PaintSwatch;
    wanted_->setObjectName(QStringLiteral("wanted_colour"));
    nearest_ = new PaintSwatch;
    nearest_->setObjectName(QStringLiteral("nearest_colour"));
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(wanted_, 1);
    row->addWidget(nearest_, 1);
    row->addSpacing(6);
    words_ = new QLabel;
    words_->setObjectName(QStringLiteral("recipe"));
    words_->setWordWrap(true);
    appearance::explain(words_, appearance::Term::ColourDifference);
    words_->setMinimumHeight(5 * words_->fontMetrics().lineSpacing() + 2);
    words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    use_recipe_ = new QPushButton(tr("Use the recipe"));
    use_recipe_->setObjectName(QStringLiteral("use_recipe"));
    use_recipe_->setToolTip(tr("Dip the brush in this mixture from the tubes instead"));
    keep_keys_for_canvas(use_recipe_);
    row->addWidget(use_recipe_);
    column->addLayout(row);
    column->addWidget(words_);
    connect(wanted_, &QPushButton::clicked, this,
            [this] { Q_EMIT paint_chosen(tools::colour_paint(picker_->colour())); });
    const auto take_recipe = [this] { Q_EMIT paint_chosen(document::PaintRecipe(nearest_paint_)); };
    connect(nearest_, &QPushButton::clicked, this, take_recipe);
    connect(use_recipe_, &QPushButton::clicked, this, take_recipe);
    return part;
}

QWidget* ColourPanel::recent_part() {
    auto* part = new QWidget;
    auto* column = section(part, tr("Used before"));
    recent_grid_ = new SwatchGrid(kColumns);
    recent_grid_->setObjectName(QStringLiteral("recent_paints"));
    column->addWidget(recent_grid_);
    connect(recent_grid_, &SwatchGrid::patch_clicked, this, [this](int index) {
        const document::PaintRecipe paint = shelf_.recent.at(static_cast<std::size_t>(index));
        Q_EMIT paint_chosen(paint);
    });
    return part;
}

QWidget* ColourPanel::kept_part() {
    auto* part = new QWidget;
    auto* column = section(part, tr("Your palette"));
    kept_hint_ = new QLabel(tr("Paints that you keep stay here."));
    kept_hint_->setObjectName(QStringLiteral("reading"));
    kept_hint_->setWordWrap(true);
    auto* keep = new QPushButton(tr("Keep"));
    keep->setObjectName(QStringLiteral("keep_paint"));
    keep->setToolTip(tr("Lay the paint in hand out on your palette"));
    keep_keys_for_canvas(keep);
    save_ = new QPushButton(tr("Save..."));
    save_->setObjectName(QStringLiteral("save_palette"));
    save_->setToolTip(tr("The colours of your palette for GIMP, Krita or Inkscape, as a .gpl file"));
    keep_keys_for_canvas(save_);
    connect(save_, &QPushButton::clicked, this, &ColourPanel::palette_save_wanted);
    auto* row = new QHBoxLayout;
    row->addWidget(keep, 1);
    row->addWidget(save_, 1);
    kept_grid_ = new SwatchGrid(kColumns);
    kept_grid_->setObjectName(QStringLiteral("kept_paints"));
    column->addWidget(kept_grid_);
    column->addWidget(kept_hint_);
    column->addLayout(row);
    connect(keep, &QPushButton::clicked, this, &ColourPanel::keep_paint_in_hand);
    connect(kept_grid_, &SwatchGrid::removal_wanted, this, &ColourPanel::remove_kept);
    connect(kept_grid_, &SwatchGrid::patch_clicked, this, [this](int index) {
        const document::PaintRecipe paint = shelf_.kept.at(static_cast<std::size_t>(index));
        Q_EMIT paint_chosen(paint);
    });
    return part;
}

QWidget* ColourPanel::mixes_part() {
    mixes_ = new MixesPart;
    connect(mixes_, &MixesPart::keep_wanted, this, &ColourPanel::keep_mix_in_hand);
    connect(mixes_, &MixesPart::export_wanted, this, &ColourPanel::export_wanted);
    connect(mixes_, &MixesPart::import_wanted, this, &ColourPanel::import_wanted);
    connect(mixes_, &MixesPart::taken, this, [this](int index) {
        const document::PaintRecipe paint = shelf_.mixes.at(static_cast<std::size_t>(index)).paint;
        Q_EMIT paint_chosen(paint);
    });
    connect(mixes_, &MixesPart::removal_wanted, this, [this](int index) {
        shelf_.mixes.erase(shelf_.mixes.begin() + index);
        show_mixes();
        Q_EMIT shelf_changed();
    });
    connect(mixes_, &MixesPart::renamed, this, [this](int index, const QString& name) {
        tools::rename_mix(static_cast<std::size_t>(index), name.trimmed().toStdString(), shelf_);
        Q_EMIT shelf_changed();
        // Later: the list is still busy with the name.
        QMetaObject::invokeMethod(this, &ColourPanel::show_mixes, Qt::QueuedConnection);
    });
    return mixes_;
}

QWidget* ColourPanel::palette_part() {
    opened_ = new OpenedPalette;
    connect(opened_, &OpenedPalette::file_wanted, this, &ColourPanel::palette_wanted);
    connect(opened_, &OpenedPalette::picture_wanted, this, &ColourPanel::picture_wanted);
    connect(opened_, &OpenedPalette::paint_chosen, this, &ColourPanel::paint_chosen);
    return opened_;
}

void ColourPanel::show_colour(const pigment::Srgb8& colour) {
    wanted_colour_ = colour;
    show_wanted();
    const pigment::Recipe recipe = tools::closest_in_box(colour);
    show_nearest(tools::recipe_paint(recipe), recipe.difference);
}

void ColourPanel::show_wanted() {
    const document::PaintRecipe paint = tools::colour_paint(wanted_colour_);
    wanted_->show_drawdown(tools::drawdown(paint, view_));
    wanted_->show_paint(shown_colour(paint, view_),
                        tr("The colour itself, as a paint of its own: %1")
                            .arg(QString::fromStdString(pigment::hex_colour(wanted_colour_))));
}

void ColourPanel::show_nearest_paint() {
    const tools::Drawdown drawn = tools::drawdown(nearest_paint_, view_);
    nearest_->show_drawdown(drawn);
    nearest_->show_paint(shown_colour(nearest_paint_, view_), paint_words(nearest_paint_, drawn.hiding));
    words_->setText(tr("%1\nΔE %2, %3; %4")
                        .arg(recipe_lines(nearest_paint_),
                             appearance::shown_number(nearest_difference_, 1),
                             difference_words(nearest_difference_), hiding_words(drawn.hiding)));
}

void ColourPanel::show_nearest(const document::PaintRecipe& paint, double difference) {
    nearest_paint_ = paint;
    nearest_difference_ = difference;
    show_nearest_paint();
    use_recipe_->setEnabled(!(paint == in_hand_));
}

/// What comes from the tubes is its own recipe, whatever else would look the same.
void ColourPanel::show_paint(const document::PaintRecipe& paint) {
    if (paint == in_hand_) return;
    in_hand_ = paint;
    tools::note_recent(paint, shelf_);
    show_recent();
    Q_EMIT shelf_changed();
    use_recipe_->setEnabled(!(paint == nearest_paint_));
    const auto& parts = paint.ingredients;
    if (parts.empty() || paint == nearest_paint_) return;
    picker_->show_colour(tools::screen_colour(paint));
    const bool from_tubes = std::none_of(parts.begin(), parts.end(), [](const auto& part) {
        return pigment::names_a_colour(part.pigment);
    });
    if (from_tubes) show_nearest(paint, 0.0);
}

void ColourPanel::show_swatches(const tools::SwatchView& view) {
    view_ = view;
    show_wanted();
    show_nearest_paint();
    show_recent();
    show_kept();
    show_mixes();
    opened_->show_swatches(view);
}

// ---- the shelf

std::vector<SwatchGrid::Patch> ColourPanel::patches_of(const std::vector<document::PaintRecipe>& paints,
                                                       const QString& words) const {
    std::vector<SwatchGrid::Patch> patches;
    for (const document::PaintRecipe& paint : paints)
        patches.push_back(
            {shown_colour(paint, view_), words.arg(paint_words(paint, tools::hiding_of(paint, view_)))});
    return patches;
}

void ColourPanel::show_shelf(const tools::PaintShelf& shelf) {
    shelf_ = shelf;
    picker_->show_aids(shelf.aids);
    show_recent();
    show_kept();
    show_mixes();
    opened_->show_palette(shelf.opened);
}

int ColourPanel::add_paints(const tools::PaintShelf& set) {
    const int added = tools::add_paint_set(set, shelf_);
    show_kept();
    show_mixes();
    if (added > 0) Q_EMIT shelf_changed();
    return added;
}

void ColourPanel::keep_paint_in_hand() {
    if (!tools::keep_paint(in_hand_, shelf_))
        return void(Q_EMIT refused(tr("Your palette is full: the right button takes a paint away.")));
    show_kept();
    Q_EMIT shelf_changed();
}

/// Its name is that of its tubes until the painter has typed another.
void ColourPanel::keep_mix_in_hand() {
    const document::PaintRecipe paint = tools::from_tubes(in_hand_);
    if (!tools::keep_mix({recipe_words(paint).toStdString(), paint}, shelf_))
        return void(Q_EMIT refused(tr("There is no room for more mixes; take one away first.")));
    show_mixes();
    Q_EMIT shelf_changed();
    mixes_->ask_name(static_cast<int>(shelf_.mixes.size()) - 1);
}

void ColourPanel::remove_kept(int index) {
    shelf_.kept.erase(shelf_.kept.begin() + index);
    show_kept();
    Q_EMIT shelf_changed();
}

void ColourPanel::show_palette(const pigment::ColourPalette& palette) {
    shelf_.opened = palette;
    opened_->show_palette(palette);
    Q_EMIT shelf_changed();
}

void ColourPanel::show_recent() {
    recent_grid_->show_patches(patches_of(shelf_.recent, QStringLiteral("%1")));
}

void ColourPanel::show_kept() {
    kept_grid_->show_patches(
        patches_of(shelf_.kept, tr("%1\nThe right button, or Delete, takes it away.")));
    kept_grid_->setVisible(!shelf_.kept.empty());
    allow_saving();
    kept_hint_->setVisible(shelf_.kept.empty());
}

void ColourPanel::show_mixes() {
    mixes_->show_mixes(shelf_.mixes, view_);
    allow_saving();
}

void ColourPanel::allow_saving() {
    const bool any = !shelf_.kept.empty() || !shelf_.mixes.empty();
    save_->setEnabled(any);
    mixes_->allow_export(any);
}

}  // namespace pastoso::panels
