#include "document/history.hpp"

#include "core/background_thread.hpp"
#include "core/random.hpp"
#include "document/layered_canvas.hpp"
#include "document/moment_stack.hpp"
#include "document/well.hpp"

#include <algorithm>
#include <future>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr std::size_t kTileBytes = sizeof(std::int32_t) * grid::kTileCells;

/// A painting of 4 x 4 tiles that changes by one tile at a time, full of noise that hardly packs.
class NoisyFilm {
  public:
    NoisyFilm() {
        for (int tile = 0; tile < 16; ++tile)
            change(tile);
    }
    void change(int tile) {
        std::int32_t* cells = film_.thickness.write(tile);
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            cells[cell] = static_cast<std::int32_t>(core::scramble(++number_) >> 4);
    }
    Moment moment() const {
        Moment moment;
        moment.value.film = film_;
        moment.awake = std::vector<bool>(16);
        return moment;
    }
    void return_to(const Moment& moment) { film_ = moment.value.film; }
    std::uint64_t hash() const { return film::state_hash(film_); }

  private:
    film::FilmState film_{{256, 256}, 0.25};
    std::uint32_t number_ = 0;
};

std::uint64_t hash_of(const Moment& moment) {
    return film::state_hash(moment.value.film);
}

void change_and_remember(NoisyFilm& film, History& history, int tile = 0) {
    history.remember(film.moment(), {});
    film.change(tile);
}

/// What packed steps may take of a budget.
std::size_t packed_bytes(const History& history) {
    std::size_t sum = 0;
    for (const KeptStep& step : history.past_steps())
        if (step.packed) sum += step.bytes;
    return sum;
}

TEST(History, GoesBackAndForth) {
    NoisyFilm film;
    History history;
    EXPECT_FALSE(history.can_undo());
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 3; ++i) {
        hashes.push_back(film.hash());
        change_and_remember(film, history);
    }
    hashes.push_back(film.hash());
    for (int i = 2; i >= 0; --i) {
        film.return_to(history.step_back(film.moment()));
        EXPECT_EQ(film.hash(), hashes[i]);
    }
    EXPECT_FALSE(history.can_undo());
    for (int i = 1; i <= 3; ++i) {
        film.return_to(history.step_forward(film.moment()));
        EXPECT_EQ(film.hash(), hashes[i]);
    }
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(hash_of(history.step_back(film.moment())), hashes[2]);
}

TEST(MomentStack, WhatWaitsForAThreadThatHasNoTimeIsPackedAtOnceBeyondALimit) {
    NoisyFilm film;
    std::promise<void> has_time;
    core::BackgroundThread packer;
    packer.add([&] { has_time.get_future().wait(); });
    MomentStack stack(packer);
    stack.set_unpacked_bytes(2 * kTileBytes);
    std::vector<std::uint64_t> hashes;
    const auto unpacked_bytes = [&] {
        std::size_t sum = 0;
        for (const KeptStep& step : stack.steps())
            if (!step.packed) sum += step.bytes;
        return sum;
    };
    for (int i = 0; i < 20; ++i) {
        hashes.push_back(film.hash());
        stack.push(film.moment());
        film.change(i % 16);
    }
    EXPECT_GT(unpacked_bytes(), 15 * kTileBytes);
    stack.limit_waiting(8 * kTileBytes);
    EXPECT_LE(unpacked_bytes(), 12 * kTileBytes);
    EXPECT_GE(unpacked_bytes(), 8 * kTileBytes);
    stack.limit_waiting(0);
    EXPECT_LE(unpacked_bytes(), 4 * kTileBytes);
    for (int i = 19; i >= 0; --i)
        EXPECT_EQ(hash_of(stack.pop()), hashes[static_cast<std::size_t>(i)]);
    has_time.set_value();
}

