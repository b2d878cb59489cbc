#include "commands/command_search.hpp"

#include "commands/command_synonyms.hpp"
#include "commands/command_words.hpp"

#include <algorithm>

#include <QRegularExpression>
#include <QStringList>

namespace pastoso::commands {
namespace {

// In each kind more than in all of the next.
constexpr int kFirstWord = 3000, kWord = 1000, kSynonym = 300, kBeginnings = 100, kMenu = 30, kHint = 1;

QStringList words_in(const QString& text) {
    static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
    return text.toCaseFolded().split(between, Qt::SkipEmptyParts);
}

/// Of scripts that leave no room between words.
bool is_ideographic(const QString& typed) {
    static const QRegularExpression ideographs(QStringLiteral("[\\p{Han}\\p{Hiragana}\\p{Katakana}]"));
    return typed.contains(ideographs);
}

bool begins_one(const QString& typed, const QStringList& words) {
    const bool anywhere = is_ideographic(typed);
    return std::any_of(words.begin(), words.end(), [&](const QString& word) {
        return anywhere ? word.contains(typed) : word.startsWith(typed);
    });
}

/// Whether the letters are beginnings of words, in their order, one after the other.
bool is_put_together(const QString& typed, const QStringList& words, qsizetype from = 0) {
    if (typed.isEmpty()) return true;
    for (qsizetype i = from; i < words.size(); ++i)
        for (qsizetype taken = std::min(typed.size(), words[i].size()); taken > 0; --taken)
            if (words[i].startsWith(typed.left(taken)) &&
                is_put_together(typed.mid(taken), words, i + 1))
                return true;
    return false;
}

/// By which a command is found.
struct Findable {
    QStringList words, synonyms, menu, hint;
};

int fit_of_word(const QString& typed, const Findable& text) {
    if (!text.words.isEmpty() && text.words.front().startsWith(typed)) return kFirstWord;
    if (begins_one(typed, text.words)) return kWord;
    if (begins_one(typed, text.synonyms)) return kSynonym;
    if (is_put_together(typed, text.words)) return kBeginnings;
    if (begins_one(typed, text.menu)) return kMenu;
    return begins_one(typed, text.hint) ? kHint : 0;
}

/// Nothing where a word fits nowhere.
template <class FitOfWord>
int sum_of_words(const QString& typed, const FitOfWord& fit_of) {
    int sum = 0;
    for (const QString& word : words_in(typed)) {
        const int found = fit_of(word);
        if (found == 0) return 0;
        sum += found;
    }
    return sum;
}

}  // namespace

int fit(const QString& typed, const CommandText& text) {
    const Findable by{words_in(plain_words(text.words)), words_in(synonyms_of(text.command)),
                      words_in(plain_words(text.menu)), words_in(words_of(text.hint))};
    return sum_of_words(typed, [&](const QString& word) { return fit_of_word(word, by); });
}

/// Letters put together of beginnings would find half of the box of paints.
int fit_of_name(const QString& typed, const QString& name, const QString& kind,
                const QString& synonyms) {
    const QStringList names = words_in(name), others = words_in(synonyms), kinds = words_in(kind);
    return sum_of_words(typed, [&](const QString& word) {
        if (begins_one(word, names)) return names.front().startsWith(word) ? kFirstWord : kWord;
        if (begins_one(word, others)) return kSynonym;
        return begins_one(word, kinds) ? kMenu : 0;
    });
}

std::vector<Found> find_with_fit(const QString& typed) {
    std::vector<Found> found;
    for (const CommandText& text : command_list())
        if (const int fits = fit(typed, text); fits > 0) found.push_back({text.command, fits});
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.fit > b.fit; });
    return found;
}

std::vector<Command> find_commands(const QString& typed) {
    std::vector<Command> commands;
    for (const Found& one : find_with_fit(typed))
        commands.push_back(one.command);
    return commands;
}

}  // namespace pastoso::commands
