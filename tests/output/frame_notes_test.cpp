#include <gtest/gtest.h>
#include <output/frame_notes.h>

namespace {

using cdr::output::noteOn;
using cdr::render::ListRefusal;
using Cause = ListRefusal::Cause;

std::string noteOf(const ListRefusal& refusal) {
    return noteOn(refusal, "the device", 640, 360);
}

TEST(FrameNotes, SayWhatEmptyListsLack) {
    EXPECT_EQ(noteOf({.cause = Cause::noFragmentStores}), "the device lacks fragmentStoresAndAtomics");
    EXPECT_EQ(noteOf({.cause = Cause::storageBuffers}),
              "the device has too few storage buffers in a fragment shader");
    EXPECT_EQ(noteOf({.cause = Cause::bound, .neededBytes = 921'600, .allowedBytes = 1000}),
              "lists of a 640x360 picture need 921600 bytes before the first fragment, 1000 are allowed");
    EXPECT_EQ(noteOf({.cause = Cause::bufferSize, .neededBytes = 921'600, .allowedBytes = 1000}),
              "lists of a 640x360 picture need a 921600 byte buffer, the device allows 1000");
    EXPECT_EQ(noteOf({.cause = Cause::memory, .neededBytes = 921'600, .allowedBytes = 1000}),
              "lists of a 640x360 picture need 921600 bytes, the device has 1000 free");
}

TEST(FrameNotes, SayWhatFragmentsLack) {
    const std::uint64_t needed = std::uint64_t{40} << 20u;
    const std::uint64_t allowed = std::uint64_t{16} << 20u;
    EXPECT_EQ(
        noteOf({.cause = Cause::bound, .fragments = 70, .neededBytes = needed, .allowedBytes = allowed}),
        "70 translucent fragments need 40 MiB, 16 are allowed");
    EXPECT_EQ(
        noteOf({.cause = Cause::bufferSize, .fragments = 70, .neededBytes = 9000, .allowedBytes = 4096}),
        "70 translucent fragments need a 9000 byte buffer, the device allows 4096");
    EXPECT_EQ(noteOf({.cause = Cause::memory, .fragments = 70, .neededBytes = 9000, .allowedBytes = 4096}),
              "70 translucent fragments need 9000 bytes, the device has 4096 free");
    EXPECT_EQ(noteOf({.cause = Cause::bound,
                      .fragments = 70,
                      .neededBytes = needed,
                      .allowedBytes = allowed,
                      .mayBeMore = true}),
              "at least 70 translucent fragments need 40 MiB, 16 are allowed");
}

} // namespace
