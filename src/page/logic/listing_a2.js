// The thesis' own formulas (Listing A.2, after Baker and Ulrich): the smallest separation that a depth buffer of so many
// bits tells apart. They know the buffer alone, not the float32 numbers that reach it.

const kRatio = 1000; // far over near of the thesis' cascades

const formulas = {
    standard: standardSeparation,
    cdr: (distance, range, bits) => standardSeparation(distance, cascadeAt(distance, range), bits),
    log: logSeparation,
    logcdr: (distance, range, bits) => logSeparation(distance, cascadeAt(distance, range), bits),
};

/**
 * The separation in scene units at a view distance; null for a technique that the thesis does not have.
 * @param {{near: number, far: number}} range the camera's, near <= distance <= far.
 */
export function listingSeparation(technique, distance, range, bits = 24) {
    return formulas[technique]?.(distance, range, bits) ?? null;
}

function standardSeparation(distance, { near, far }, bits) {
    const b = (far * near) / (near - far);
    return Math.abs(b / (b / distance - 1 / 2 ** bits) - distance);
}

function logSeparation(distance, { near, far }, bits) {
    return distance * Math.expm1(Math.log(far / near) / (2 ** bits - 1));
}

function cascadeAt(distance, { near, far }) {
    let cascade = { near, far: Math.min(near * kRatio, far) };
    while (distance > cascade.far) {
        cascade = { near: cascade.far, far: Math.min(cascade.far * kRatio, far) };
    }
    return cascade;
}
