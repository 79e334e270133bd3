// Randomness that a seed repeats: SplitMix32, which passes from any seed, short ones included.

/** A function giving uniform numbers in [0, 1), the same for the same seed text. */
export function randomFrom(seed) {
    let state = hashOf(String(seed));
    return () => {
        state = (state + 0x9e3779b9) | 0;
        let mixed = state ^ (state >>> 16);
        mixed = Math.imul(mixed, 0x21f0aaad);
        mixed ^= mixed >>> 15;
        mixed = Math.imul(mixed, 0x735a2d97);
        return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
    };
}

/** A shuffled copy (Fisher and Yates). */
export function shuffled(items, random) {
    const list = [...items];
    for (let last = list.length - 1; last > 0; --last) {
        const other = Math.floor(random() * (last + 1));
        [list[last], list[other]] = [list[other], list[last]];
    }
    return list;
}

/** FNV-1a, 32 bits. */
function hashOf(text) {
    let hash = 0x811c9dc5;
    for (const byte of new TextEncoder().encode(text)) {
        hash = Math.imul(hash ^ byte, 0x01000193);
    }
    return hash | 0;
}
