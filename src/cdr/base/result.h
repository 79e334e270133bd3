#pragma once

#include <cdr/base/error.h>

#include <string>
#include <utility>
#include <variant>

namespace cdr::base {

/// Why there is no value: one line, as an InputError would say it.
struct Refusal {
    std::string message; ///< without a line break
};

/// A value, or why there is none: what functions return that do not throw.
/// @threads As the value: any number of them may read it at once.
/// @errors None but orThrow()'s.
/// @lifetime References stay valid until the result is assigned to or destroyed.
template <typename Value>
class Result {
  public:
    /// A value.
    // NOLINTNEXTLINE(google-explicit-constructor): functions return a value as it is
    Result(Value value) : m_content(std::in_place_index<0>, std::move(value)) {}
    /// Why there is none.
    // NOLINTNEXTLINE(google-explicit-constructor): functions return a refusal as it is
    Result(Refusal refusal) : m_content(std::in_place_index<1>, std::move(refusal)) {}

    /// Whether there is a value.
    explicit operator bool() const { return m_content.index() == 0; }
    /// Only where there is a value, which is not checked.
    const Value& operator*() const { return *std::get_if<0>(&m_content); }
    /// Null where there is none.
    const Value* operator->() const { return std::get_if<0>(&m_content); }
    /// Only where there is none, which is not checked.
    const Refusal& refusal() const { return *std::get_if<1>(&m_content); }

    /// The value, moved out.
    /// @throws InputError with the refusal's message where there is none.
    Value orThrow() && {
        if (!*this) {
            raise<InputError>(refusal().message);
        }
        return std::move(*std::get_if<0>(&m_content));
    }

  private:
    std::variant<Value, Refusal> m_content;
};

} // namespace cdr::base
