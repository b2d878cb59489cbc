// What the paint is like: the medium in hand, and each of its numbers.
#pragma once

#include "film/medium.hpp"

#include <vector>

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace pastoso::panels {

class FeelRow;
class Fold;
class MediumBox;
struct MediumRow;
struct MediumSection;
class ValueRow;

class MediumPanel : public QWidget {
    Q_OBJECT
  public:
    explicit MediumPanel(QWidget* parent = nullptr);

    /// Shows the medium in hand, without a signal. A number that moves is let go only for another
    /// medium.
    void show_medium(const film::Medium& medium);

    MediumBox* media() const { return media_; }

    /// Shows each number below the painters' words, or folds them away.
    void open_numbers(bool open);
    bool numbers_open() const;

    /// Says at once what was set a moment ago.
    void finish();

  Q_SIGNALS:
    void medium_chosen(const QString& name);          ///< as it comes with the program
    void medium_changed(const film::Medium& medium);  ///< its numbers rest: paint is poured only then

  private:
    QWidget* medium_section();
    QWidget* feel_section();
    QWidget* numbers(const MediumSection& section);
    void choose(const QString& name);
    void show_numbers(const film::Medium& medium);

    void change(const film::Medium& medium);

    struct Shown {
        const MediumRow* number;
        ValueRow* row;
    };

    film::Medium medium_;   ///< as shown
    film::Medium in_hand_;  ///< behind it while a number moves
    QTimer resting_;
    MediumBox* media_ = nullptr;
    QLabel* description_ = nullptr;
    QPushButton* reset_ = nullptr;
    Fold* fold_ = nullptr;
    std::vector<Shown> shown_;
    std::vector<FeelRow*> feels_;  ///< of kFeels
};

}  // namespace pastoso::panels
