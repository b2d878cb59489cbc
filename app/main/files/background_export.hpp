// A file that is written on a thread of its own, and how that ended in the status line.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include <QObject>
#include <QString>

namespace pastoso::main {

class Studio;

class BackgroundExport : public QObject {
    Q_OBJECT
  public:
    explicit BackgroundExport(Studio& studio) : studio_(studio) {}
    ~BackgroundExport() override;

    bool busy() const { return busy_; }

    /// `write` gets what says that it shall stop, and returns a sentence, or nothing where it stopped;
    /// what it throws of core::InputError is told in its place. While another is written that is told.
    void start(std::function<QString(const std::atomic<bool>& stops)> write);

  private:
    Studio& studio_;
    std::atomic<bool> busy_ = false, stops_ = false;
    std::thread thread_;
};

}  // namespace pastoso::main
