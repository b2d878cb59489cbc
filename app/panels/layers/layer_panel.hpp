// The layers of the painting: their list, the chosen one's opacity, and buttons for what is done to
// them.
#pragma once

#include "document/events.hpp"
#include "tools/layer_list.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QTimer>
#include <QWidget>

class QAction;
class QImage;
class QMimeData;

namespace pastoso::panels {

class LayerTree;
class ValueRow;

class LayerPanel : public QWidget {
    Q_OBJECT
  public:
    /// `buttons` stand below the list, `menu` is what a right click on the list offers; a null is a
    /// separator.
    LayerPanel(const std::vector<QAction*>& buttons, const std::vector<QAction*>& menu,
               QWidget* parent = nullptr);

    /// Shows the layers of the latest snapshot. What the painter has just changed here stays as it is
    /// shown until the painting had the time to follow.
    void show_layers(std::shared_ptr<const document::LayerStack> stack);

    void set_picture(document::LayerId layer, const QImage& picture, bool wet);
    void forget_pictures();

    /// As they are shown.
    const document::LayerStack& stack() const { return stack_; }

    /// The row that commands are about; the layer that is painted on unless it is a group.
    tools::LayerRow chosen() const { return chosen_; }
    std::vector<tools::LayerRow> selected() const;

    void choose(const tools::LayerRow& row);
    void set_look(const tools::LayerRow& row, const document::LayerLook& look);
    void edit_name();

    /// What a row that is dragged carries besides its place in the list (LayerTree::Carried).
    void set_carried(std::function<QMimeData*(const tools::LayerRow& row)> carried);

  Q_SIGNALS:
    void wanted(const document::Action& action);

    /// What commands can do may be something else now.
    void choice_changed();

  private:
    void make_opacity_row(QWidget* parent);
    void connect_tree();
    void refresh();
    void take(const document::LayerStack& stack);
    void take_latest();
    void show_opacity();
    void post_opacity();

    LayerTree* tree_ = nullptr;
    ValueRow* opacity_ = nullptr;
    std::shared_ptr<const document::LayerStack> latest_;
    document::LayerStack stack_;
    tools::LayerRow chosen_;
    QTimer following_;                      ///< the painting has not followed yet
    std::optional<tools::LayerRow> faded_;  ///< its opacity was changed, and is not posted yet
    QTimer fading_;
};

}  // namespace pastoso::panels
