/** Floats: numbers in other arrays are rounded to the nearest float. */
export type Floats = Float32Array | Float64Array | number[];
/** An image from `flashbvh bake --format image` or `flashbvh robot --format image`. The library copies it. */
export type Image = Uint8Array | ArrayBuffer;
