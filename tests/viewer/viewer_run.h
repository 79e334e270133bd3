#pragma once

#include "../support/shell.h"
#include "../support/temporary_folder.h"
#include "display.h"

#include <cdr/image/image.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cdr::viewer_test {

struct RunResult : test::ShellResult {
    /// The printed lines that begin with `start`.
    std::vector<std::string> lines(const std::string& start) const;
    /// What its steps `state` printed. Expects, and returns, that many lines.
    std::vector<std::string> states(std::size_t count) const;
};

/// Runs a command in a shell, in `folder`, with `environment` set as typed.
RunResult runShell(const std::string& command, const std::filesystem::path& folder,
                   const std::string& environment);

/// A display, a folder, and viewers that play scripts in them under the validation layers.
class ViewerTest : public testing::Test {
  protected:
    /// Runs the viewer with a script, and expects that it ends well and that validation is silent.
    RunResult play(const std::string& arguments, const std::string& script);
    /// What a copied command line draws. The line names the program as a person would; the test knows where it was built.
    image::ImageRgba8 drawnBy(const std::string& line) const;
    /// What a picture or window step of the script wrote.
    image::ImageRgba8 picture(const std::string& name) const;
    const std::filesystem::path& folder() const { return m_folder.path(); }
    std::string environment() const { return m_display.environment(); }

  private:
    test::TemporaryFolder m_folder;
    Display m_display;
};

image::ImageRgba8 readPicture(const std::filesystem::path& file);

/// NAME=VALUE of a state line; empty without it.
std::string valueOf(const std::string& state, const std::string& name);

/// Share of pixels, within columns [left, right), whose colour differs between two pictures of one size.
double difference(const image::ImageRgba8& a, const image::ImageRgba8& b, std::uint32_t left = 0,
                  std::uint32_t right = UINT32_MAX);
/// Mean of all colour channels, 0 to 255.
double brightness(const image::ImageRgba8& picture);
/// How many different colours there are.
std::size_t colors(const image::ImageRgba8& picture);

} // namespace cdr::viewer_test
