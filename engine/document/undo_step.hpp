// What Undo takes back and Redo does again, for people to recognise it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pastoso::document {

struct UndoStep {
    std::string_view
        name{};           ///< ActionTraits::step of the action that made it; shown in other languages
    std::string brush{};  ///< name of the preset; "" where none had a part in it
    std::string layer{};  ///< name that the layer or group had then; "" where it was no single one
    friend bool operator==(const UndoStep&, const UndoStep&) = default;
};

struct KeptStep {
    UndoStep step{};
    std::size_t bytes = 0;  ///< that the moment before or after it holds alone
    bool packed = false;
};

}  // namespace pastoso::document
