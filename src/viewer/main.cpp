#include <CLI/CLI.hpp>
#include <cdr/host/kept_memory.h>
#include <viewer/session/program.h>

int main(int argc, char** argv) {
    cdr::host::keepFreedMemory();
    return cdr::viewer::exitStatusOf("cdr-viewer", [&] {
        cdr::viewer::Arguments arguments;
        CLI::App program(
            "Look at scenes under two depth techniques at once. F1 in the window shows the keys.",
            "cdr-viewer");
        cdr::viewer::addViewerOptions(program, arguments);
        if (const auto status = cdr::viewer::parse(program, argc, argv)) {
            return *status;
        }
        arguments.isFirstUse = argc <= 1;
        cdr::viewer::runViewer(arguments);
        return 0;
    });
}
