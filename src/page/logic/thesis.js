// What the thesis printed (Faleij and Ivannikov, Cascaded Deferred Rendering, BTH 2013). Facts only, each with its place.

/** Names of techniques for people, those of the thesis as it writes them. */
export const techniqueTitles = {
    standard: "Standard",
    cdr: "CDR",
    log: "Logarithmic",
    logcdr: "LogCDR",
    reversed: "Reversed",
    anchored: "Anchored",
    "standard-fitted": "Standard, fitted",
    "cdr-before": "CDR, cut before",
    "cdr-behind": "CDR, cut behind",
};

/** Of a technique for people; its name where it has no other. */
export const techniqueTitle = (technique) => techniqueTitles[technique] ?? technique;

/** The techniques that the thesis has, in its order. */
export const thesisTechniques = ["standard", "cdr", "log", "logcdr"];

/** Table 4.1: view distance at which the smallest resolvable separation reaches the key. */
export const table41 = {
    0.001: { standard: 4.096, cdr: 129.592, log: 662.386, logcdr: 2428.75 },
    0.01: { standard: 12.958, cdr: 409.81, log: 6623.86, logcdr: 24287.501 },
    0.1: { standard: 41.01, cdr: 40980.545, log: 66238.604, logcdr: 242875.013 },
    1: { standard: 130.028, cdr: 129592.205, log: 662386.037, logcdr: 3643125.454 },
};

/** How much further at a separation of one unit, in percent: of what, over what, where it says so. */
export const percentages = [
    { of: "cdr", over: "standard", percent: 99565, where: "chapter 4" },
    { of: "log", over: "standard", percent: 509321, where: "chapter 4" },
    { of: "logcdr", over: "standard", percent: 2801722, where: "chapter 4" },
    { of: "cdr", over: "standard", percent: 98000, where: "conclusion" },
    { of: "logcdr", over: "log", percent: 450, where: "conclusion" },
    { of: "logcdr", over: "standard", percent: 2975000, where: "conclusion" },
];

/** Table 6.1: the videos, left and right, with Tables 6.3 to 6.8: how many of twelve chose each. */
export const pairs = [
    { left: "standard", right: "cdr", chosen: [2, 10], table: "6.3", chiSquared: 5.333 },
    { left: "cdr", right: "log", chosen: [0, 12], table: "6.4", chiSquared: 12 },
    { left: "standard", right: "logcdr", chosen: [0, 12], table: "6.8", chiSquared: 12 },
    { left: "standard", right: "log", chosen: [0, 12], table: "6.6", chiSquared: 12 },
    { left: "cdr", right: "logcdr", chosen: [0, 12], table: "6.7", chiSquared: 12 },
    { left: "log", right: "logcdr", chosen: [1, 11], table: "6.5", chiSquared: 8.333 },
];

/** Table 6.2: how often each was chosen, of 36. */
export const table62 = { standard: 2, cdr: 10, log: 25, logcdr: 35 };
