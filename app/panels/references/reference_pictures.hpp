// The pictures of a board as they are drawn: in the colours of the screen, each in several sizes, made
// beside the window.
#pragma once

#include "appearance/screen_colours.hpp"
#include "core/worker.hpp"
#include "document/references.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <QImage>
#include <QObject>

namespace pastoso::panels {

/// All is to be called on the window's thread.
class ReferencePictures : public QObject {
    Q_OBJECT
  public:
    explicit ReferencePictures(QObject* parent = nullptr);

    /// The smallest size with so many pixels across, or the picture's own. Null until it is made, which
    /// begins with the first call.
    QImage at(const document::Reference& reference, double width_px);

    /// Forgets what none of these needs.
    void keep_only(const document::ReferenceBoard& board);

    /// Until all that was asked for is made; it is there after the events that wait.
    void wait() { worker_.wait(); }

  Q_SIGNALS:
    void made();

  private:
    /// From the largest.
    using Sizes = std::vector<QImage>;
    /// The picture, and whether it is grey.
    using Key = std::pair<document::SharedReferencePicture, bool>;
    struct Job {
        Key key;
        appearance::ScreenCube cube;
        std::uint64_t round = 0;
    };

    void take(const Job& job, const Sizes& sizes);
    void forget();

    std::map<Key, Sizes> sizes_;  ///< empty while they are made
    std::uint64_t round_ = 0;     ///< of the screen's colours
    core::Worker<Job> worker_;    ///< the last: it ends before what it works with
};

}  // namespace pastoso::panels
