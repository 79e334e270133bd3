#include "drive_program.h"

int main(int argc, char** argv) {
    return cdr::viewer::runDriveProgram(argc, argv);
}
