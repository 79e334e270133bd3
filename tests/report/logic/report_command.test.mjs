import assert from "node:assert/strict";
import { test } from "node:test";
import { reportCommand } from "../../../src/page/logic/report_command.js";
import { titles } from "../../../src/page/view/section_detail.js";

const options = { effort: "quick", sections: [], threads: 4, seed: 2013 };

test("the command for the whole report has what it was made with", () => {
    assert.equal(reportCommand(options), "cdr report --quick --threads 4 --seed 2013 -o .");
    assert.equal(reportCommand({ ...options, device: "0", sections: ["probe", "detail"] }),
        "cdr --device 0 report --quick --sections probe,detail --threads 4 --seed 2013 -o .");
    assert.equal(reportCommand({ ...options, device: "John's GPU" }),
        "cdr --device 'John'\\''s GPU' report --quick --threads 4 --seed 2013 -o .");
});

test("every way to choose levels of detail has a title", () => {
    for (const mode of ["none", "object", "cascade", "cluster", "none-again"]) {
        assert.match(titles[mode] ?? "", /^(In full|By)/, mode);
    }
});
