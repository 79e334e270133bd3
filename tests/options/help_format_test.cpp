#include <CLI/CLI.hpp>

#include <gtest/gtest.h>
#include <options/help_format.h>

#include <string>
#include <vector>

namespace cdr::options {

namespace {

TEST(HelpFormat, DefaultsStandAsTheCommandLineTakesThem) {
    CLI::App command;
    std::vector<double> distances{1.0, 1000.0};
    const CLI::Option* listed =
        command.add_option("--distances", distances, "Distances")->delimiter(',')->capture_default_str();
    EXPECT_EQ(optionMeaning(*listed), "Distances (default: 1,1000)");
    std::string name;
    const CLI::Option* named = command.add_option("--name", name, "Name")->default_str("all of them");
    EXPECT_EQ(optionMeaning(*named), "Name (default: all of them)");
}

TEST(HelpFormat, SaysWhatIsRequiredNeededAndExcluded) {
    CLI::App command;
    double number = 0.0;
    bool isOn = false;
    CLI::Option* required = command.add_option("--gap", number, "Gap")->required();
    EXPECT_EQ(optionMeaning(*required), "Gap (required)");
    CLI::Option* flag = command.add_flag("--measured", isOn, "Measure");
    EXPECT_EQ(optionMeaning(*command.add_option("--frames", number, "Frames")->needs(flag)),
              "Frames (only with --measured)");
    EXPECT_EQ(optionMeaning(*command.add_option("--path", number, "Path")->excludes(flag)),
              "Path (not with --measured)");
    EXPECT_EQ(optionMeaning(*command.add_option("scene", number, "Scene")->required()), "Scene");
}

} // namespace

} // namespace cdr::options
