#pragma once

namespace cdr::viewer {

/// All of cdr-viewer-drive: parses the command line, runs the viewer and returns the exit status. Errors end as one line on
/// standard error.
int runDriveProgram(int argc, char** argv);

} // namespace cdr::viewer
