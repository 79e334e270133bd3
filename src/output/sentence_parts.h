#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cdr::output {

/// A length that sentenceParts() finds again in a sentence.
std::string markedLength(double view);

/// Sentences in parts: texts, and numbers where a length stands, for whoever writes lengths another way.
/// @param lines with lengths by markedLength().
nlohmann::ordered_json sentenceParts(const std::vector<std::string>& lines);

} // namespace cdr::output
