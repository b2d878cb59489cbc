// Reads pictures that are to be pressed into paste, without holding up the dialog.
#pragma once

#include "core/worker.hpp"
#include "pigment/image.hpp"

#include <memory>
#include <string>

#include <QObject>
#include <QSize>

namespace pastoso::dialogs {

class StencilReader : public QObject {
    Q_OBJECT
  public:
    using Picture = std::shared_ptr<const pigment::Picture>;

    /// Pictures that are larger are made smaller, in proportion, so that they fit.
    explicit StencilReader(const QSize& most_px);

    /// Asks for a file's picture; those asked for before are not told of any more.
    void want(const std::string& path);

  Q_SIGNALS:
    /// Null where it cannot be read.
    void was_read(const pastoso::dialogs::StencilReader::Picture& picture);

  private:
    void tell(const std::string& path, Picture picture);

    const QSize most_px_;
    std::string wanted_;
    core::Worker<std::string> worker_;
};

}  // namespace pastoso::dialogs
