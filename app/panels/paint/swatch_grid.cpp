#include "panels/paint/swatch_grid.hpp"

#include "panels/paint/paint_swatch.hpp"

#include <QGridLayout>

namespace pastoso::panels {

SwatchGrid::SwatchGrid(int columns, QWidget* parent) : QWidget(parent), columns_(columns) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    for (int column = 0; column < columns; ++column)
        grid->setColumnStretch(column, 1);
}

void SwatchGrid::show_patches(const std::vector<Patch>& patches) {
    auto* grid = static_cast<QGridLayout*>(layout());
    while (swatches_.size() < patches.size()) {
        const int index = static_cast<int>(swatches_.size());
        auto* swatch = new PaintSwatch;
        connect(swatch, &QPushButton::clicked, this, [this, index] { Q_EMIT patch_clicked(index); });
        connect(swatch, &PaintSwatch::removal_wanted, this,
                [this, index] { Q_EMIT removal_wanted(index); });
        grid->addWidget(swatch, index / columns_, index % columns_);
        swatches_.push_back(swatch);
    }
    for (std::size_t i = 0; i < swatches_.size(); ++i) {
        swatches_[i]->setVisible(i < patches.size());
        if (i < patches.size()) swatches_[i]->show_paint(patches[i].colour, patches[i].words);
    }
}

}  // namespace pastoso::panels
