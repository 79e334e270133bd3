#pragma once

#include <ranks/ranks.h>

namespace cdr::ranks {

/// A process that was started alone.
class OneProcess final : public Run {
  public:
    OneProcess() : Run({}) {}

    void requireSame(const std::string&, const std::string&) override {}
    void learnMachine() override {}
    void sayWhenKilled(const std::string&) override {}
    void forEachUnit(std::size_t count, const Make& make, const Take& take) override {
        forEachUnitTogether(count, make, take);
    }
    platform::Bytes share(platform::Bytes ofFirst) override { return ofFirst; }
    void merge(const std::function<platform::Bytes()>&,
               const std::function<void(const platform::Bytes& later)>&) override {}
    Ending end(const Ending& mine) override { return mine; }
};

} // namespace cdr::ranks
