#pragma once

#include <cdr/base/quantity_text.h>
#include <cdr/measure/statistics/statistics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Null stands for what is not known.
template <typename Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
    template <typename AnyJson>
    // NOLINTNEXTLINE(readability-identifier-naming): a name of the library's
    static void to_json(AnyJson& json, const std::optional<Value>& value) {
        json = value ? AnyJson(*value) : AnyJson(nullptr);
    }
};

namespace cdr::output {

using Json = nlohmann::ordered_json;

/// How a table writes a value.
struct CellFormat {
    std::string pattern = "{}"; ///< of fmt, in which numbers are Readable; for an array of two it takes both
    double scale = 1.0;         ///< numbers are multiplied by it, such as 100 for percent
    std::string missing{};      ///< what stands for null and for what is absent
    base::LengthUnit unit = base::LengthUnit::none; ///< of a length
};

/// A field of a result: its name in JSON, its heading in the table, its value.
template <typename Row>
struct Column {
    std::string key{}; ///< in JSON; empty: the table alone has it
    std::function<Json(const Row&)> value{};
    std::string heading{}; ///< in the table; empty: JSON alone has it
    CellFormat format{};
    std::function<std::string(const Row&)> text{}; ///< what the table says instead of the formatted value
    std::string before{}; ///< heading that it stands before in the table; else the order is that of JSON
};

/// What a row has there. JSON has no infinity: null stands for it, and for what is not known.
template <typename Row>
Json valueOf(const Column<Row>& column, const Row& row) {
    Json value = column.value(row);
    return value.is_number_float() && !std::isfinite(value.template get<double>()) ? Json(nullptr) : value;
}

/// The fields of an experiment's results, in the order of JSON. One list makes both JSON and the table.
template <typename Row>
using Columns = std::vector<Column<Row>>;

/// A header and rows of cells.
struct Table {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

/// A value that JSON leaves out.
inline Json absent() {
    return Json(Json::value_t::discarded);
}

/// Both ends, as CellFormat's patterns take them.
inline Json jsonOf(const std::optional<measure::Interval>& interval) {
    return interval ? Json{interval->low, interval->high} : Json(nullptr);
}

/// What a column of intervals is called, and how the table writes one.
struct IntervalTexts {
    std::string key = "ci95";
    std::string heading = "95 % interval";
    std::string pattern = "{} to {}";
};

/// A bootstrap interval of 95 %, in JSON and in the table. Where a row has none: null and "-".
template <typename Row>
Column<Row> intervalColumn(std::optional<measure::Interval> Row::*interval, const IntervalTexts& texts = {}) {
    return {.key = texts.key,
            .value = [interval](const Row& row) { return jsonOf(row.*interval); },
            .heading = texts.heading,
            .format = {.pattern = texts.pattern, .missing = "-"}};
}

/// One cell of a table.
std::string cellOf(const Json& value, const CellFormat& format);

template <typename Row>
Json jsonOf(const Columns<Row>& columns, const Row& row) {
    Json json = Json::object();
    for (const Column<Row>& column : columns) {
        if (column.key.empty()) {
            continue;
        }
        if (Json value = valueOf(column, row); !value.is_discarded()) {
            json[column.key] = std::move(value);
        }
    }
    return json;
}

/// An array of jsonOf().
template <typename Row>
Json jsonOf(const Columns<Row>& columns, const std::vector<Row>& rows) {
    Json json = Json::array();
    for (const Row& row : rows) {
        json.push_back(jsonOf(columns, row));
    }
    return json;
}

/// The columns that have a heading, in the table's order.
template <typename Row>
Columns<Row> shownOf(const Columns<Row>& columns) {
    Columns<Row> shown;
    std::copy_if(columns.begin(), columns.end(), std::back_inserter(shown),
                 [](const Column<Row>& column) { return !column.heading.empty() && column.before.empty(); });
    for (const Column<Row>& column : columns) {
        if (!column.heading.empty() && !column.before.empty()) {
            const auto place = std::find_if(shown.begin(), shown.end(), [&](const Column<Row>& other) {
                return other.heading == column.before;
            });
            shown.insert(place, column);
        }
    }
    return shown;
}

/// A row of the table.
template <typename Row>
std::vector<std::string> cellsOf(const Columns<Row>& columns, const Row& row) {
    std::vector<std::string> cells;
    for (const Column<Row>& column : shownOf(columns)) {
        cells.push_back(column.text ? column.text(row) : cellOf(valueOf(column, row), column.format));
    }
    return cells;
}

template <typename Row>
Table tableOf(const Columns<Row>& columns, const std::vector<Row>& rows) {
    Table table;
    for (const Column<Row>& column : shownOf(columns)) {
        table.header.push_back(column.heading);
    }
    for (const Row& row : rows) {
        table.rows.push_back(cellsOf(columns, row));
    }
    return table;
}

/// The columns of a part of a row as columns of the row. A row may lack the part; then its values are absent.
/// @param part gives a row's std::optional, or a pointer.
template <typename Row, typename Get, typename Part>
Columns<Row> columnsOf(Get part, const Columns<Part>& columns) {
    const auto ofPart = [part](auto get, auto otherwise) {
        return [part, get, otherwise](const Row& row) {
            const auto& held = std::invoke(part, row);
            return held ? get(*held) : otherwise;
        };
    };
    Columns<Row> result;
    for (const Column<Part>& column : columns) {
        result.push_back({.key = column.key,
                          .value = ofPart(column.value, absent()),
                          .heading = column.heading,
                          .format = column.format,
                          .before = column.before});
        if (column.text) {
            result.back().text = ofPart(column.text, std::string());
        }
    }
    return result;
}

/// The same of a part that each row has.
template <typename Row, typename Part>
Columns<Row> columnsOf(Part Row::*part, const Columns<Part>& columns) {
    return columnsOf<Row>([part](const Row& row) { return &(row.*part); }, columns);
}

/// Lists of columns, one after the other.
template <typename Row>
Columns<Row> joined(const std::vector<Columns<Row>>& lists) {
    Columns<Row> all;
    for (const Columns<Row>& list : lists) {
        all.insert(all.end(), list.begin(), list.end());
    }
    return all;
}

/// A column of a CSV file: a value in rows of JSON.
struct CsvField {
    /// @param text a row's key, or the heading and the pointer with "=" between.
    // NOLINTNEXTLINE(google-explicit-constructor): so that a list of fields is one of names
    CsvField(const char* text);

    std::string heading;
    std::string pointer; ///< JSON pointer into a row
};

/// Rows of jsonOf() as CSV with a header. Null is an empty field, and so is each part of it.
std::string csvOf(const std::vector<CsvField>& fields, const Json& rows);

} // namespace cdr::output
