// The bar of buttons around the canvas, whose words give way to the buttons where the window is narrow.
#pragma once

#include <vector>

#include <QToolBar>

class QComboBox;
class QToolButton;

namespace pastoso::panels {

/// What is said in words beside buttons and boxes is said as far as there is room for it; what was asked
/// for first is said first. Without room for any word, every button is still there. Upright it says
/// none, and is as wide as a short word.
class ToolBar : public QToolBar {
    Q_OBJECT
  public:
    explicit ToolBar(const QString& title, QWidget* parent = nullptr);

    /// With its icon alone.
    QToolButton* add_button(QAction* action);

    /// Upright no wider than the bar: what it shows is cut then, and its list is as wide as ever.
    void add_box(QComboBox* box);

    /// A word before what is added next.
    QAction* add_word(const QString& word);

    /// Says the words of these buttons, or this word, where there is room besides those asked for before.
    void say(std::vector<QToolButton*> buttons);
    void say(QAction* word);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    struct Words {
        std::vector<QToolButton*> buttons;
        QAction* word = nullptr;
    };
    static void show(const Words& words, bool shown);
    void fit_words();
    void turn(Qt::Orientation orientation);

    std::vector<QToolButton*> buttons_;
    std::vector<QComboBox*> boxes_;
    std::vector<Words> words_;
    QSize fitted_;  ///< what the bar needed after its words were fitted
    bool fitting_ = false;
};

}  // namespace pastoso::panels
