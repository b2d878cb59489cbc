// The manual: pages in markdown in a folder for each language, found by name and by words.
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

namespace pastoso::help {

/// What stands below one heading of a page, up to the next.
struct Section {
    QString anchor;  ///< as links name it, in every language: made of its English heading
    QString heading;
    int level = 1;  ///< 1: the page's own
    QString words;  ///< without marks
};

struct Page {
    QString name;  ///< "paint", of paint.md
    std::vector<Section> sections;

    QString title() const { return sections.front().heading; }
};

struct Found {
    QString page;
    QString title;
    Section section;
    QString excerpt;  ///< with the first of the words
};

/// A heading as links name it: letters and digits, small, and hyphens for spaces.
QString anchor_of(const QString& heading);

class Manual {
  public:
    /// Reads FOLDER/en/README.md and the pages that its numbered list links to, in their order; each in
    /// this language where FOLDER/LANGUAGE holds it, else in English. Throws core::InputError when a
    /// page cannot be read.
    Manual(std::filesystem::path folder, const QString& language);

    const std::vector<Page>& pages() const { return pages_; }
    const Page* page(const QString& name) const;

    /// The sections that hold all of these words, parts of words too, in the order of the pages; first
    /// those whose headings do. None for no words.
    std::vector<Found> find(const QString& words) const;

    /// The file of a page, or of anything else that stands beside one, in the language that it is had
    /// in.
    std::filesystem::path file(const std::filesystem::path& name) const;

    /// That of what stands beside the languages' folders.
    std::filesystem::path beside(const std::filesystem::path& name) const { return folder_ / name; }

  private:
    Page read(const QString& name) const;

    std::filesystem::path folder_;
    QString language_;
    std::vector<Page> pages_;
};

}  // namespace pastoso::help
