#include "start/examples_section.hpp"

#include "panels/parts/fitted_picture.hpp"
#include "panels/parts/gallery.hpp"
#include "start/section.hpp"

namespace pastoso::start {
namespace {

constexpr QSize kPicture(168, 126);

}  // namespace

ExamplesSection::ExamplesSection(QWidget* parent)
    : QWidget(parent), gallery_(new panels::Gallery(kPicture)) {
    auto* column = section_column(this);
    column->addWidget(heading(tr("Examples, painted before your eyes")));
    column->addWidget(gallery_);
    gallery_->setObjectName(QStringLiteral("examples"));
    gallery_->setAccessibleName(tr("Examples"));
    std::vector<panels::Tile> tiles;
    for (const ExamplePainting& example : examples_)
        tiles.push_back(
            {.name = example.name,
             .detail = example.detail,
             .hint = tr("Watch how it is painted, stroke by stroke, and paint on"),
             .picture = panels::fitted(QImage(QString::fromStdString(example.picture.string())),
                                       kPicture, devicePixelRatioF())});
    gallery_->show_tiles(tiles);
    setVisible(!tiles.empty());
    connect(gallery_, &panels::Gallery::chosen, this,
            [this](int number) { Q_EMIT wanted(examples_.at(static_cast<std::size_t>(number))); });
}

void ExamplesSection::fit(int width) {
    gallery_->fit(width);
}

}  // namespace pastoso::start
