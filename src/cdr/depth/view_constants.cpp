#include <cdr/depth/view_constants.h>

#include <cstddef>

namespace cdr::depth {

namespace {

void split(const std::array<double, 3>& vector, std::array<float, 4>& values, std::array<float, 4>& rests) {
    for (std::size_t i = 0; i < vector.size(); ++i) {
        const FloatPair pair = floatPair(vector[i]);
        values[i] = pair.value;
        rests[i] = pair.rest;
    }
}

} // namespace

// Not inlined: GCC 12 makes rests of 0 where it vectorises two of these side by side (-ftree-slp-vectorize).
[[gnu::noinline]] FloatPair floatPair(double number) {
    const auto value = static_cast<float>(number);
    return {value, static_cast<float>(number - static_cast<double>(value))};
}

ViewConstants viewConstants(const ViewAxes& axes) {
    ViewConstants constants;
    split(axes.eye, constants.eye, constants.eyeRest);
    split(axes.right, constants.right, constants.rightRest);
    split(axes.up, constants.up, constants.upRest);
    split(axes.forward, constants.forward, constants.forwardRest);
    return constants;
}

} // namespace cdr::depth
