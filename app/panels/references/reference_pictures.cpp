#include "panels/references/reference_pictures.hpp"

#include "appearance/picture_view.hpp"
#include "tools/picture_colours.hpp"

#include <algorithm>
#include <ranges>

namespace pastoso::panels {
namespace {

constexpr int kSmallest_px = 128;

void make_grey(QImage& picture) {
    for (int y = 0; y < picture.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x) {
            const pigment::Srgb8 grey = tools::grey_of({static_cast<std::uint8_t>(qRed(line[x])),
                                                        static_cast<std::uint8_t>(qGreen(line[x])),
                                                        static_cast<std::uint8_t>(qBlue(line[x]))});
            line[x] = qRgba(grey[0], grey[1], grey[2], qAlpha(line[x]));
        }
    }
}

/// Each half as wide as the one before.
std::vector<QImage> sizes_of(const pigment::Picture& picture, bool grey,
                             const appearance::ScreenCube& cube) {
    QImage whole = appearance::view_of_rgba(picture.rgba, picture.width, picture.height)
                       .convertToFormat(QImage::Format_ARGB32);
    if (grey) make_grey(whole);
    std::vector<QImage> sizes = {
        appearance::shown_through(cube, whole).convertToFormat(QImage::Format_ARGB32_Premultiplied)};
    while (std::max(sizes.back().width(), sizes.back().height()) > kSmallest_px) {
        const QImage& last = sizes.back();
        sizes.push_back(last.scaled(std::max(1, last.width() / 2), std::max(1, last.height() / 2),
                                    Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    return sizes;
}

}  // namespace

/// A picture for which there is no memory stays a frame.
ReferencePictures::ReferencePictures(QObject* parent)
    : QObject(parent),
      worker_(
          [this](Job& job) {
              const Sizes sizes = sizes_of(job.key.first->pixels, job.key.second, job.cube);
              QMetaObject::invokeMethod(
                  this, [this, job, sizes] { take(job, sizes); }, Qt::QueuedConnection);
          },
          [](Job&, const core::Message&) {}) {
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &ReferencePictures::forget);
}

QImage ReferencePictures::at(const document::Reference& reference, double width_px) {
    const Key key(reference.picture, reference.look.grey);
    const auto [found, is_new] = sizes_.try_emplace(key);
    if (is_new) worker_.add({key, appearance::screen_colours().cube(), round_});
    const Sizes& sizes = found->second;
    const auto fits = std::ranges::find_if(sizes | std::views::reverse, [width_px](const QImage& size) {
        return size.width() >= width_px;
    });
    if (fits != sizes.rend()) return *fits;
    return sizes.empty() ? QImage() : sizes.front();
}

void ReferencePictures::keep_only(const document::ReferenceBoard& board) {
    std::erase_if(sizes_, [&board](const auto& entry) {
        return std::ranges::none_of(board.references, [&entry](const document::Reference& reference) {
            return reference.picture == entry.first.first && reference.look.grey == entry.first.second;
        });
    });
}

/// What was asked for before the screen's colours changed is asked for anew.
void ReferencePictures::take(const Job& job, const Sizes& sizes) {
    const auto wanted = sizes_.find(job.key);
    if (job.round != round_ || wanted == sizes_.end()) return;
    wanted->second = sizes;
    Q_EMIT made();
}

void ReferencePictures::forget() {
    ++round_;
    worker_.drop();
    sizes_.clear();
    Q_EMIT made();
}

}  // namespace pastoso::panels
