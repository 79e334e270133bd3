#pragma once

#include <cli/console.h>

#include <output/columns.h>
#include <rivals/rival.h>

#include <vector>

namespace cdr::cli {

// What the rivals beside a command's techniques need of a device; where there are none, nothing.

/// As a table, an empty line before it.
void printNeeds(const Console& console, const std::vector<rivals::NamedRival>& rivals);

/// As "needs" of the command's JSON.
void addNeeds(output::Json& document, const std::vector<rivals::NamedRival>& rivals);

} // namespace cdr::cli
