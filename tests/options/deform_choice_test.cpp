#include "../support/refusal.h"
#include "parsing.h"

#include <gtest/gtest.h>
#include <options/deform_choice.h>

#include <utility>

namespace cdr::options {

namespace {

using scenes::Deform;

gpu::DeviceInfo deviceOf(gpu::DeviceKind kind, std::vector<std::string> missing) {
    gpu::DeviceInfo info;
    info.name = "card";
    info.kind = kind;
    info.deformMissing = std::move(missing);
    return info;
}

/// The device deforms by itself where it is a card that can.
TEST(DeformChoice, IsWhatSuitsTheDevice) {
    for (const gpu::DeviceKind kind : gpu::kDeviceKinds) {
        const bool isCard = kind != gpu::DeviceKind::cpu;
        const gpu::DeviceInfo able = deviceOf(kind, {});
        const gpu::DeviceInfo unable = deviceOf(kind, {"shaderFloat64"});
        EXPECT_EQ(deformOn(able, {}, VertexReaders::drawing), isCard ? Deform::device : Deform::cpu);
        EXPECT_EQ(deformOn(able, Deform::device, VertexReaders::drawing), Deform::device);
        EXPECT_EQ(deformOn(able, Deform::device, VertexReaders::drawingAndCpu), Deform::both);
        EXPECT_EQ(deformOn(able, Deform::cpu, VertexReaders::drawing), Deform::cpu);
        EXPECT_EQ(deformOn(unable, {}, VertexReaders::drawing), Deform::cpu);
        EXPECT_EQ(deformOn(unable, Deform::cpu, VertexReaders::drawingAndCpu), Deform::cpu);
    }
}

TEST(DeformChoice, WhatADeviceCannotDoIsRefused) {
    EXPECT_EQ(test::inputErrorOf([&] {
                  deformOn(
                      deviceOf(gpu::DeviceKind::discrete, {"shaderFloat64", "shaderRoundingModeRTEFloat64"}),
                      Deform::device, VertexReaders::drawing);
              }),
              "--deform device: card lacks shaderFloat64, shaderRoundingModeRTEFloat64");
}

TEST(DeformChoice, IsParsed) {
    CLI::App command;
    std::optional<Deform> deform;
    addDeform(command, deform);
    EXPECT_EQ(refusalOf(command, {}), "");
    EXPECT_FALSE(deform);
    EXPECT_EQ(refusalOf(command, {"--deform=device"}), "");
    EXPECT_EQ(deform, Deform::device);
    EXPECT_NE(refusalOf(command, {"--deform=both"}).find("'both'"), std::string::npos);
}

} // namespace

} // namespace cdr::options
