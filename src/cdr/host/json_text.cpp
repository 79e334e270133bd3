#include <cdr/host/json_text.h>

namespace cdr::host {

std::string textOf(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace cdr::host
