#include "start/recent_section.hpp"

#include "appearance/shown_time.hpp"
#include "panels/parts/fitted_picture.hpp"
#include "panels/parts/gallery.hpp"
#include "start/section.hpp"

#include <QDir>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>

namespace pastoso::start {
namespace {

constexpr QSize kPicture(112, 84);

QString text(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

/// The home folder is "~": what follows is what tells paintings apart.
QString folder_words(const std::filesystem::path& path) {
    const QString folder = text(path.parent_path()), home = QDir::homePath();
    const bool at_home = folder == home || folder.startsWith(home + QLatin1Char('/'));
    return at_home ? QStringLiteral("~") + folder.mid(home.size()) : folder;
}

QString time_words(const QDateTime& time) {
    if (time.date() == QDate::currentDate())
        return RecentSection::tr("Today, %1").arg(appearance::shown_time(time.time()));
    if (time.date() == QDate::currentDate().addDays(-1))
        return RecentSection::tr("Yesterday, %1").arg(appearance::shown_time(time.time()));
    return QLocale().toString(time.date(), QLocale::ShortFormat);
}

panels::Tile tile_of(const PaintingFile& file, double pixel_ratio) {
    panels::Tile tile{.name = text(file.path.stem()),
                      .detail = folder_words(file.path) + QLatin1Char('\n') +
                                (file.saved.isValid() ? time_words(file.saved) : QString()),
                      .hint = text(file.path),
                      .picture = panels::fitted(file.picture, kPicture, pixel_ratio),
                      .removable = true};
    if (file.fault.isEmpty()) return tile;
    tile.detail = file.fault;
    tile.faint = true;
    if (!file.reason.isEmpty()) tile.hint = file.reason;
    return tile;
}

}  // namespace

RecentSection::RecentSection(QWidget* parent)
    : QWidget(parent), gallery_(new panels::Gallery(kPicture, 2)), none_yet_(new QLabel) {
    auto* column = section_column(this);
    auto* head = new QHBoxLayout;
    head->addWidget(heading(tr("Recent paintings")));
    head->addStretch(1);
    auto* open = new QPushButton(tr("Open a file..."));
    open->setObjectName(QStringLiteral("open_a_file"));
    head->addWidget(open);
    column->addLayout(head);
    column->addWidget(gallery_);
    column->addWidget(none_yet_);
    none_yet_->setObjectName(QStringLiteral("reading"));
    none_yet_->setText(tr("Paintings that you save will stand here."));
    gallery_->setObjectName(QStringLiteral("recent_paintings"));
    gallery_->setAccessibleName(tr("Recent paintings"));
    connect(open, &QPushButton::clicked, this, &RecentSection::open_wanted);
    connect(&reader_, &PaintingReader::finished, this, &RecentSection::note);
    connect(gallery_, &panels::Gallery::chosen, this,
            [this](int number) { Q_EMIT wanted(painting(number).path); });
    connect(gallery_, &panels::Gallery::removal_wanted, this,
            [this](int number) { Q_EMIT removal_wanted(painting(number).path); });
}

const PaintingFile& RecentSection::painting(int number) const {
    return paintings_.at(static_cast<std::size_t>(number));
}

void RecentSection::show_paintings(const std::vector<std::filesystem::path>& paths) {
    paintings_.clear();
    std::vector<panels::Tile> tiles;
    for (const std::filesystem::path& path : paths) {
        paintings_.push_back({path});
        tiles.push_back(tile_of(paintings_.back(), devicePixelRatioF()));
        reader_.read(path);
        ++to_read_;
    }
    gallery_->show_tiles(tiles);
    gallery_->setVisible(!tiles.empty());
    none_yet_->setVisible(tiles.empty());
}

bool RecentSection::all_read() const {
    return to_read_ == 0;
}

/// What is not in the list any more was asked for before it changed.
void RecentSection::note(const PaintingFile& file) {
    --to_read_;
    for (std::size_t i = 0; i < paintings_.size(); ++i) {
        if (paintings_[i].path != file.path) continue;
        paintings_[i] = file;
        gallery_->show_tile(static_cast<int>(i), tile_of(file, devicePixelRatioF()));
    }
}

void RecentSection::fit(int width) {
    gallery_->fit(width);
}

}  // namespace pastoso::start
