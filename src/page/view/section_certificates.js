import { certifiedRow } from "../logic/certificates.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, share } from "./figures.js";

/** @param {{document: object, folder: string}[]} results a scene and a technique each, with the certificate's file. */
export function fillCertificates(results) {
    if (results.length > 0) {
        slot("certificates", "table").append(makeTable(results));
    }
}

function makeTable(results) {
    return table("Over all frames, edges included. Wrong after: counted apart, by a float64 ray through every pixel of the repaired frame. Refused: what no device within its limits draws. Times are medians of a frame; the certificate\u2019s comes on top.",
        ["Technique", "scene", "certified", "of these proven", "cast", "repaired", "wrong before", "wrong after", "refused", "frame, ms", "certificate, ms", "file"],
        results.map(({ document, folder }) => {
            const row = certifiedRow(document);
            return [
                techniqueLabel(row.technique), row.scene, share(row.certified),
                share(row.proven), share(row.cast), share(row.repaired), figure(row.wrongBefore), figure(row.wrongAfter),
                figure(row.refused), figure(row.frameMs), figure(row.certifyMs), h("a", { href: folder, "aria-label": `Certificate of ${row.scene}, ${row.technique}` }, "certificate")];
        }));
}