TEST(MomentStack, KeepsTheUpperPackedOnesAsTheyAreUpToALimit) {
    NoisyFilm film;
    core::BackgroundThread packer;
    MomentStack stack(packer);
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 10; ++i) {
        hashes.push_back(film.hash());
        stack.push(film.moment());
        film.change(i);
    }
    stack.finish_packing();
    EXPECT_GT(stack.unpacked_bytes(), 9 * kTileBytes);
    const std::size_t packed_bytes = stack.packed_bytes();
    stack.limit_unpacked(5 * kTileBytes);
    EXPECT_LE(stack.unpacked_bytes(), 5 * kTileBytes);
    EXPECT_GT(stack.unpacked_bytes(), 4 * kTileBytes);
    EXPECT_EQ(stack.packed_bytes(), packed_bytes);
    for (std::size_t i = hashes.size(); i-- > 0;)
        EXPECT_EQ(hash_of(stack.pop()), hashes[i]);
}

TEST(MomentStack, KeepsWhatIsNotPackedYetWhateverTheLimit) {
    NoisyFilm film;
    std::promise<void> has_time;
    core::BackgroundThread packer;
    packer.add([&] { has_time.get_future().wait(); });
    MomentStack stack(packer);
    const std::uint64_t first = film.hash();
    for (int i = 0; i < 3; ++i) {
        stack.push(film.moment());
        film.change(i);
    }
    stack.limit_unpacked(0);
    EXPECT_GT(stack.unpacked_bytes(), 2 * kTileBytes);
    stack.pop();
    stack.pop();
    EXPECT_EQ(hash_of(stack.pop()), first);
    has_time.set_value();
}

TEST(History, PackedStepsStayAsTheyAreWhereTheBudgetHasRoom) {
    NoisyFilm film;
    History history;
    const std::size_t budget = 48 * kTileBytes;
    history.set_budget(budget);
    for (int i = 0; i < 60; ++i) {
        change_and_remember(film, history, i % 16);
        history.finish_packing();
        EXPECT_LE(history.bytes(), budget);
        // Of 19 steps below the next one six are not packed; thirteen are, and stay as they are.
        if (i == 19) {
            EXPECT_GT(history.bytes(), 30 * kTileBytes);
        }
    }
}

TEST(History, ANewChangeForgetsWhatWasUndone) {
    NoisyFilm film;
    History history;
    change_and_remember(film, history);
    film.return_to(history.step_back(film.moment()));
    EXPECT_TRUE(history.can_redo());
    change_and_remember(film, history);
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.past_steps().size(), 1U);
}

TEST(History, StepsKeepTheirNamesBothWays) {
    NoisyFilm film;
    History history;
    history.remember(film.moment(), {"Stroke", "flat"});
    film.change(0);
    history.remember(film.moment(), {"Dry now"});
    film.change(1);
    film.return_to(history.step_back(film.moment()));
    ASSERT_EQ(history.future_steps().size(), 1U);
    EXPECT_EQ(history.future_steps()[0].step.name, "Dry now");
    film.return_to(history.step_back(film.moment()));
    ASSERT_EQ(history.future_steps().size(), 2U);
    EXPECT_EQ(history.future_steps()[1].step.brush, "flat");
    film.return_to(history.step_forward(film.moment()));
    ASSERT_EQ(history.past_steps().size(), 1U);
    EXPECT_EQ(history.past_steps()[0].step.brush, "flat");
}

TEST(History, PacksOldStepsAndThenDropsTheOldest) {
    NoisyFilm film;
    History history;
    const std::size_t budget = 16 * kTileBytes;
    history.set_budget(budget);
    std::vector<std::uint64_t> hashes;
    std::size_t most_steps = 0;
    for (int i = 0; i < 40; ++i) {
        hashes.push_back(film.hash());
        change_and_remember(film, history, i % 16);
        history.finish_packing();
        const auto steps = history.past_steps();
        EXPECT_LE(packed_bytes(history), budget);
        // From the oldest on: packed ones, then those that are not, the last of them free of charge.
        EXPECT_TRUE(std::is_partitioned(steps.begin(), steps.end(),
                                        [](const KeptStep& step) { return step.packed; }));
        EXPECT_GE(steps.size(), std::min<std::size_t>(most_steps, i + 1)) << "dropped without need";
        most_steps = steps.size();
    }
    // A tile of noise hardly packs: there is room for thirteen, and the latest costs nothing.
    EXPECT_GT(most_steps, 12U);
    EXPECT_LT(most_steps, 40U);
    for (std::size_t i = hashes.size(); i > hashes.size() - most_steps; --i) {
        ASSERT_TRUE(history.can_undo());
        film.return_to(history.step_back(film.moment()));
        EXPECT_EQ(film.hash(), hashes[i - 1]);
    }
    EXPECT_FALSE(history.can_undo());
}

