#pragma once

#include <sstream>
#include <string>

namespace cdr::test {

/// What a shell puts in front of a program to start it as that many ranks of this machine; nothing for 0 of them. Ranks may
/// outnumber processors, root may start them, and the launcher keeps its own messages to itself.
inline std::string launched(const std::string& launcher, int ranks) {
    if (ranks == 0) {
        return "";
    }
    // MPI and its launcher keep memory until they end, in ways that no list of suppressions names. Its hwloc looks for graphics
    // cards at X servers. If an X server ends meanwhile, such as that of a test of the viewer, Xlib ends the launcher.
    return "HWLOC_COMPONENTS=-gl ASAN_OPTIONS=\"$ASAN_OPTIONS:detect_leaks=0\" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
           "OMPI_MCA_rmaps_base_oversubscribe=1 "
           "OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_orte_execute_quiet=1 "
           "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none '" +
           launcher + "' -n " + std::to_string(ranks);
}

/// Standard error of what was launched, without lines of libevent. On a busy machine it adds them within Open MPI, when a
/// pipe that it watches is closed.
inline std::string withoutWarningsOfEvents(const std::string& text) {
    std::string kept;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with("[warn] Epoll")) {
            kept += line + (stream.eof() ? "" : "\n");
        }
    }
    return kept;
}

} // namespace cdr::test
