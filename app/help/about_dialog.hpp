// What the program is: its version and licence, what it is made of, and where it keeps things.
#pragma once

#include "dialogs/fact_list.hpp"
#include "help/manual.hpp"

#include <QDialog>

namespace pastoso::help {

class AboutDialog : public QDialog {
    Q_OBJECT
  public:
    /// The manual has to outlive it.
    AboutDialog(const Manual& manual, const std::vector<dialogs::Fact>& machine,
                const std::vector<dialogs::Fact>& folders, QWidget* parent);
};

}  // namespace pastoso::help
