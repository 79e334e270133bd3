// The answers of the experiment as comma-separated values (RFC 4180, without line breaks inside a field).

/** Rows of a file's text; quoted fields may hold commas and doubled quotes. */
export function parseRows(text) {
    return text
        .replace(/^\ufeff/, "")
        .split(/\r\n|\n|\r/)
        .filter((line) => line.trim() !== "")
        .map(parseLine);
}

/** One line of fields, each quoted where it has to be. A leading formula sign is quoted away from spreadsheets. */
export function formatRow(fields) {
    return fields
        .map((field) => {
            const text = String(field).replace(/[\r\n]+/g, " ");
            const safe = /^[=+@\t-]/.test(text) && Number.isNaN(Number(text)) ? `'${text}` : text;
            return /[",]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
        })
        .join(",");
}

function parseLine(line) {
    const fields = [];
    let at = 0;
    do {
        if (line[at] === '"') {
            const { field, end } = quotedField(line, at + 1);
            fields.push(field);
            at = end;
        } else {
            const comma = line.indexOf(",", at);
            const end = comma < 0 ? line.length : comma;
            fields.push(line.slice(at, end));
            at = end;
        }
    } while (at++ < line.length);
    return fields;
}

/** The field from behind its opening quote; `end` is where the comma or the line's end stands. */
function quotedField(line, start) {
    let field = "";
    for (let at = start; at < line.length; ++at) {
        if (line[at] !== '"') {
            field += line[at];
        } else if (line[at + 1] === '"') {
            field += line[++at];
        } else {
            const comma = line.indexOf(",", at);
            return { field, end: comma < 0 ? line.length : comma };
        }
    }
    return { field, end: line.length };
}
