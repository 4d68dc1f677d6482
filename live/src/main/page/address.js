// The state of the page is its address: packed into the fragment, which no browser sends anywhere.

const DELAY = 400;

async function through(bytes, stream) {
    const piped = new Blob([bytes]).stream().pipeThrough(stream);
    return new Uint8Array(await new Response(piped).arrayBuffer());
}

/** What the address says; null where it says nothing. */
export async function readAddress() {
    const packed = location.hash.slice(1);
    if (!packed) {
        return null;
    }
    try {
        const text = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
        const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
        const plain = await through(bytes, new DecompressionStream('deflate-raw'));
        return JSON.parse(new TextDecoder().decode(plain));
    } catch (broken) {
        return null; // cut off on its way here
    }
}

async function pack(state) {
    const bytes = await through(
        new TextEncoder().encode(JSON.stringify(state)), new CompressionStream('deflate-raw'));
    let text = '';
    bytes.forEach((byte) => (text += String.fromCharCode(byte)));
    return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** Keeps the address as the state is, a little later. */
export function addressWriter(stateOf) {
    let timer = 0;
    return () => {
        clearTimeout(timer);
        timer = setTimeout(async () => {
            const packed = await pack(stateOf());
            history.replaceState(null, '', '#' + packed);
        }, DELAY);
    };
}
