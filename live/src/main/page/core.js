// What the core asks of its browser. It is a module of WebAssembly, and wants all of this under the names that its compiler,
// TeaVM, gives. TeaVM brings functions of its own for that, but makes some of them out of texts, which the page's policy forbids.

const TOO_OLD = 'this browser is too old for the page: it needs one as of 2025, which runs WebAssembly with a garbage collector';

/** What the core counts its memory in, and the most of them that it asks for. */
const MOST_PAGES = 32768, PAGE_BYTES = 65536;

/** Where what scripts see of a thing of the core keeps that thing. */
const THING = Symbol('thing');

/** An exception of Java's: the core has ended the question as it should. */
class Thrown extends Error {}

/** @param packed the core as it lies in the page */
async function compile(packed) {
    try {
        return await WebAssembly.compile(unpack(Uint8Array.fromBase64(packed)), { builtins: ['js-string'] });
    } catch {
        throw new Error(TOO_OLD);
    }
}

/** A core of which nothing has been asked yet. */
async function begin(module) {
    const core = {};
    const { exports } = await WebAssembly.instantiate(module, {
        ...textFunctions(),
        ...memoryOf(module),
        teavm: javaFunctions(core),
        teavmConsole: { putcharStdout() {}, putcharStderr() {} },
        teavmDate: { currentTimeMillis: Date.now },
        teavmJso: scriptFunctions(core, module),
        teavmMath: Math,
        numbers: { scientific: (value) => value.toExponential(), nearest: Number },
    });
    core.exports = exports;
    return exports.Core.value();
}

/** For browsers whose WebAssembly does not know texts by itself; others do not look here. Arrays are taken letter by letter then. */
function textFunctions() {
    return {
        'wasm:js-string': {
            fromCharCode: String.fromCharCode,
            fromCharCodeArray() {},
            intoCharCodeArray() {},
            concat: (left, right) => left + right,
            charCodeAt: (text, index) => text.charCodeAt(index),
            length: (text) => text.length,
            substring: (text, start, end) => text.substring(start, end),
        },
    };
}

/** The memory that is not collected: what the core has read with it, and room behind that. */
function memoryOf(module) {
    const [needs] = WebAssembly.Module.customSections(module, 'teavm.memoryRequirements');
    const { min, dataSize } = JSON.parse(new TextDecoder().decode(needs));
    const memory = new WebAssembly.Memory({ initial: min, maximum: MOST_PAGES });
    const constant = (number) => new WebAssembly.Global({ value: 'i32', mutable: false }, number);
    return {
        env: { memory },
        teavmMemory: {
            linearMemory: () => memory.buffer,
            notifyHeapResized() {},
            heapOffset: constant(8 * Math.ceil(dataSize / 8)),
            maxSize: constant(MOST_PAGES * PAGE_BYTES - 1),
        },
    };
}

/** What Java has and WebAssembly has not: weak references. Where an exception was made, nobody asks. */
function javaFunctions(core) {
    const things = new FinalizationRegistry(({ queue, ref }) => core.exports['teavm.reportGarbageCollectedValue'](queue, ref));
    const texts = new FinalizationRegistry((entry) => core.exports['teavm.reportGarbageCollectedString'](entry));
    const target = (reference) => reference.deref() ?? null;
    return {
        createWeakRef(thing, ref, queue) {
            if (queue !== null) {
                things.register(thing, { ref, queue });
            }
            return new WeakRef(thing);
        },
        createStringWeakRef(text, entry) {
            texts.register(text, entry);
            return new WeakRef(text);
        },
        deref: target,
        stringDeref: target,
        takeStackTrace: () => ({ getStack: () => [] }),
        decorateException() {},
    };
}

/** How the core and scripts see each other's things. */
function scriptFunctions(core, module) {
    const same = (value) => value;
    return {
        stringBuiltinsSupported: () => !WebAssembly.Module.imports(module).some((each) => each.module === 'wasm:js-string'),
        createClass: (name, parent, make) => Object.assign(class {
            constructor(thing) {
                this[THING] = thing;
            }
        }, { make }),
        exportClass: ({ make }) => make,
        defineMethod(type, name, method) {
            type.prototype[name] = function (...args) {
                return answer(core, () => method(this, ...args));
            };
        },
        javaObjectToJS: (thing, type) => new type(thing),
        unwrapJavaObject: (seen) => seen[THING],
        wrapObject: (seen) => (seen === null ? null : seen[THING] ?? core.exports['teavm.jso.createWrapper'](seen)),
        global: (name) => globalThis[name],
        getProperty: (object, name) => (object ?? globalThis)[name],
        callMethod0: (object, name) => object[name](),
        callMethod1: (object, name, arg) => object[name](arg),
        createFunction1(parameter, body) {
            if (body !== `return ${parameter};`) {
                throw new Error('the core brings a script with it: ' + body);
            }
            return same;
        },
        callFunction1: (script, arg) => script(arg),
        construct3: (type, ...args) => new type(...args),
        instanceOf: (object, type) => object instanceof type,
        isUndefined: (value) => value === undefined,
        wrapInt: same,
        wrapDouble: same,
        unwrapInt: same,
        unwrapDouble: same,
    };
}

/** What a method gives; exceptions of Java's become those of scripts. */
function answer(core, method) {
    try {
        return method();
    } catch (problem) {
        const tag = core.exports['teavm.javaException'];
        if (problem instanceof WebAssembly.Exception && problem.is(tag)) {
            const message = core.exports['teavm.exceptionMessage'](problem.getArg(tag, 0));
            throw new Thrown(message === null ? 'an error without a message' : core.exports['teavm.stringToJs'](message));
        }
        throw problem;
    }
}
