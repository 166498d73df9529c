// A WebAssembly module of the library, with shared code for memory, errors, and arrays in and out.

const bytes_at = async url => {
  if (url.protocol === "file:") return (await import("node:fs")).readFileSync(url);
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`flashbvh: ${url} can't be fetched: ${answer.status}`);
  return answer.arrayBuffer();
};

export const need = (object, Type, name) => {
  if (!(object instanceof Type)) throw new TypeError(`flashbvh: ${name} is no ${Type.name}`);
  return object;
};
export const need_whole = (number, least, name) => {
  if (!(Number.isInteger(number) && number >= least && number <= 0xffffffff)) {
    throw new RangeError(`flashbvh: ${name} ${number} is no whole number from ${least} to ${0xffffffff}`);
  }
};

export class Module {
  static async open(name) {
    const { instance } = await WebAssembly.instantiate(await bytes_at(new URL(name, import.meta.url)));
    return new Module(instance.exports);
  }

  constructor(library) {
    this.library = library;
    this.end = library.__heap_base.value;
    // Freed blocks by exponent; block sizes are powers of two.
    this.freed = Array.from({ length: 64 }, () => []);
    this.exponents = new Map();
    this.dropped = new FinalizationRegistry(places => places.forEach(place => this.give(place)));
  }

  view(Type, place, length) {
    return new Type(this.library.memory.buffer, place, length);
  }
  text(place) {
    const bytes = this.view(Uint8Array, place);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  take(bytes) {
    const exponent = Math.max(3, Math.ceil(Math.log2(bytes)));
    let place = this.freed[exponent].pop();
    if (place === undefined) {
      place = Math.ceil(this.end / 8) * 8;
      const pages = Math.ceil((place + 2 ** exponent - this.library.memory.buffer.byteLength) / 65536);
      if (pages > 0) this.library.memory.grow(pages);
      this.end = place + 2 ** exponent;
    }
    this.exponents.set(place, exponent);
    return place;
  }
  give(place) {
    this.freed[this.exponents.get(place)].push(place);
  }
  // Frees an object's memory some time after the object is dropped.
  keep(object, ...places) {
    this.dropped.register(object, places);
    return places;
  }

  status_name(status) {
    return this.text(this.library.flashbvh_status_name(status));
  }
  need_done(status, where = "") {
    if (status === 0) return;
    const name = this.status_name(status);
    throw Object.assign(new Error(`flashbvh: ${name}${where}`), { status: name });
  }

  copy_in(Type, numbers) {
    const place = this.take(Math.max(1, numbers.length * Type.BYTES_PER_ELEMENT));
    this.view(Type, place, numbers.length).set(numbers);
    return place;
  }
  image_in(bytes) {
    if (bytes instanceof ArrayBuffer) bytes = new Uint8Array(bytes);
    return [this.copy_in(Uint8Array, need(bytes, Uint8Array, "an image")), bytes.length];
  }

  // Arrays [Type, width] of `count` rows each, filled by call(...places), which may return the number of answered rows.
  filled(count, name, arrays, call) {
    const places = arrays.map(([Type, width]) => this.take(Math.max(1, count * width * Type.BYTES_PER_ELEMENT)));
    try {
      arrays.forEach(([Type, width], i) => this.view(Type, places[i], count * width).fill(0));
      const answered = call(...places);
      if (answered < count) this.need_done(this.library.last_status(), `: ${name} ${answered}`);
      return arrays.map(([Type, width], i) => this.view(Type, places[i], count * width).slice());
    } finally {
      places.forEach(place => this.give(place));
    }
  }
  // filled() for input rows of `width` numbers: call(count, place, ...places). Rounds floats of other types.
  answered(Type, numbers, width, name, arrays, call) {
    if (Type === Float32Array && (Array.isArray(numbers) || numbers instanceof Float64Array)) {
      numbers = Float32Array.from(numbers);
    }
    need(numbers, Type, `${name}s`);
    if (numbers.length % width !== 0) {
      throw new RangeError(`flashbvh: ${name}s has ${numbers.length} numbers, no multiple of ${width}`);
    }
    const count = numbers.length / width;
    const place = this.copy_in(Type, numbers);
    try {
      return this.filled(count, name, arrays, (...places) => call(count, place, ...places));
    } finally {
      this.give(place);
    }
  }
}
