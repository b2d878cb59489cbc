// The storage of one tile, shared between states until one of them writes (copy on write).
#pragma once

#include <array>
#include <atomic>
#include <utility>

#include "grid/shape.hpp"

namespace pastoso::grid {

/// A counted reference to the 64 x 64 values of a tile, row by row. Copies share the values. Whoever holds
/// the only reference may write; references may be dropped from any thread.
template <class T>
class TileBlock {
  public:
    TileBlock() = default;
    TileBlock(const TileBlock& other) : storage_(other.storage_) {
        if (storage_ != nullptr) storage_->references.fetch_add(1, std::memory_order_relaxed);
    }
    TileBlock(TileBlock&& other) noexcept : storage_(std::exchange(other.storage_, nullptr)) {}
    TileBlock& operator=(TileBlock other) noexcept {
        std::swap(storage_, other.storage_);
        return *this;
    }
    ~TileBlock() {
        if (storage_ != nullptr && storage_->references.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            delete storage_;
        }
    }

    /// A block whose values are not set.
    static TileBlock uninitialised() {
        TileBlock block;
        block.storage_ = new Storage;
        return block;
    }
    static TileBlock filled(const T& value) {
        TileBlock block = uninitialised();
        block.storage_->values.fill(value);
        return block;
    }
    static TileBlock copy_of(const T* values) {
        TileBlock block = uninitialised();
        std::copy_n(values, kTileCells, block.storage_->values.data());
        return block;
    }

    explicit operator bool() const { return storage_ != nullptr; }
    bool unique() const {
        return storage_ != nullptr && storage_->references.load(std::memory_order_acquire) == 1;
    }
    const T* read() const { return storage_->values.data(); }
    /// Only for the holder of the only reference.
    T* write() { return storage_->values.data(); }
    friend bool operator==(const TileBlock&, const TileBlock&) = default;

  private:
    struct Storage {
        std::atomic<int> references = 1;
        alignas(64) std::array<T, kTileCells> values;
    };
    Storage* storage_ = nullptr;
};

}  // namespace pastoso::grid
