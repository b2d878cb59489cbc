// How every program here gets memory for what asks for more than the usual alignment: tiles, which come
// and go by the megabyte. The C library's own aligned memory is hardly found again once it was freed
// (glibc bug 14581, mended in 2.38): the next tile of the same size takes new memory, and a quarter of
// the heap lies idle. Here the usual memory is asked for, and somewhat more.

#include <algorithm>
#include <cstdint>
#include <new>

static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= sizeof(void*));

/// The place begins behind at least one pointer, which tells where the memory itself begins.
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    const std::size_t step =
        std::max(static_cast<std::size_t>(alignment), std::size_t{__STDCPP_DEFAULT_NEW_ALIGNMENT__});
    void* memory = ::operator new(bytes + step);
    const std::size_t offset = step - reinterpret_cast<std::uintptr_t>(memory) % step;
    void* place = static_cast<std::byte*>(memory) + offset;
    static_cast<void**>(place)[-1] = memory;
    return place;
}

void operator delete(void* place, std::align_val_t) noexcept {
    if (place != nullptr) ::operator delete(static_cast<void**>(place)[-1]);
}

void operator delete(void* place, std::size_t, std::align_val_t alignment) noexcept {
    ::operator delete(place, alignment);
}
