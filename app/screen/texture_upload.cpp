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
    std::size_t i = next_++;
    if (i < all.surface.size()) {
        changed += qt_rect(all.surface[i].cells);
        textures.upload_surface(all.surface[i]);
        return true;
    }
    i -= all.surface.size();
    if (i < all.colours.size()) {
        changed += qt_rect(all.colours[i].cells);
        textures.upload_colour(all.colours[i]);
        return true;
    }
    i -= all.colours.size();
    if (i >= all.look.size()) return false;
    changed += qt_rect(all.look[i].cells);
    textures.upload_look(all.look[i]);
    return true;
}

}  // namespace pastoso::screen
