// The experiment on people: shows the trials of logic/sitting.js and keeps their answers.

import { pairRows } from "./logic/flicker.js";
import { answered, freshSeed, nextTrial, reopen, restore, restoreOthers, startSitting, store } from "./logic/sitting.js";
import { compared, fromCsv, maxBytes, toCsv, withoutRepeats } from "./logic/trials.js";
import { makeAgreement, makePairs, makeTally } from "./view/tally.js";
import { Trial } from "./view/trial.js";

const kKey = "cdr-compare";
const kOthersKey = "cdr-compare-others";
const byId = (id) => document.getElementById(id);

/** Local storage, where the browser lends it to a page opened from a file. */
const kept = {
    read(key) {
        try {
            return localStorage.getItem(key);
        } catch {
            return null;
        }
    },
    /** @returns {boolean} whether it was kept; else it lives as long as the page. */
    write(key, text) {
        try {
            localStorage.setItem(key, text);
            return true;
        } catch {
            return false;
        }
    },
    /** @returns {boolean} whether the text stands under another key now. */
    move(key, to) {
        const isMoved = this.write(to, this.read(key));
        if (isMoved) {
            localStorage.removeItem(key);
        }
        return isMoved;
    },
};

const askedSeed = new URLSearchParams(location.search).get("seed");
let { sitting, others } = reopen(kept.read(kKey), kept.read(kOthersKey), askedSeed);
const flicker = window.cdrReport?.sections.flicker ?? { results: [] }; // a copy of this page may lie elsewhere
/** Pictures of the scene that the videos show, if this report has them. */
const stills = {
    pictures: (window.cdrReport?.sections.pictures?.results ?? []).filter((picture) => picture.scene === "afc"),
    folder: window.cdrReport?.report.results.find((row) => row.section === "pictures")?.folder,
};
let loaded = []; // from files, which keep them
const trial = new Trial({
    onAnswer(answer) {
        sitting = answered(sitting, answer);
        keep();
        showNext(true);
    },
});

/**
 * Moves what this page cannot read to a key of its own, where nothing is written over it.
 * @returns {?object[]} no answers; null where the browser does not keep it.
 */
function setAside(key) {
    return kept.move(key, `${key}-unread-${Date.now()}`) ? [] : null;
}

/** Keeps the sitting, which is written over another one: that one's answers are kept first. Another tab may have added some. */
function keep() {
    const earlier = restoreOthers(kept.read(kOthersKey)) ?? setAside(kOthersKey);
    const text = kept.read(kKey);
    const written = text ? (restore(text)?.answers ?? setAside(kKey)) : [];
    if (!earlier || !written) {
        return;
    }
    others = withoutRepeats([...others, ...earlier, ...written]);
    if (kept.write(kOthersKey, toCsv(others))) {
        kept.write(kKey, store(sitting));
    }
}

function show(id) {
    for (const section of ["welcome", "trial", "done"]) {
        byId(section).hidden = section !== id;
    }
}

function showWelcome(seed) {
    sitting = startSitting("", seed);
    byId("seed").textContent = sitting.seed;
    byId("seed-link").href = `?seed=${encodeURIComponent(sitting.seed)}`;
    show("welcome");
    showTally();
}

/** @param {boolean} focus whether somebody is at work, whose keyboard should land in the right place. */
function showNext(focus) {
    const next = nextTrial(sitting);
    show(next ? "trial" : "done");
    if (next) {
        trial.begin(next, focus);
    } else {
        const answers = compared(sitting.answers, pairRows(flicker));
        byId("agreement").replaceChildren(...makeAgreement(answers));
        byId("pairs").replaceChildren(...makePairs(answers, stills.pictures, stills.folder));
    }
    if (!next && focus) {
        byId("done-title").focus();
    }
    showTally();
}

function allAnswers() {
    return withoutRepeats([...sitting.answers, ...others, ...loaded]);
}

function showTally() {
    const answers = allAnswers();
    const people = new Set(answers.map((answer) => `${answer.participant} ${answer.seed}`)).size;
    byId("counted").textContent = `${answers.length} ${answers.length === 1 ? "answer" : "answers"} of ${people} ${people === 1 ? "person" : "people"}.`;
    byId("tally").replaceChildren(makeTally(answers));
}

function download(name, text) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv;charset=utf-8" }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Adds files of answers; one that is none is named, and the others count. Says how many answers are there already. */
async function loadFiles(files) {
    const refused = [];
    let repeats = 0;
    for (const file of files) {
        try {
            if (file.size > maxBytes) {
                throw new Error(`over the limit of ${maxBytes} bytes`);
            }
            const answers = fromCsv(await file.text());
            const before = allAnswers().length;
            loaded = withoutRepeats([...loaded, ...answers]);
            repeats += answers.length - (allAnswers().length - before);
        } catch (error) {
            refused.push(`${file.name}: ${error.message}`);
        }
    }
    if (repeats > 0) {
        refused.push(`${repeats} ${repeats === 1 ? "answer" : "answers"} left out: their name, lot and pair are here already`);
    }
    byId("refused").hidden = refused.length === 0;
    byId("refused").textContent = refused.join("; ");
    showTally();
}

byId("start").addEventListener("submit", (event) => {
    event.preventDefault();
    sitting = startSitting(byId("participant").value, sitting.seed);
    keep();
    showNext(true);
});
byId("save").addEventListener("click", () => download(`answers-${sitting.seed}.csv`, toCsv(sitting.answers)));
byId("save-all").addEventListener("click", () => download("answers-all.csv", toCsv(allAnswers())));
byId("again").addEventListener("click", () => {
    others = withoutRepeats([...others, ...sitting.answers]);
    showWelcome(freshSeed(crypto.getRandomValues(new Uint8Array(8))));
    byId("participant").value = "";
    byId("participant").focus();
});
byId("load").addEventListener("change", (event) => loadFiles(event.target.files));

if (sitting) {
    showNext(false);
} else {
    showWelcome(askedSeed ?? freshSeed(crypto.getRandomValues(new Uint8Array(8))));
}
