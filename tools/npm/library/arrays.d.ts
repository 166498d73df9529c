/** Floats: an array of another type is rounded to the nearest ones. */
export type Floats = Float32Array | Float64Array | number[];
/** What `flashbvh bake --format image` and `flashbvh robot --format image` write. It is copied. */
export type Image = Uint8Array | ArrayBuffer;
