// The command that makes a report again, from the options that its manifest keeps.

/** A word as a shell takes it. */
function quoted(word) {
    return /^[\w.,:/=+%-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

/** `cdr report` with the options of a report, into the folder it is run in. */
export function reportCommand({ device, effort, sections, threads, seed }) {
    return ["cdr", ...(device ? ["--device", quoted(device)] : []), "report", `--${effort}`,
        ...(sections.length > 0 ? ["--sections", sections.join(",")] : []),
        "--threads", threads, "--seed", seed, "-o", "."].join(" ");
}
