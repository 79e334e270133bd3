// The report's page: fills each section from window.cdrReport, which data.js sets.

import { summary, verdicts } from "./logic/verdicts.js";
import { h } from "./view/elements.js";
import { copyInFull, unitChoice } from "./view/figures.js";
import { fillAdvise } from "./view/section_advise.js";
import { fillCertificates } from "./view/section_certificates.js";
import { fillCoplanar } from "./view/section_coplanar.js";
import { fillDetail } from "./view/section_detail.js";
import { fillEffects } from "./view/section_effects.js";
import { fillFocus } from "./view/section_focus.js";
import { fillInspect } from "./view/section_inspect.js";
import { fillOpening } from "./view/section_opening.js";
import { fillOrbit } from "./view/section_orbit.js";
import { fillTranslucency } from "./view/section_translucency.js";
import { facts, fillEnvironment } from "./view/section_environment.js";
import { fillFlicker, fillNearObject } from "./view/section_flicker.js";
import { fillPictures } from "./view/section_pictures.js";
import { fillPrecision } from "./view/section_precision.js";
import { fillProbe } from "./view/section_probe.js";
import { fillRivals } from "./view/section_rivals.js";
import { fillScaling } from "./view/section_scaling.js";
import { fillShadows } from "./view/section_shadows.js";
import { fillStereo } from "./view/section_stereo.js";
import { fillTiming } from "./view/section_timing.js";
import { fillFailure, fillSource, partOf } from "./view/source.js";
import { fillVerdicts, repeatInSections } from "./view/verdict_list.js";

const fillers = {
    precision: fillPrecision,
    pictures: fillPictures,
    flicker: fillFlicker,
    "flicker-near": fillNearObject,
    probe: fillProbe,
    timing: fillTiming,
    scaling: fillScaling,
    rivals: fillRivals,
    detail: fillDetail,
    translucency: fillTranslucency,
    effects: fillEffects,
    focus: fillFocus,
    orbit: fillOrbit,
    advise: fillAdvise,
    inspect: fillInspect,
    coplanar: fillCoplanar,
};

/** Parts of the page that several results fill together. */
const gatherers = { shadows: fillShadows, stereo: fillStereo, certificates: fillCertificates };

/** Takes a section and its link from the page. */
function removeSection(section) {
    document.querySelector(`.contents a[href="#${section.id}"]`).parentElement.remove();
    section.remove();
}

/** The verdicts on what the report was asked for. The page loses all other sections. */
function keepAskedFor({ report, sections }) {
    const parts = new Set(report.results.map((row) => partOf(row.section)));
    for (const section of document.querySelectorAll("section:not(#opening, #verdicts, #environment)")) {
        if (!parts.has(section.id)) {
            removeSection(section);
        }
    }
    const asked = new Set(report.results.map((row) => row.section)); // a part that is there may lack the result to judge
    const judged = verdicts(sections).filter((verdict) => asked.has(verdict.section));
    if (judged.length === 0) {
        removeSection(document.getElementById("verdicts"));
    }
    return judged;
}

function fillVerdictParts(judged, report) {
    if (judged.length > 0) {
        document.getElementById("summary").textContent = summary(judged, report.results.reduce((sum, row) => sum + row.seconds, 0));
        fillVerdicts(document.getElementById("verdict-list"), judged);
        repeatInSections(judged);
    }
}

function fillPage({ report, sections }) {
    fillVerdictParts(keepAskedFor({ report, sections }), report);
    document.getElementById("facts").append(...facts(report).map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value))));
    fillOpening(sections, report.results.find((row) => row.section === "orbit")?.folder);
    for (const row of report.results) {
        const results = sections[row.section];
        if (row.failure) {
            fillFailure(row);
        }
        if (results && fillers[row.section]) {
            fillers[row.section](results, row.folder);
        }
        fillSource(row, results, report);
    }
    for (const [part, gather] of Object.entries(gatherers)) {
        const rows = report.results.filter((row) => partOf(row.section) === part && sections[row.section]);
        gather(rows.map((row) => ({ document: sections[row.section], folder: row.folder })));
    }
    fillEnvironment(report);
    document.getElementById("reading").append(unitChoice(), " Numbers show four digits; what you copy has all of them.");
    copyInFull();
}

if (window.cdrReport) {
    fillPage(window.cdrReport);
} else {
    document.getElementById("main").prepend(h("p", { class: "notice" },
        "There are no results here: data.js is missing from this folder. `cdr report --quick -o report` measures them."));
}
