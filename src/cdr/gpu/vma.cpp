// The one translation unit that holds the allocator's implementation.
#define VMA_IMPLEMENTATION
#include <vk_mem_alloc.h>
