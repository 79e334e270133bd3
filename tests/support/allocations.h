#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

/// What a test program allocates. This replaces operator new of the whole program: include it in one of its sources.
namespace cdr::test {

/// Allocations until now.
inline std::atomic<std::size_t> allocations{0};
/// Allocations until one fails; below 0, none does.
inline std::atomic<long> allocationsLeft{-1};

} // namespace cdr::test

// Not inlined, since GCC then warns of a free() that meets operator new.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++cdr::test::allocations;
    if (cdr::test::allocationsLeft.load() >= 0 && cdr::test::allocationsLeft.fetch_sub(1) == 0) {
        throw std::bad_alloc();
    }
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
