#include "start/new_canvas_section.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "document/canvas.hpp"
#include "start/section.hpp"
#include "start/support_picture.hpp"

#include <algorithm>

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QToolButton>

namespace pastoso::start {
namespace {

constexpr int kMostColumns = 3, kSpacing_px = 6;
constexpr QSize kSheetRoom(96, 62), kSwatch_px(64, 40), kSwatchIcon(32, 20);

/// Why there can be no such canvas now; empty where there can.
QString objection(const document::CanvasSettings& canvas) {
    try {
        document::check_canvas_fits(canvas, core::available_memory_bytes());
        return {};
    } catch (const core::InputError& error) {
        return appearance::shown_message(error.message());
    }
}

/// The scale in which all of them have room.
double sheet_px_per_mm(const std::vector<CanvasSize>& sizes, bool upright) {
    double scale = 1.0;
    for (const CanvasSize& size : sizes) {
        const double width_mm = upright ? size.shorter_mm : size.longer_mm;
        const double height_mm = upright ? size.longer_mm : size.shorter_mm;
        scale = std::min({scale, kSheetRoom.width() / width_mm, kSheetRoom.height() / height_mm});
    }
    return scale;
}

}  // namespace

NewCanvasSection::NewCanvasSection(QWidget* parent)
    : QWidget(parent), sizes_(new panels::Gallery(kSheetRoom)) {
    auto* column = section_column(this);
    auto* choices = new QHBoxLayout;
    choices->setSpacing(6);
    choices->addWidget(heading(tr("New canvas")));
    choices->addStretch(1);
    support_grid_ = new QGridLayout;
    support_grid_->setSpacing(kSpacing_px);
    add_supports();
    add_orientations(choices);
    column->addLayout(choices);
    column->addLayout(support_grid_);
    column->addWidget(sizes_);
    sizes_->setObjectName(QStringLiteral("canvas_sizes"));
    sizes_->setAccessibleName(tr("Sizes of a new canvas"));
    connect(sizes_, &panels::Gallery::chosen, this, &NewCanvasSection::choose);
    show_sizes();
}

QToolButton* NewCanvasSection::make_choice(const QString& words, const QString& hint) {
    auto* button = new QToolButton;
    button->setText(words);
    button->setToolTip(hint);
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(button, &QToolButton::toggled, this, [this](bool chosen) {
        if (chosen) show_sizes();
    });
    return button;
}

void NewCanvasSection::add_supports() {
    auto* group = new QButtonGroup(this);
    for (const dialogs::Support& support : supports_) {
        support_pictures_.push_back(support_picture(support.id, kSwatch_px));
        QToolButton* button = make_choice(QLatin1Char(' ') + support.name,
                                          tr("%1: %2").arg(support.name, support.detail));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setObjectName(QStringLiteral("support_") + QString::fromStdString(support.id));
        const auto draw = [button, picture = support_pictures_.back()] {
            button->setIcon(edged(appearance::shown(picture)));
        };
        draw();
        connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, button, draw);
        button->setIconSize(kSwatchIcon);
        group->addButton(button);
        support_buttons_.push_back(button);
    }
    support_buttons_.front()->setChecked(true);
    lay_supports(kMostColumns);
}

void NewCanvasSection::lay_supports(int columns) {
    for (int number = 0; number < static_cast<int>(support_buttons_.size()); ++number)
        support_grid_->addWidget(support_buttons_[static_cast<std::size_t>(number)], number / columns,
                                 number % columns);
}

void NewCanvasSection::add_orientations(QLayout* row) {
    lying_ = make_choice(tr("Landscape"), tr("Wider than high"));
    upright_ = make_choice(tr("Portrait"), tr("Higher than wide"));
    row->addWidget(lying_);
    row->addWidget(upright_);
    lying_->setObjectName(QStringLiteral("landscape"));
    upright_->setObjectName(QStringLiteral("portrait"));
    auto* group = new QButtonGroup(this);
    group->addButton(lying_);
    group->addButton(upright_);
    lying_->setChecked(true);
}

void NewCanvasSection::propose(const document::CanvasSettings& canvas, double live_px_per_mm) {
    machine_ = {live_px_per_mm, core::available_memory_bytes()};
    (canvas.height_mm > canvas.width_mm ? upright_ : lying_)->setChecked(true);
    for (std::size_t i = 0; i < supports_.size(); ++i)
        if (supports_[i].id == canvas.support) support_buttons_[i]->setChecked(true);
    show_sizes();
}

void NewCanvasSection::fit(int width) {
    int widest = 1;
    for (const QToolButton* button : support_buttons_) {
        widest = std::max(widest, button->sizeHint().width());
    }
    lay_supports(std::clamp((width + kSpacing_px) / (widest + kSpacing_px), 1, kMostColumns));
    sizes_->fit(width);
}

bool NewCanvasSection::upright() const {
    return upright_ != nullptr && upright_->isChecked();
}

std::size_t NewCanvasSection::support() const {
    for (std::size_t i = 0; i < support_buttons_.size(); ++i)
        if (support_buttons_[i]->isChecked()) return i;
    return 0;
}

document::CanvasSettings NewCanvasSection::canvas(int number) const {
    return canvas_of(canvas_sizes_.at(static_cast<std::size_t>(number)), upright(),
                     supports_.at(support()).id, machine_);
}

/// While the buttons are being made there is nothing to show yet.
void NewCanvasSection::show_sizes() {
    if (upright_ == nullptr) return;
    std::vector<panels::Tile> tiles;
    for (int i = 0; i < static_cast<int>(canvas_sizes_.size()); ++i)
        tiles.push_back(tile_of(canvas(i), canvas_sizes_[static_cast<std::size_t>(i)].name));
    tiles.push_back({.name = tr("More..."),
                     .detail = tr("Any size"),
                     .hint = tr("Choose width, height, resolution and support yourself")});
    if (sizes_->count() == static_cast<int>(tiles.size()))
        for (std::size_t i = 0; i < tiles.size(); ++i)
            sizes_->show_tile(static_cast<int>(i), tiles[i]);
    else
        sizes_->show_tiles(tiles);
}

panels::Tile NewCanvasSection::tile_of(const document::CanvasSettings& canvas,
                                       const QString& name) const {
    const grid::Shape shape = document::canvas_shape(canvas);
    const QString why_not = objection(canvas);
    const QString hint = tr("%1, %2 × %3 pixels, %4 px/mm")
                             .arg(size_words(canvas))
                             .arg(shape.width)
                             .arg(shape.height)
                             .arg(appearance::shown_number(canvas.px_per_mm));
    return {.name = name,
            .detail = size_words(canvas),
            .hint = why_not.isEmpty() ? hint : why_not,
            .picture = sheet_picture({canvas.width_mm, canvas.height_mm},
                                     sheet_px_per_mm(canvas_sizes_, upright()), kSheetRoom,
                                     support_pictures_[support()], devicePixelRatioF()),
            .faint = !why_not.isEmpty()};
}

void NewCanvasSection::choose(int number) {
    if (number >= static_cast<int>(canvas_sizes_.size()))
        Q_EMIT more_wanted();
    else
        Q_EMIT wanted(canvas(number));
}

}  // namespace pastoso::start
