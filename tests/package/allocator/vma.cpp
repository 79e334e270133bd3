// The host's own copy of the allocator's functions. cdr has one too, and the two must not meet.
#define VMA_IMPLEMENTATION
#include <vk_mem_alloc.h>