TEST(History, KeepsAtMostSoManySteps) {
    NoisyFilm film;
    History history;
    for (std::size_t i = 0; i < History::kMostMoments + 5; ++i)
        history.remember(film.moment(), {});
    EXPECT_EQ(history.past_steps().size(), History::kMostMoments);
}

TEST(History, ABudgetOfZeroKeepsNothing) {
    NoisyFilm film;
    History history;
    change_and_remember(film, history);
    history.set_budget(0);
    EXPECT_FALSE(history.can_undo());
    change_and_remember(film, history);
    EXPECT_FALSE(history.can_undo());
}

TEST(History, BringsBackTheWell) {
    History history;
    history.set_budget(8 * kTileBytes);  // too little for more than one tile without packing
    Moment moment = NoisyFilm().moment();
    std::vector<std::optional<std::uint64_t>> wells;
    const auto note = [](const Moment& then) {
        return then.value.well ? std::optional(film::state_hash(*then.value.well)) : std::nullopt;
    };
    for (int i = 0; i < 6; ++i) {
        wells.push_back(note(moment));
        history.remember(moment, {});
        if (i % 3 == 0) moment.value.well.emplace(bare_well());
        if (i % 3 == 2)
            moment.value.well.reset();
        else
            moment.value.well->thickness.set(70 * (i % 3), 3, i + 1);
    }
    history.finish_packing();
    for (int i = 5; i >= 0; --i) {
        moment = history.step_back(moment);
        EXPECT_EQ(note(moment), wells[i]) << i;
    }
    for (int i = 1; i < 6; ++i) {
        moment = history.step_forward(moment);
        EXPECT_EQ(note(moment), wells[i]) << i;
    }
}

/// Layers that come, go, become active, inactive and lie on something else.
class NoisyLayers {
  public:
    NoisyLayers() { add(); }

    void change(std::uint32_t number) {
        const std::uint32_t choice = core::scramble(number + 3) % 8;
        const std::size_t other = core::scramble(number + 4) % stack_.layers.size();
        if (choice == 0 && stack_.layers.size() < 5) return add();
        if (choice == 1 && other != stack_.active) return remove(other);
        if (choice == 2) return select(other);
        if (choice == 3) stack_.layers[other].look.opacity = 0.5;
        if (choice == 4) film_.support_mm.write(static_cast<int>(other))[9] += 0x1p-20F;
        film_.change(static_cast<int>(core::scramble(number + 5) % 16));
    }
    Moment moment() const {
        Moment moment = film_.moment();
        moment.value.film.support_mm = film_.support_mm;
        moment.value.layers = stack_;
        return moment;
    }
    void return_to(const Moment& moment) {
        film_.return_to(moment);
        film_.support_mm = moment.value.film.support_mm;
        stack_ = moment.value.layers;
    }
    std::uint64_t hash() const {
        const Moment now = moment();
        return state_hash(now.value.film, now.value.layers);
    }

