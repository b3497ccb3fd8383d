/** Numbers that look random and are the same in every run (xorshift32). */
export class Random {
  #state = 0x9e3779b9;

  next() {
    let state = this.#state;
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    this.#state = state;
    return state >>> 8;
  }

  bytes(length) {
    return Uint8Array.from({ length }, () => this.next() & 0xff);
  }

  registers(length) {
    return Array.from({ length }, () => this.next() & 0xffff);
  }
}
