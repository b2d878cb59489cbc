// What the paint is like: the medium in hand, and each of its numbers.
#pragma once

#include "film/medium.hpp"

#include <vector>

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace pastoso::panels {

struct MediumRow;
struct MediumSection;
class ValueRow;

class MediumPanel : public QWidget {
    Q_OBJECT
  public:
    explicit MediumPanel(QWidget* parent = nullptr);

    /// Shows the medium in hand, without a signal.
    void show_medium(const film::Medium& medium);

  Q_SIGNALS:
    void medium_chosen(const QString& name);  ///< as it comes with the program
    void medium_changed(const film::Medium& medium);

  private:
    QWidget* medium_section();
    QWidget* numbers(const MediumSection& section);

    struct Shown {
        const MediumRow* number;
        ValueRow* row;
    };

    film::Medium medium_;
    QComboBox* media_ = nullptr;
    QLabel* description_ = nullptr;
    QPushButton* reset_ = nullptr;
    std::vector<Shown> shown_;
};

}  // namespace pastoso::panels
