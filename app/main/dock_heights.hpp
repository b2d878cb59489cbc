// How high the panels at the sides are: one that holds little leaves the rest to the others.
#pragma once

#include "main/panel_set.hpp"
#include "tools/panel_arrangement.hpp"

#include <cstddef>
#include <optional>

#include <QObject>

class QMainWindow;

namespace pastoso::main {

/// As long as it follows an arrangement, heights are its shares of a side, whenever the window is shown
/// or has another size and when there are more or fewer layers; but the layers take no more than what
/// they hold. A side without them is left alone. The painter who drags a border between panels has them
/// as he likes.
class DockHeights : public QObject {
    Q_OBJECT
  public:
    /// Follows the one in which panels stand at first.
    DockHeights(QMainWindow& window, const PanelSet& panels);

    /// One that comes with the program, at whichever sides it stands in the window.
    void follow(const tools::PanelArrangement& arrangement);
    void leave_as_they_are() { followed_.reset(); }
    bool follows() const { return followed_.has_value(); }

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void fit_soon();
    void fit();
    void fit(tools::Side side);
    std::optional<int> share_of(const tools::PanelTabs& tabs) const;
    std::optional<int> needed_by(const tools::PanelTabs& tabs) const;

    QMainWindow& window_;
    std::optional<tools::PanelArrangement> followed_;
    std::size_t layers_ = 0;
    bool waits_ = false;  ///< to fit them
};

}  // namespace pastoso::main
