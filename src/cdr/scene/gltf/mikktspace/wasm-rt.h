#pragma once

/// @file
/// What C source made by wasm2c needs around it, for one module without signal handlers: MikkTSpace's. The names are wasm2c's.
/// Every access to memory is checked. A fault throws from wasm_rt_trap(), so C source that includes this needs -fexceptions.
/// A module's memory and table lie in arrays that its owner set before it is instantiated, and hold all of its state.
/// @errors As each function says. @threads One at a time for a module; modules share nothing.

// NOLINTBEGIN(modernize-*,readability-identifier-naming): C, with names that wasm2c prescribes
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define LIKELY(x) __builtin_expect(!!(x), 1)
#define UNLIKELY(x) __builtin_expect(!!(x), 0)
#define wasm_rt_memcpy memcpy
#define wasm_rt_is_initialized() true
#define wasm_rt_unused __attribute__((unused))

// A count of nested calls in each module, where wasm2c has one for all.
#define WASM_RT_STACK_DEPTH_COUNT 1
#define wasm_rt_call_stack_depth (instance->w2c_memory.depth)
#define WASM_RT_MAX_CALL_STACK_DEPTH (instance->w2c_memory.max_depth)

#ifdef __cplusplus
extern "C" {
#endif

/// Why a module cannot go on.
typedef enum {
    WASM_RT_TRAP_OOB,
    WASM_RT_TRAP_INT_OVERFLOW,
    WASM_RT_TRAP_DIV_BY_ZERO,
    WASM_RT_TRAP_INVALID_CONVERSION,
    WASM_RT_TRAP_UNREACHABLE,
    WASM_RT_TRAP_CALL_INDIRECT,
    WASM_RT_TRAP_EXHAUSTION
} wasm_rt_trap_t;

/// Types of values, to describe functions.
typedef enum { WASM_RT_I32, WASM_RT_I64, WASM_RT_F32, WASM_RT_F64 } wasm_rt_type_t;

/// The memory of a module.
typedef struct {
    uint8_t* data;      ///< of its owner: max_size bytes, zero
    uint64_t size;      ///< bytes that the module may use now
    uint64_t max_size;  ///< bytes that it may come to use
    uint32_t depth;     ///< nested calls
    uint32_t max_depth; ///< more are a fault
} wasm_rt_memory_t;

typedef const char* wasm_rt_func_type_t;
typedef void (*wasm_rt_function_ptr_t)(void);

/// Not used without tail calls.
typedef struct {
    void* fn;
} wasm_rt_tailcallee_t;

/// A function in a table.
typedef struct {
    wasm_rt_func_type_t func_type;
    wasm_rt_function_ptr_t func;
    wasm_rt_tailcallee_t func_tailcallee;
    void* module_instance;
} wasm_rt_funcref_t;

/// A table of functions.
typedef struct {
    wasm_rt_funcref_t* data; ///< of its owner: max_size elements, null
    uint32_t size;
    uint32_t max_size;
} wasm_rt_funcref_table_t;

typedef void* wasm_rt_externref_t;

/// Named by helpers that are not called.
typedef struct {
    wasm_rt_externref_t* data;
    uint32_t size;
} wasm_rt_externref_table_t;

static const wasm_rt_funcref_t wasm_rt_funcref_null_value wasm_rt_unused = {NULL, NULL, {NULL}, NULL};
static const wasm_rt_externref_t wasm_rt_externref_null_value wasm_rt_unused = NULL;

/// Ends a call by throwing a C++ exception.
__attribute__((noreturn)) void cdr_mikktspace_trap(wasm_rt_trap_t cause);
#define wasm_rt_trap cdr_mikktspace_trap

/// Gives a module its first pages. A fault where they are too many.
static inline void wasm_rt_allocate_memory(wasm_rt_memory_t* memory, uint64_t pages, uint64_t max_pages,
                                           bool is64, uint32_t page_size) {
    (void)max_pages;
    (void)is64;
    memory->size = pages * page_size;
    if (memory->size > memory->max_size) {
        wasm_rt_trap(WASM_RT_TRAP_OOB);
    }
}

/// Gives it more, each of 65536 bytes. Returns how many it had, or -1 where they are too many.
static inline uint32_t wasm_rt_grow_memory(wasm_rt_memory_t* memory, uint64_t pages) {
    const uint64_t size = memory->size + (pages << 16u);
    const uint32_t before = (uint32_t)(memory->size >> 16u);
    if (size > memory->max_size) {
        return UINT32_MAX;
    }
    memory->size = size;
    return before;
}

/// Gives it a table. A fault where that is too large.
static inline void wasm_rt_allocate_funcref_table(wasm_rt_funcref_table_t* table, uint32_t elements,
                                                  uint32_t max) {
    (void)max;
    table->size = elements;
    if (elements > table->max_size) {
        wasm_rt_trap(WASM_RT_TRAP_OOB);
    }
}

// The owner of the arrays frees them.
#define wasm_rt_free_memory(memory) (void)(memory)
#define wasm_rt_free_funcref_table(table) (void)(table)

#ifdef __cplusplus
}
#endif
// NOLINTEND(modernize-*,readability-identifier-naming)
