#include "screen/texture_upload.hpp"

#include "screen/qt_rect.hpp"

#include <QElapsedTimer>

namespace pastoso::screen {
void TextureUpload::begin(Presentation presentation) {
    presentation_ = std::move(presentation);
    next_ = 0;
}

bool TextureUpload::go_on(double seconds, CanvasTextures& textures, QRegion& changed) {
    QElapsedTimer timer;
    timer.start();
    while (1e-9 * static_cast<double>(timer.nsecsElapsed()) < seconds)
        if (!upload_next(textures, changed)) return true;
    return false;
}

/// False when there is no more. Where paint is another, its relief is too.
bool TextureUpload::upload_next(CanvasTextures& textures, QRegion& changed) {
    const Presentation& all = *presentation_;
    std::size_t number = next_++;
    const auto put = [&](const auto& patches, auto upload) {
        if (number >= patches.size()) {
            number -= patches.size();
            return false;
        }
        changed += qt_rect(patches[number].cells);
        (textures.*upload)(patches[number]);
        return true;
    };
    return put(all.surface, &CanvasTextures::upload_surface) ||
           put(all.colours, &CanvasTextures::upload_colour) ||
           put(all.look, &CanvasTextures::upload_look) ||
           put(all.outlines, &CanvasTextures::upload_outlines);
}

}  // namespace pastoso::screen
