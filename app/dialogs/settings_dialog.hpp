// The program's settings: how it looks, what it keeps, how much of the machine it takes, and what it
// finds there. Every change holds at once; there is nothing to be accepted at the end.
#pragma once

#include "dialogs/fact_list.hpp"
#include "tools/preferences.hpp"

#include <functional>
#include <utility>
#include <vector>

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLabel;
class QTabWidget;

namespace pastoso::dialogs {

class SettingsDialog : public QDialog {
    Q_OBJECT
  public:
    enum class Page { Appearance, Colour, Keeping, Performance, Machine };

    /// `system_profile` is what the one of the system calls itself; empty where there is none. `machine`
    /// is told on the last page.
    SettingsDialog(tools::Preferences preferences, int undo_memory_MiB, const QString& system_profile,
                   const std::vector<Fact>& machine, QWidget* parent = nullptr);

    void show_page(Page page);

  Q_SIGNALS:
    void changed(const pastoso::tools::Preferences& preferences);
    void undo_memory_changed(int MiB);

  private:
    /// Of a number, as it is said behind it.
    using UnitWords = std::function<QString(int)>;

    QWidget* make_appearance();
    QWidget* make_colour(const QString& system_profile);
    QWidget* make_keeping(int undo_memory_MiB);
    QWidget* make_performance();
    QComboBox* add_choice(QFormLayout* form, const QString& words, const QString& name,
                          const std::vector<std::pair<QString, std::string>>& choices,
                          std::string tools::Preferences::*preference);
    QWidget* add_profile(QFormLayout* form, const QString& words, const QString& name,
                         std::string tools::Preferences::*preference);
    void add_number(QFormLayout* form, const QString& words, const QString& name, int most,
                    const QString& words_for_none, const UnitWords& unit,
                    int tools::Preferences::*preference);

    tools::Preferences preferences_;
    QTabWidget* pages_ = nullptr;
};

}  // namespace pastoso::dialogs
