// A file that is written on a thread of its own, and how that ended in the status line.
#pragma once

#include "core/worker.hpp"

#include <functional>

#include <QObject>
#include <QString>

namespace pastoso::main {

class Studio;

class BackgroundExport : public QObject {
    Q_OBJECT
  public:
    /// Asked now and then while a file is written: whether to stop.
    using Stops = std::function<bool()>;
    /// Returns a sentence, or nothing where it stopped.
    using Write = std::function<QString(const Stops& stops)>;

    explicit BackgroundExport(Studio& studio);

    /// Until its end was told.
    bool busy() const { return busy_; }

    /// What `write` throws is told in place of its sentence. While another is written that is told.
    void start(Write write);

  private:
    void end(const QString& told);

    Studio& studio_;
    bool busy_ = false;
    core::Worker<Write> worker_;
};

}  // namespace pastoso::main
