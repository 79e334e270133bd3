import { duration } from "../logic/format.js";
import { h, slot, table } from "./elements.js";

export function facts(report) {
    const seconds = report.results.reduce((sum, row) => sum + row.seconds, 0);
    return [
        ["Device", report.device.name],
        ["Driver", report.device.driver],
        ["Measured", `${report.made_at.replace("T", " ").replace("Z", " UTC")}, ${report.options.effort}`],
        ["Took", duration(seconds)],
        ["Commit", report.commit],
    ];
}

export function fillEnvironment(report) {
    const rows = [
        ["cdr", `${report.version}, commit ${report.commit}`],
        ["Device", report.device.name], ["Driver", report.device.driver], ["Vulkan", report.device.api],
        ["Processors", report.host.cpus], ["Threads of an experiment", report.options.threads],
        ["Made at", report.made_at],
    ];
    slot("environment", "environment").append(
        table("What everything here was measured with.", null, rows.map(([name, value]) => [name, { content: value, properties: { style: "white-space: normal" } }])),
        h("p", {}, "Seeds make scenes, orders and pictures the same again; times differ. Where the device is a software rasteriser such as llvmpipe, times are those of the processor. The whole report once more, run in this folder:"),
        h("div", { class: "source" }, h("div", {}, h("pre", { style: "margin-top: 0.8em" }, h("code", {}, report.command_line)))),
        h("p", {}, "Every section\u2019s own command stands at its end. It runs in this folder, too."));
}
