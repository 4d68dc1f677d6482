// Unpacks what is packed by LZMA, as Igor Pavlov's specification has it (LZMA SDK, lzma-specification.txt). The core is packed so
// since it is a third smaller than as browsers unpack by themselves.

/** Where models of bits begin in the one row of all of them. */
const MODELS = {
    isMatch: 0, isRepeated: 192, isNotLast: 204, isNotSecond: 216, isNotThird: 228, isLong: 240,
    slots: 432, distances: 688, aligned: 804, lengths: 820, repeatedLengths: 1334, literals: 1848,
};

/** Of models, and of the range at which bytes are taken in. */
const HALF = 1024, WHOLE = 2048, SMALL = 0x1000000;

/** How fast models learn. */
const SHIFT = 5;

/** Bits that were coded one by one, as models foresee them. */
class RangeDecoder {
    /**
     * @param bytes what is packed
     * @param at where it begins
     * @param models how many there are
     */
    constructor(bytes, at, models) {
        this.bytes = bytes;
        this.models = new Uint16Array(models).fill(HALF);
        this.range = 0xffffffff;
        this.code = new DataView(bytes.buffer, bytes.byteOffset).getUint32(at + 1);
        this.at = at + 5;
    }

    bit(index) {
        const model = this.models[index];
        const bound = (this.range >>> 11) * model;
        const bit = this.code < bound ? 0 : 1;
        if (bit === 0) {
            this.range = bound;
            this.models[index] = model + ((WHOLE - model) >> SHIFT);
        } else {
            this.range -= bound;
            this.code -= bound;
            this.models[index] = model - (model >> SHIFT);
        }
        this.fill();
        return bit;
    }

    /** A bit of which nothing is foreseen. */
    evenBit() {
        this.range >>>= 1;
        const bit = this.code >= this.range ? 1 : 0;
        this.code -= bit * this.range;
        this.fill();
        return bit;
    }

    fill() {
        if (this.range < SMALL) {
            this.range = (this.range << 8) >>> 0;
            this.code = ((this.code << 8) | this.bytes[this.at++]) >>> 0;
        }
    }

    /** A number whose highest bit comes first. */
    number(models, bits) {
        let node = 1;
        for (let i = 0; i < bits; i++) {
            node = 2 * node + this.bit(models + node);
        }
        return node - (1 << bits);
    }

    /** A number whose lowest bit comes first. */
    reversed(models, bits) {
        let node = 1, number = 0;
        for (let i = 0; i < bits; i++) {
            const bit = this.bit(models + node);
            node = 2 * node + bit;
            number += bit << i;
        }
        return number;
    }

    evenNumber(bits) {
        let number = 0;
        for (let i = 0; i < bits; i++) {
            number = 2 * number + this.evenBit();
        }
        return number;
    }

    /** How many bytes are like others; without the two that are never fewer. */
    length(models, place) {
        if (this.bit(models) === 0) {
            return this.number(models + 2 + 8 * place, 3);
        }
        return this.bit(models + 1) === 0 ? 8 + this.number(models + 130 + 8 * place, 3) : 16 + this.number(models + 258, 8);
    }

    /** How far back those others are, less one. */
    distance(length) {
        const slot = this.number(MODELS.slots + 64 * Math.min(length, 3), 6);
        if (slot < 4) {
            return slot;
        }
        const bits = (slot >> 1) - 1;
        const least = (2 + slot % 2) << bits;
        return slot < 14
            ? least + this.reversed(MODELS.distances + least - slot, bits)
            : least + 16 * this.evenNumber(bits - 4) + this.reversed(MODELS.aligned, 4);
    }

    /** @param like the byte at the last distance; negative where that tells nothing */
    literal(models, like) {
        let node = 1;
        for (let expected = like; expected >= 0 && node < 256; expected = (2 * expected) % 256) {
            const foreseen = expected >> 7;
            const bit = this.bit(models + 256 * (1 + foreseen) + node);
            node = 2 * node + bit;
            if (bit !== foreseen) {
                break;
            }
        }
        while (node < 256) {
            node = 2 * node + this.bit(models + node);
        }
        return node;
    }
}

/** What is found where others begin that are like the next bytes. */
class Copies {
    constructor(decoder) {
        this.decoder = decoder;
        this.recent = new Uint32Array(4);
        this.state = 0;
    }

    /** Whether bytes like others come next, and no byte of its own. */
    come(step) {
        return this.decoder.bit(MODELS.isMatch + 16 * this.state + step) === 1;
    }

    /** How many bytes are like those at the distance that is the first one now. */
    length(step) {
        const { decoder, state } = this;
        const isEarly = state < 7;
        if (decoder.bit(MODELS.isRepeated + state) === 0) {
            const length = decoder.length(MODELS.lengths, step);
            this.first(3, decoder.distance(length));
            this.state = isEarly ? 7 : 10;
            return length + 2;
        }
        const which = this.which();
        if (which === 0 && decoder.bit(MODELS.isLong + 16 * state + step) === 0) {
            this.state = isEarly ? 9 : 11;
            return 1;
        }
        this.first(which, this.recent[which]);
        this.state = isEarly ? 8 : 11;
        return decoder.length(MODELS.repeatedLengths, step) + 2;
    }

    /** Which of the last distances comes again. */
    which() {
        if (this.decoder.bit(MODELS.isNotLast + this.state) === 0) {
            return 0;
        }
        return this.decoder.bit(MODELS.isNotSecond + this.state) === 0 ? 1 : 2 + this.decoder.bit(MODELS.isNotThird + this.state);
    }

    /** Puts a distance before the others, in place of one of them. */
    first(which, distance) {
        this.recent.copyWithin(1, 0, which);
        this.recent[0] = distance;
    }

    /** There was a byte of its own. */
    none() {
        const { state } = this;
        this.state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
    }
}

/** @param bytes a file of the format .lzma that tells its size */
function unpack(bytes) {
    const header = new DataView(bytes.buffer, bytes.byteOffset);
    const kind = header.getUint8(0);
    const before = kind % 9, places = 2 ** (Math.floor(kind / 9) % 5), steps = 2 ** Math.floor(kind / 45);
    const result = new Uint8Array(header.getUint32(5, true));
    const decoder = new RangeDecoder(bytes, 13, MODELS.literals + 768 * places * 2 ** before);
    const copies = new Copies(decoder);
    for (let to = 0; to < result.length;) {
        if (copies.come(to % steps)) {
            const end = to + copies.length(to % steps);
            for (const back = copies.recent[0] + 1; to < end; to++) {
                result[to] = result[to - back];
            }
        } else {
            const context = (to % places) * 2 ** before + ((result[to - 1] || 0) >> (8 - before));
            const like = copies.state < 7 ? -1 : result[to - copies.recent[0] - 1];
            result[to] = decoder.literal(MODELS.literals + 768 * context, like);
            copies.none();
            to++;
        }
    }
    return result;
}
