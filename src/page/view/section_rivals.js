import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, interval, length, separation, share } from "./figures.js";

const label = (row) => techniqueLabel(row.technique);

export function fillRivals(document) {
    slot("rivals", "table").append(makeScenes(document), makeResolved(document), makeNeeds(document));
}

function makeScenes(document) {
    return table("Against the float64 truth, and the time of ids and distances over that of Anchored: medians, frame by frame.",
        ["Technique", "scene", "wrong", "flips per thousand", "frame, ms", "over Anchored", "95 % interval"],
        document.results.map((row) => [
            label(row), row.scene, share(row.wrong_fraction), figure(row.flips_per_thousand), figure(row.frame_ms),
            figure(row.frame_ratio), interval(row.ci95)]));
}

function makeResolved(document) {
    return table("Smallest resolved separation: of pairs of equal cubes, which float32 rounds alike, and of unlike pairs.",
        ["Technique", "distance", "equal pairs", "unlike pairs", "of those, over Anchored"],
        document.resolved.map((row) => [
            label(row), length(row.distance), separation(row, row.resolved, row.pairs_seen, row.resolves_all),
            separation(row, row.resolved_unlike, row.pairs_seen_unlike, row.resolves_all_unlike),
            row.resolved_ratio === null ? "" : figure(row.resolved_ratio)]));
}

function makeNeeds(document) {
    return table("What each needs.",
        ["Technique", "geometry passes", "bytes a pixel", "features of Vulkan beyond those of cdr"],
        document.needs.map((row) => [
            label(row), figure(row.geometry_passes), figure(row.bytes_per_pixel), row.features.join(", ") || "none"]));
}
