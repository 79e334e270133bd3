#include <cdr/gpu/rounding.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace cdr::gpu {
namespace {

constexpr std::uint32_t instruction(std::uint32_t opcode, std::uint32_t words) {
    return words << 16u | opcode;
}

/// Two capabilities, a memory model, an entry point of no interface, and one execution mode behind it. Numbers are as
/// the specification of SPIR-V has them.
const Spirv kShader(std::vector<std::uint32_t>{0x07230203,         0x00010600, 0,  9,          0, //
                                               instruction(17, 2), 1,                             //
                                               instruction(17, 2), 10,                            //
                                               instruction(14, 3), 0,          1,                 //
                                               instruction(15, 5), 5,          4,  0x6e69616d, 0, //
                                               instruction(16, 6), 4,          17, 64,         1, 1});

TEST(Rounding, IsDeclaredForBothWidthsInTheOrderOfTheSpecification) {
    const std::vector<std::uint32_t> expected{
        0x07230203,         0x00010600, 0,          9,          0, //
        instruction(17, 2), 4467,                                  //
        instruction(17, 2), 1,                                     //
        instruction(17, 2), 10,                                    //
        instruction(10, 7), 0x5f565053, 0x5f52484b, 0x616f6c66, 0x6f635f74, 0x6f72746e,
        0x0000736c,                                                // SPV_KHR_float_controls
        instruction(14, 3), 0,          1,                         //
        instruction(15, 5), 5,          4,          0x6e69616d, 0, //
        instruction(16, 4), 4,          4462,       32,            //
        instruction(16, 4), 4,          4462,       64,            //
        instruction(16, 6), 4,          17,         64,         1,          1};
    EXPECT_EQ(roundingToNearestEven(kShader).words, expected);
}

} // namespace
} // namespace cdr::gpu
