#include "help/manual.hpp"

#include "core/looking.hpp"
#include "core/text_file.hpp"

#include <algorithm>
#include <utility>

#include <QRegularExpression>
#include <QStringList>

namespace pastoso::help {
namespace {

constexpr const char* kEnglish = "en";
constexpr const char* kContents = "README";

QString text_of(const std::filesystem::path& file) {
    return QString::fromStdString(core::read_text_file(file));
}

/// What a line of markdown says.
QString without_marks(QString line) {
    static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\([^)]*\\)"));
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
    static const QRegularExpression marks(QStringLiteral("[*`|]|^[-:| ]+$|^(?:- |\\d+\\. )"));
    return line.remove(picture).replace(link, QStringLiteral("\\1")).remove(marks).simplified();
}

/// 1 to 6 of a heading; 0 of any other line.
int heading_level(const QString& line) {
    static const QRegularExpression heading(QStringLiteral("^(#{1,6}) "));
    return static_cast<int>(heading.match(line).capturedLength(1));
}

std::vector<Section> sections_of(const QString& markdown) {
    std::vector<Section> sections;
    bool is_code = false;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        if (line.startsWith(QStringLiteral("```"))) is_code = !is_code;
        const int level = is_code ? 0 : heading_level(line);
        if (level > 0 || sections.empty()) {
            const QString heading = without_marks(line.mid(level));
            sections.push_back({anchor_of(heading), heading, std::max(level, 1), {}});
        } else if (const QString words = without_marks(line); !words.isEmpty()) {
            sections.back().words += words + QLatin1Char(' ');
        }
    }
    return sections;
}

/// README first.
std::vector<QString> names_of_pages(const QString& contents) {
    static const QRegularExpression link(QStringLiteral("^\\d+\\. \\[[^\\]]*\\]\\(([a-z-]+)\\.md"),
                                         QRegularExpression::MultilineOption);
    std::vector<QString> names = {QString::fromUtf8(kContents)};
    for (auto it = link.globalMatch(contents); it.hasNext();) {
        const QString name = it.next().captured(1);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

bool holds_all(const QString& text, const QStringList& words) {
    return std::all_of(words.begin(), words.end(), [&text](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
}

QString excerpt_of(const QString& text, const QString& word) {
    constexpr qsizetype kBefore = 40, kLength = 140;
    const qsizetype at = std::max<qsizetype>(0, text.indexOf(word, 0, Qt::CaseInsensitive));
    qsizetype begin = std::max<qsizetype>(0, at - kBefore);
    if (begin > 0) begin = text.indexOf(QLatin1Char(' '), begin) + 1;
    const QString part = text.mid(std::min(begin, at), kLength).trimmed();
    return (begin > 0 ? QStringLiteral("\u2026 ") : QString()) + part +
           (begin + kLength < text.size() ? QStringLiteral(" \u2026") : QString());
}

}  // namespace

QString anchor_of(const QString& heading) {
    static const QRegularExpression others(QStringLiteral("[^\\w -]"),
                                           QRegularExpression::UseUnicodePropertiesOption);
    return heading.toLower().remove(others).replace(QLatin1Char(' '), QLatin1Char('-'));
}

Manual::Manual(std::filesystem::path folder, const QString& language)
    : folder_(std::move(folder)), language_(language) {
    for (const QString& name : names_of_pages(text_of(folder_ / kEnglish / "README.md")))
        pages_.push_back(read(name));
}

/// A translation has the headings of the English page, in their order.
Page Manual::read(const QString& name) const {
    const std::string file_name = name.toStdString() + ".md";
    Page page{name, sections_of(text_of(file(file_name)))};
    const std::vector<Section> english = sections_of(text_of(folder_ / kEnglish / file_name));
    for (std::size_t i = 0; i < std::min(page.sections.size(), english.size()); ++i)
        page.sections[i].anchor = english[i].anchor;
    return page;
}

std::filesystem::path Manual::file(const std::filesystem::path& name) const {
    const std::filesystem::path translated = folder_ / language_.toStdString() / name;
    return core::is_there(translated) ? translated : folder_ / kEnglish / name;
}

const Page* Manual::page(const QString& name) const {
    const auto found = std::find_if(pages_.begin(), pages_.end(),
                                    [&name](const Page& page) { return page.name == name; });
    return found == pages_.end() ? nullptr : &*found;
}

std::vector<Found> Manual::find(const QString& words) const {
    const QStringList all = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<Found> found;
    if (all.isEmpty()) return found;
    for (const Page& page : pages_)
        for (const Section& section : page.sections)
            if (holds_all(section.heading + QLatin1Char(' ') + section.words, all))
                found.push_back(
                    {page.name, page.title(), section, excerpt_of(section.words, all.front())});
    std::stable_partition(found.begin(), found.end(),
                          [&all](const Found& one) { return holds_all(one.section.heading, all); });
    return found;
}

}  // namespace pastoso::help
