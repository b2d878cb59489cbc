// What the program that paints and the test that kills it agree on.
#pragma once

namespace pastoso::journal {

/// Where the painting program saves to, keeps its journals and tells how far it is, in its folder.
inline constexpr const char* kSavedName = "saved.pastoso";
inline constexpr const char* kJournalsName = "journals";
inline constexpr const char* kProgressName = "progress";

}  // namespace pastoso::journal
