// Another window: the program once more, with an easel, a thread and a journal of its own.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QString>

namespace pastoso::main {

class NewWindow : public QObject {
    Q_OBJECT
  public:
    explicit NewWindow(Studio& studio);

    /// What is started; at first this program.
    void start_with(const QString& program) { program_ = program; }

    /// With a painting to open, or a recording to replay; empty: with neither.
    void open(const QString& file);

  private:
    Studio& studio_;
    QString program_;
};

}  // namespace pastoso::main
