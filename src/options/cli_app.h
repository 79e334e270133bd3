#pragma once

// What a header needs of CLI11, whose own header is long. NOLINTNEXTLINE(readability-identifier-naming)
namespace CLI {
class App;
}
