#include "panels/colour/opened_palette.hpp"

#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/paint/swatch_grid.hpp"
#include "panels/parts/section.hpp"
#include "tools/colour_paint.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kColumns = 8, kMostColours = 64;

}  // namespace

OpenedPalette::OpenedPalette(QWidget* parent) : QWidget(parent) {
    name_ = new QLabel(tr("none opened"));
    name_->setObjectName(QStringLiteral("reading"));
    auto* open = new QPushButton(tr("Open..."));
    open->setObjectName(QStringLiteral("open_palette"));
    open->setToolTip(tr("Colours of GIMP, Krita or Inkscape, from a .gpl file"));
    auto* picture = new QPushButton(tr("From a picture..."));
    picture->setObjectName(QStringLiteral("palette_of_picture"));
    picture->setToolTip(tr("Finds the colours that a picture is made of"));
    count_ = new QSpinBox;
    count_->setObjectName(QStringLiteral("palette_colours"));
    count_->setAccessibleName(tr("Colours of the picture"));
    count_->setToolTip(tr("How many colours are looked for"));
    count_->setRange(2, kMostColours);
    count_->setValue(kColumns);
    from_tubes_ = new QCheckBox(tr("As recipes of the tubes"));
    from_tubes_->setObjectName(QStringLiteral("palette_from_tubes"));
    from_tubes_->setToolTip(
        tr("A click dips the brush in the nearest mixture of tubes, not in the colour itself"));
    grid_ = new SwatchGrid(kColumns);
    grid_->setObjectName(QStringLiteral("palette"));
    for (QWidget* widget : {static_cast<QWidget*>(open), static_cast<QWidget*>(picture),
                            static_cast<QWidget*>(from_tubes_)})
        keep_keys_for_canvas(widget);
    auto* files = new QHBoxLayout;
    files->addWidget(name_, 1);
    files->addWidget(open);
    auto* pictures = new QHBoxLayout;
    pictures->addWidget(picture, 1);
    pictures->addWidget(count_);
    auto* column = section(this, tr("From a file"));
    column->addLayout(files);
    column->addLayout(pictures);
    column->addWidget(grid_);
    column->addWidget(from_tubes_);
    from_tubes_->hide();
    connect(open, &QPushButton::clicked, this, &OpenedPalette::file_wanted);
    connect(picture, &QPushButton::clicked, this, [this] { Q_EMIT picture_wanted(count_->value()); });
    connect(from_tubes_, &QCheckBox::toggled, this, &OpenedPalette::find_paints);
    connect(grid_, &SwatchGrid::patch_clicked, this, [this](int index) {
        const document::PaintRecipe paint = choices_.at(static_cast<std::size_t>(index)).paint;
        Q_EMIT paint_chosen(paint);
    });
}

void OpenedPalette::show_palette(const pigment::ColourPalette& palette) {
    palette_ = palette;
    if (!palette.name.empty()) name_->setText(QString::fromStdString(palette.name));
    from_tubes_->setVisible(!palette.colours.empty());
    find_paints();
}

void OpenedPalette::show_swatches(const tools::SwatchView& view) {
    view_ = view;
    show_patches();
}

void OpenedPalette::find_paints() {
    choices_.clear();
    for (const pigment::NamedColour& named : palette_.colours) {
        const document::PaintRecipe paint = tools::colour_paint(named.colour);
        choices_.push_back({from_tubes_->isChecked() ? tools::from_tubes(paint) : paint,
                            QString::fromStdString(named.name)});
    }
    show_patches();
}

void OpenedPalette::show_patches() {
    std::vector<SwatchGrid::Patch> patches;
    for (const Choice& choice : choices_) {
        const QString words = recipe_words(choice.paint);
        patches.push_back({shown_colour(choice.paint, view_),
                           choice.name.isEmpty() ? words : choice.name + ' ' + words});
    }
    grid_->show_patches(patches);
}

}  // namespace pastoso::panels
