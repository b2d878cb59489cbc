// How an action is told: what everything generic (checks, recordings, the page of the format, how far
// Undo reaches) has to know of it, as a table beside its struct. An action without one does not compile,
// nor does a table that leaves a trait out.
#pragma once

#include "core/message.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace pastoso::document {

/// The actions of a family.
template <class... Actions>
struct ActionList {};

/// A value that has to be given: there is none to begin with.
template <class T>
struct Given {
    template <class Like>
    requires std::is_convertible_v<Like, T>
    constexpr Given(Like given) : value(given) {}   // NOLINT(google-explicit-constructor): reads as T
    constexpr operator T() const { return value; }  // NOLINT(google-explicit-constructor)
    T value;
};

/// What Undo makes of an action.
enum class UndoRole {
    NoStep,     ///< Undo does not know of it
    Step,       ///< one that Undo takes back
    MaybeStep,  ///< the same where it changes anything; where not, it is as if it had not happened
    Undo,
    Redo
};

/// What becomes of a stroke in progress.
enum class StrokeRole {
    GoesOn,
    Ends,          ///< before the action
    EndsByChange,  ///< the same, unless the action has nothing to change
};

/// Marks the name of an undo step for those who translate (packaging/words.sh); its context is
/// "pastoso::document::Table".
constexpr std::string_view step_name(const char* name) {
    return name;
}

struct ActionTraits {
    Given<const char*> key;  ///< in recordings
    Given<int> since;        ///< version of the stroke format
    Given<std::string_view>
        meaning;  ///< for the page of the format; a sentence, or "" where the key says it
    Given<UndoRole> undo;
    Given<std::string_view> step;  ///< name in the list of undo steps; "" where it is none
    Given<bool> changes_painting;  ///< what lies on canvas and well, or how much of it tools may change
    Given<StrokeRole> stroke;
    Given<bool> in_set_up;  ///< puts something in hand that a saved painting is opened with
};

// The traits of most actions.

/// It changes the painting, ends a stroke in progress, and Undo takes it back.
constexpr ActionTraits change(const char* key, int since, std::string_view step,
                              std::string_view meaning) {
    return {key, since, meaning, UndoRole::Step, step, true, StrokeRole::Ends, false};
}

/// The same where it changes anything; where not, it is as if it had not happened.
constexpr ActionTraits possible_change(const char* key, int since, std::string_view step,
                                       std::string_view meaning) {
    return {key, since, meaning, UndoRole::MaybeStep, step, true, StrokeRole::EndsByChange, false};
}

/// Of the set-up: it says how the next strokes are painted or how paint flows.
constexpr ActionTraits setting(const char* key, int since, std::string_view meaning) {
    return {key, since, meaning, UndoRole::NoStep, "", false, StrokeRole::GoesOn, true};
}

/// Specialised for every action: kTraits, and fields(visit), which calls visit(field) for each field in
/// the order in which recordings have them. Parts of actions have tables of fields alone. Where what an
/// action says decides on its role in Undo, there is also undo_role(action).
///
/// Beside the table stand apply(action, painting) and, where they are needed, check_whole(action) for
/// what no single field can tell, check_possible(action, painting), changes_anything(action, painting)
/// and undo_step(action, painting). What is in the set-up has put_in_hand(action, value) and
/// in_hand(type, value) instead, or besides.
template <class Told>
struct Table;

/// What Undo makes of one action: as its table has it, unless what it says decides.
template <class Told>
constexpr UndoRole role_of(const Told& told) {
    if constexpr (requires { Table<Told>::undo_role(told); })
        return Table<Told>::undo_role(told);
    else
        return Table<Told>::kTraits.undo;
}

/// The way from an action to one of its values: members of members.
template <auto... kMembers>
struct At {
    template <class Action>
    static constexpr auto& of(Action& action) {
        return (action.*....*kMembers);
    }
};

/// When recordings have a field.
enum class Presence {
    Required,  ///< always
    Written,   ///< always; left out by hand it is as in a new action
    Optional   ///< where it is not as in a new action
};

// The kinds of fields. `key` is the key in recordings, `name` how errors and the page call it ("the NAME
// is ..., but must lie between ..."), `note` what the page says besides, `since` the version that has it
// first.

/// low <= value <= high, in `unit` ("" for a pure number); or the value of a new action.
template <class Place>
struct Number {
    using At = Place;
    const char* key;
    core::Pattern<0> name, unit;
    double low, high;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// The same of whole numbers.
template <class Place>
struct Whole {
    using At = Place;
    const char* key;
    core::Pattern<0> name;
    std::int64_t low, high;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// x and y, told as a list of two numbers.
template <class PlaceX, class PlaceY>
struct Pair {
    using X = PlaceX;
    using Y = PlaceY;
    const char* key;
    core::Pattern<0> name, unit;
    double low, high;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// True or false.
template <class Place>
struct Truth {
    using At = Place;
    const char* key;
    std::string_view name;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// Text of at most so many bytes.
template <class Place>
struct Text {
    using At = Place;
    const char* key;
    core::Pattern<0> name;
    std::size_t most_bytes;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// A value of a type that has a form of its own in recordings; what it may be, check_whole() tells.
template <class Place>
struct Value {
    using At = Place;
    const char* key;
    std::string_view name;
    Presence presence;
    std::string_view note = "";
    int since = 1;
};

/// One of the alternatives of a std::variant, by its name (Table<Alternative>::kName), and the fields of
/// that one. Table<Alternative>::kSince is the version that has it first, where that is not the
/// action's.
template <class Place>
struct OneOf {
    using At = Place;
    const char* key;
    std::string_view name;
    std::string_view note = "";
    int since = 1;
};

/// The fields of a part, as if they were the action's own.
template <class Place>
struct Part {
    using At = Place;
};

}  // namespace pastoso::document
