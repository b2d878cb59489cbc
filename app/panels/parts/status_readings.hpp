// The figures in the status bar.
#pragma once

#include "document/events.hpp"
#include "session/paint_session.hpp"

#include <optional>

#include <QPointF>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace pastoso::panels {

class StatusReadings : public QWidget {
    Q_OBJECT
  public:
    explicit StatusReadings(QWidget* parent = nullptr);

    void show_canvas(const document::CanvasSettings& canvas);
    void show_view(double zoom, double angle_deg, bool mirrored);  ///< turned clockwise
    void show_look(const QString& words);  ///< what is shown in place of lit paint; empty: that
    void show_pointer(std::optional<QPointF> position_mm);
    void show_status(const session::Status& status);
    void show_speed(bool shown);  ///< or it is told elsewhere, in words

    /// What a press draws instead of painting, empty when it paints, and the share of the canvas that is
    /// selected, where there is a selection.
    void show_selection(const QString& drawing, std::optional<double> share);

  private:
    void show_memory();
    QLabel* add(int width_characters, const QString& hint);

    QLabel* pointer_ = nullptr;
    QLabel* activity_ = nullptr;
    QLabel* speed_ = nullptr;
    QLabel* selection_ = nullptr;
    QLabel* memory_ = nullptr;
    QLabel* canvas_ = nullptr;
    QLabel* look_ = nullptr;
    QLabel* turn_ = nullptr;
    QLabel* zoom_ = nullptr;
    QTimer memory_looked_at_;
};

}  // namespace pastoso::panels
