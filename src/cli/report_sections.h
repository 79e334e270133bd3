#pragma once

#include "command.h"
#include "forecast.h"

#include <report/plan.h>

#include <output/columns.h>
#include <ranks/one_process.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace cdr::cli {

/// Runs sections of a plan into a folder, each as one process does. Every rank has one.
class SectionRunner {
  public:
    /// What is given must outlive it. @param pace as cli::measuredPace() gives it.
    SectionRunner(Command& command, const std::vector<report::Section>& plan, std::filesystem::path root,
                  double pace);

    /// Ranks share the sections. Those that measure time are the first rank's, which runs them last, while the others wait.
    /// @param keep called on the first rank after each.
    void runAll(const std::function<void()>& keep);

    /// By section, on the first rank. What each has: "seconds", "failure" (what went wrong; null if nothing did), "document"
    /// (null when there is none) and "files" (by name, the digests of those that it has written).
    const std::vector<output::Json>& outcomes() const { return m_outcomes; }

  private:
    output::Json run(std::size_t section);
    void add(std::size_t section, output::Json outcome);

    Command& m_command;
    const std::vector<report::Section>& m_plan;
    std::filesystem::path m_root;
    ranks::OneProcess m_alone;
    Forecast m_forecast;
    std::size_t m_done = 0;
    std::vector<output::Json> m_outcomes;
};

/// Forgets kept sections that failed, and those whose files changed since. Then removes all files from the report's folder
/// that belong to no kept section. On the first rank, before the sections.
void takeUpSections(runs::KeptRanks& kept, const std::filesystem::path& root);

} // namespace cdr::cli
