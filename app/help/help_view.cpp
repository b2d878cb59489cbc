#include "help/help_view.hpp"

#include <algorithm>

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QImage>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>

namespace pastoso::help {
namespace {

constexpr int kMargin = 18;

/// "paint" of ".../sv/paint.md".
QString page_of(const QUrl& url) {
    const QString file = url.fileName();
    const QString ending = QStringLiteral(".md");
    return file.endsWith(ending) ? file.chopped(ending.size()) : QString();
}

/// Lines farther apart than those of labels, for reading; not below pictures.
void set_line_height(QTextDocument& document) {
    constexpr double kPercent = 125.0;
    QTextBlockFormat format;
    format.setLineHeight(kPercent, QTextBlockFormat::ProportionalHeight);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        if (!block.text().contains(QChar::ObjectReplacementCharacter))
            QTextCursor(block).mergeBlockFormat(format);
}

/// The blocks that are headings, in their order.
std::vector<QTextBlock> headings_of(const QTextDocument& document) {
    std::vector<QTextBlock> headings;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0) headings.push_back(block);
    return headings;
}

}  // namespace

QString path_of(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

HelpView::HelpView(const Manual& manual, QWidget* parent) : QTextBrowser(parent), manual_(manual) {
    setObjectName(QStringLiteral("help_view"));
    setAccessibleName(tr("Page of the manual"));
    setOpenExternalLinks(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // pages of any length are equally wide
    document()->setDocumentMargin(kMargin);
}

void HelpView::show_topic(const QString& topic) {
    const QString name = topic.section(QLatin1Char('#'), 0, 0);
    const bool is_there = manual_.page(name) != nullptr;
    const QString file = (is_there ? name : QStringLiteral("README")) + QStringLiteral(".md");
    QUrl url = QUrl::fromLocalFile(path_of(manual_.file(file.toStdString())));
    if (is_there && topic.contains(QLatin1Char('#')))
        url.setFragment(topic.section(QLatin1Char('#'), 1));
    setSource(url, QTextDocument::MarkdownResource);
}

QString HelpView::page_name() const {
    const QString name = page_of(source());
    return manual_.page(name) == nullptr ? QString() : name;
}

/// A page that is linked to may be there in another language than the one with the link, and so may its
/// pictures.
QVariant HelpView::loadResource(int type, const QUrl& name) {
    QString path = source().resolved(name).toLocalFile();
    if (!QFile::exists(path)) {
        const QString pictures = QStringLiteral("/pictures/");
        const qsizetype picture = path.indexOf(pictures);
        const QString beside = picture < 0 ? name.fileName() : path.mid(picture + 1);
        path = path_of(manual_.file(beside.toStdString()));
    }
    if (type != QTextDocument::ImageResource)
        return QTextBrowser::loadResource(type, QUrl::fromLocalFile(path));
    const QImage image(path);
    const double point_px = devicePixelRatioF();
    const int width_px = static_cast<int>(pictures_width_ * point_px);
    if (image.width() <= width_px || width_px <= 0) return image;
    QImage scaled = image.scaledToWidth(width_px, Qt::SmoothTransformation);
    scaled.setDevicePixelRatio(point_px);
    return scaled;
}

void HelpView::doSetSource(const QUrl& url, QTextDocument::ResourceType type) {
    pictures_width_ = viewport()->width() - 2 * kMargin;
    QTextBrowser::doSetSource(url, type);
    set_line_height(*document());
    scroll_to(url.fragment());
}

void HelpView::scroll_to(const QString& anchor) {
    const Page* page = manual_.page(page_of(source()));
    if (page == nullptr || anchor.isEmpty()) return;
    const auto section = std::find_if(page->sections.begin(), page->sections.end(),
                                      [&](const Section& one) { return one.anchor == anchor; });
    const std::vector<QTextBlock> headings = headings_of(*document());
    const auto index = static_cast<std::size_t>(section - page->sections.begin());
    if (index >= headings.size()) return;
    setTextCursor(QTextCursor(headings[index]));
    scroll_to(headings[index]);
}

void HelpView::scroll_to(const QTextBlock& block) {
    document()->size();  // all of it is laid out then: what lies below can be scrolled to
    const QRectF place = document()->documentLayout()->blockBoundingRect(block);
    verticalScrollBar()->setValue(static_cast<int>(place.top()) - kMargin / 2);
}

/// Pictures are as wide as the page. What was read stays in sight.
void HelpView::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    const int width = viewport()->width() - 2 * kMargin;
    if (width == pictures_width_ || source().isEmpty()) return;
    const int first = cursorForPosition(QPoint(kMargin, 0)).blockNumber();
    document()->clear();
    reload();
    scroll_to(document()->findBlockByNumber(first));
}

}  // namespace pastoso::help