  private:
    /// The active one becomes inactive, with a support of its own; another one becomes active on the
    /// canvas.
    void select(std::size_t place) {
        film::FilmState inactive = film_.moment().value.film;
        inactive.support_mm.write(3)[5] = 0x1p-20F * static_cast<float>(place + 1);
        stack_.layers[stack_.active].inactive = std::make_shared<const film::FilmState>(inactive);
        stack_.active = place;
        Moment awake;
        awake.value.film = *stack_.layers[place].inactive;
        film_.return_to(awake);
        stack_.layers[place].inactive.reset();
    }
    void add() {
        stack_.layers.push_back({.id = stack_.next_layer++});
        stack_.layers.back().inactive =
            std::make_shared<const film::FilmState>(film_.moment().value.film);
        select(stack_.layers.size() - 1);
    }
    void remove(std::size_t place) {
        stack_.layers.erase(stack_.layers.begin() + static_cast<std::ptrdiff_t>(place));
        if (stack_.active > place) --stack_.active;
    }

    struct : NoisyFilm {
        film::SupportHeights support_mm{{256, 256}};
    } film_;
    LayerStack stack_ = single_layer();
};

void change_and_remember(NoisyLayers& layers, History& history, std::uint32_t number) {
    history.remember(layers.moment(), {});
    layers.change(number);
}

TEST(History, ALayerThatIsAsleepCostsNothing) {
    NoisyFilm film;
    History history;
    Moment moment = film.moment();
    moment.value.layers.layers.push_back({.id = 2});
    moment.value.layers.layers[1].inactive = std::make_shared<const film::FilmState>(moment.value.film);
    for (int i = 0; i < 3; ++i) {
        history.remember(moment, {});
        film.change(i);
        moment.value.film = film.moment().value.film;
    }
    for (const KeptStep& step : history.past_steps())
        EXPECT_LT(step.bytes, 2 * kTileBytes);
    const Moment first = history.step_back(history.step_back(moment));
    EXPECT_EQ(first.value.layers.layers[1].inactive, moment.value.layers.layers[1].inactive);
}

/// A random walk over changes, undo and redo, with all that was ever seen kept beside it.
template <class Noisy>
struct Walk {
    explicit Walk(std::size_t budget_bytes) { history.set_budget(budget_bytes); }

    void step(std::uint32_t number) {
        const std::uint32_t choice = core::scramble(number) % 8;
        if (choice < 2 && history.can_undo()) {
            redo.push_back(now);
            film.return_to(history.step_back(film.moment()));
            now = film.hash();
            ASSERT_EQ(now, undo.back());
            undo.pop_back();
        } else if (choice == 2 && history.can_redo()) {
            undo.push_back(now);
            film.return_to(history.step_forward(film.moment()));
            now = film.hash();
            ASSERT_EQ(now, redo.back());
            redo.pop_back();
        } else {
            undo.push_back(now);
            redo.clear();
            change_and_remember(film, history, core::scramble(number + 7) % 16);
            now = film.hash();
        }
    }

    Noisy film;
    History history;
    std::uint64_t now = film.hash();
    std::vector<std::uint64_t> undo, redo;
};

template <class Noisy>
class RandomWalk : public testing::Test {};
using BothKinds = testing::Types<NoisyFilm, NoisyLayers>;
TYPED_TEST_SUITE(RandomWalk, BothKinds);

TYPED_TEST(RandomWalk, MeetsTheSameStates) {
    for (const std::size_t budget : {4 * kTileBytes, 30 * kTileBytes, History::kDefaultBudget_bytes}) {
        Walk<TypeParam> walk(budget);
        for (std::uint32_t i = 0; i < 150; ++i)
            walk.step(i);
    }
}

TYPED_TEST(RandomWalk, CanUndoTheSameWheneverStepsArePacked) {
    Walk<TypeParam> hurried(10 * kTileBytes), patient(10 * kTileBytes);
    for (std::uint32_t i = 0; i < 150; ++i) {
        hurried.step(i);
        patient.step(i);
        patient.history.finish_packing();
        ASSERT_EQ(hurried.history.can_undo(), patient.history.can_undo());
        ASSERT_EQ(hurried.now, patient.now);
    }
    hurried.history.finish_packing();
    EXPECT_EQ(hurried.history.past_steps().size(), patient.history.past_steps().size());
}

}  // namespace
}  // namespace pastoso::document
