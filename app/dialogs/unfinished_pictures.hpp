// Makes pictures of unfinished paintings that have none, without holding up the window.
#pragma once

#include "core/worker.hpp"
#include "journal/recovery.hpp"

#include <filesystem>

#include <QObject>
#include <QPixmap>

namespace pastoso::dialogs {

/// A painting has none before its first checkpoint: it is painted anew from its strokes, which are few
/// then.
class UnfinishedPictures : public QObject {
    Q_OBJECT
  public:
    explicit UnfinishedPictures(QObject* parent = nullptr);

    /// Asks for the picture of a painting where it has none.
    void want(const journal::Unfinished& painting);

  Q_SIGNALS:
    /// The painting has a thumbnail now. Not told of one that cannot be recovered.
    void painted(const pastoso::journal::Unfinished& painting);

  private:
    void paint(journal::Unfinished& painting);

    core::Worker<journal::Unfinished> worker_;
};

}  // namespace pastoso::dialogs
