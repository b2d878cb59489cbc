// Beside the glass: what is done with it, milk and tea in words, recipes, and all numbers below.
#pragma once

#include "glass/panel_parts.hpp"
#include "glass/tea_recipes.hpp"
#include "session/tea_session.hpp"

#include <vector>

#include <QWidget>

class QComboBox;
class QSpinBox;
class QVBoxLayout;

namespace pastoso::panels {
class Gallery;
}

namespace pastoso::glass {

/// Of as many parcels at most a scene is shown as it is opened: the glass keeps up with them.
inline constexpr int kLiveParcels = 60000;

struct TeaRow;
struct TeaSection;

/// The actions that stand on its buttons and beside the timeline.
struct TeaActions {
    GlassActions glass;
    QAction *pour, *new_glass, *open, *save, *force, *recentre, *reverse;
    QAction *left, *right, *away, *near;
    QAction *render, *export_mesh;
};

class TeaPanel : public QWidget {
    Q_OBJECT
  public:
    explicit TeaPanel(const TeaActions& actions, QWidget* parent = nullptr);

    GlassChooser& chooser() { return *chooser_; }

    /// Shows these numbers, without a signal.
    void show_settings(const liquid::TeaSettings& settings);
    void show_force(const session::TeaForce& force);

    /// As they stand there, the next glass' among them.
    const liquid::TeaSettings& settings() const { return settings_; }

  Q_SIGNALS:
    /// Numbers that hold from now on.
    void numbers_changed(const liquid::TeaSettings& settings);
    void force_changed(const session::TeaForce& force);
    /// The name of a scene that comes with the program.
    void recipe_chosen(const QString& scene);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void add_glass(QVBoxLayout* column, const TeaActions& actions);
    void add_feels(QVBoxLayout* column);
    void add_recipes(QVBoxLayout* column);
    void add_next_glass(QVBoxLayout* column);
    void add_force(QVBoxLayout* column, const TeaActions& actions);
    void add_numbers(QVBoxLayout* column, const TeaSection& section);
    void change(const liquid::TeaSettings& settings);

    struct Shown {
        const TeaRow* row;
        ValueRow* widget;
    };

    liquid::TeaSettings settings_;
    session::TeaForce force_;
    GlassChooser* chooser_ = nullptr;
    QComboBox* cells_ = nullptr;
    QSpinBox* parcels_ = nullptr;
    std::vector<TeaRecipe> recipes_;
    panels::Gallery* gallery_ = nullptr;
    std::vector<FeelRow*> feels_;
    ValueRow *milk_ = nullptr, *swirl_ = nullptr, *push_ = nullptr;
    std::vector<Shown> shown_;
};

}  // namespace pastoso::glass
