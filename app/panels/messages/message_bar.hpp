// The bar in which messages stand that need the painter.
#pragma once

#include "panels/messages/message_log.hpp"

#include <QFrame>
#include <QRect>

class QVBoxLayout;

namespace pastoso::panels {

/// Lies over the lower edge of a place, as high as its sentences are long, so that the canvas does not
/// move under the pen. Each can be put away; hidden where there is none.
class MessageBar : public QFrame {
    Q_OBJECT
  public:
    /// Over `parent`.
    MessageBar(MessageLog& log, QWidget* parent);

    /// The place, in the parent, has changed.
    void lie_on(const QRect& place);

  private:
    void show_messages();
    QWidget* row(const StandingMessage& message);
    void fit();

    MessageLog& log_;
    QVBoxLayout* column_;
    QWidget* rows_ = nullptr;
    QRect place_;
};

}  // namespace pastoso::panels
