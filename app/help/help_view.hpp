// A page of the manual, as it is read.
#pragma once

#include "help/manual.hpp"

#include <QTextBrowser>

class QTextBlock;

namespace pastoso::help {

/// As Qt names files.
QString path_of(const std::filesystem::path& path);

/// Follows links within the manual, to the part that they name; others are opened by the system.
class HelpView : public QTextBrowser {
    Q_OBJECT
  public:
    explicit HelpView(const Manual& manual, QWidget* parent = nullptr);

    /// "paint", "paint#the-mixing-well"; the contents where there is no such page.
    void show_topic(const QString& topic);

    /// The page that is read; empty beside the manual's own.
    QString page_name() const;

    QVariant loadResource(int type, const QUrl& name) override;

  protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void scroll_to(const QString& anchor);
    void scroll_to(const QTextBlock& block);

    const Manual& manual_;
    int pictures_width_ = 0;  ///< that those of the page are made for
};

}  // namespace pastoso::help
