#include "columns.h"

#include "readable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::output {

namespace {

std::string plainText(const Json& value) {
    if (value.is_null()) {
        return "";
    }
    if (value.is_number_float()) {
        return fmt::format("{}", value.get<double>());
    }
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// What a row has there; null for a part of null, such as an end of an interval that does not exist.
Json partAt(const Json& row, const Json::json_pointer& pointer) {
    return row.at(pointer.parent_pointer()).is_null() ? Json(nullptr) : row.at(pointer);
}

} // namespace

CsvField::CsvField(const char* text) : heading(text), pointer("/" + heading) {
    if (const std::size_t equals = heading.find('='); equals != std::string::npos) {
        pointer = heading.substr(equals + 1);
        heading.resize(equals);
    }
}

std::string cellOf(const Json& value, const CellFormat& format) {
    const auto pattern = fmt::runtime(format.pattern);
    if (value.is_null() || value.is_discarded()) {
        return format.missing;
    }
    const auto readable = [&](const Json& number) {
        return Readable{format.scale * number.get<double>(), format.unit};
    };
    if (value.is_array()) {
        return fmt::format(pattern, readable(value.at(0)), readable(value.at(1)));
    }
    if (value.is_number_float()) {
        return fmt::format(pattern, readable(value));
    }
    return fmt::format(pattern, plainText(value));
}

std::string csvOf(const std::vector<CsvField>& fields, const Json& rows) {
    std::vector<std::string> cells;
    for (const CsvField& field : fields) {
        cells.push_back(field.heading);
    }
    std::string csv = fmt::format("{}\n", fmt::join(cells, ","));
    for (const Json& row : rows) {
        cells.clear();
        for (const CsvField& field : fields) {
            cells.push_back(plainText(partAt(row, Json::json_pointer(field.pointer))));
        }
        csv += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return csv;
}

} // namespace cdr::output
