// Puts a presentation onto the graphics card, a little in every frame.
#pragma once

#include "screen/canvas_presenter.hpp"
#include "screen/canvas_textures.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include <QRegion>

namespace pastoso::screen {

class TextureUpload {
  public:
    void begin(Presentation presentation);

    /// Whether there is one that is not yet on the card.
    bool active() const { return presentation_.has_value(); }
    const Presentation& presentation() const { return *presentation_; }

    /// Goes on for about so long; adds the cells whose picture is another to `changed`. True: all of it
    /// is there.
    bool go_on(double seconds, CanvasTextures& textures, QRegion& changed);

    /// It will not be finished, or is.
    Presentation end() { return *std::exchange(presentation_, std::nullopt); }

  private:
    bool upload_next(CanvasTextures& textures, QRegion& changed);

    std::optional<Presentation> presentation_;
    std::size_t next_ = 0;  ///< of its patches, of all kinds
};

}  // namespace pastoso::screen
