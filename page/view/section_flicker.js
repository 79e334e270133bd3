export function fillFlicker() {}
