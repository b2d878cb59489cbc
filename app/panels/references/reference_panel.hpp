// The board of references with what is done to the chosen picture.
#pragma once

#include "document/references.hpp"

#include <functional>
#include <vector>

#include <QWidget>

class QAction;

namespace pastoso::panels {

class ReferenceView;
class ValueRow;

class ReferencePanel : public QWidget {
    Q_OBJECT
  public:
    /// `actions` become buttons.
    explicit ReferencePanel(const std::vector<QAction*>& actions, QWidget* parent = nullptr);

    ReferenceView& board() { return *board_; }

  private:
    /// Of the chosen picture, by that name, with an icon.
    QAction* add_action(const char* name, const char* icon, const QString& words, const QString& hint,
                        std::function<void()> work);
    QAction* add_switch(const char* name, const char* icon, const QString& words, const QString& hint,
                        std::function<void(document::Reference& one)> turn_over);
    void add_actions();
    void change_chosen(const std::function<void(document::Reference& one)>& change);
    void show_chosen();

    ReferenceView* board_ = nullptr;
    std::vector<QAction*> of_chosen_;
    QAction *mirror_ = nullptr, *grey_ = nullptr;
    ValueRow* opacity_ = nullptr;
};

}  // namespace pastoso::panels
