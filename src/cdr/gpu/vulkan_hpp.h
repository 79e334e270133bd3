#pragma once

// vulkan.hpp as cdr uses it: designated initialisers for Vulkan's structs, no comparison operators that nobody uses, and
// calls by cdr's own functions. Include this, never <vulkan/vulkan.hpp>. No installed header includes either.
#ifdef VULKAN_HPP
#error "include <cdr/gpu/vulkan_hpp.h> instead of <vulkan/vulkan.hpp>"
#endif

#include <cdr/gpu/functions.h>

#define VK_NO_PROTOTYPES
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#define VULKAN_HPP_DEFAULT_DISPATCHER ::cdr::gpu::functions()
#define VULKAN_HPP_DEFAULT_DISPATCHER_TYPE ::cdr::gpu::Functions
#include <vulkan/vulkan.hpp>
