// Words of the trade are explained in one sentence each.
#include "appearance/terms.hpp"

#include <set>

#include <QString>
#include <gtest/gtest.h>

namespace pastoso::appearance {
namespace {

TEST(Terms, EachHasASentenceOfItsOwn) {
    std::set<QString> sentences;
    for (int term = 0; term <= static_cast<int>(Term::SoftProof); ++term) {
        const QString sentence = explanation(static_cast<Term>(term));
        EXPECT_GT(sentence.size(), 20) << term;
        EXPECT_FALSE(sentence.endsWith(QLatin1Char('.'))) << "as all hints";
        EXPECT_TRUE(sentences.insert(sentence).second) << sentence.toStdString();
    }
}

}  // namespace
}  // namespace pastoso::appearance
