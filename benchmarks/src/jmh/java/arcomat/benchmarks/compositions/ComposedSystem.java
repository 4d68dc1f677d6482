package arcomat.benchmarks.compositions;

import java.util.List;

/**
 * Parts that are connected, with a question: is what is forbidden never seen?
 *
 * @param externals how many ports of the whole there are, with 0 or 1 on each in every slice
 * @param forbidden each a list of what must not be seen in one slice
 */
record ComposedSystem(
        String name,
        int size,
        List<PartKind> kinds,
        List<Part> parts,
        int externals,
        List<List<Sight>> forbidden) {

    /**
     * @param kind position in the list of kinds
     * @param sources one per input port: the part that sends; a port of the whole is -1, -2 ..
     */
    record Part(int kind, List<Integer> sources) {}

    /** A part is seen to send a value. */
    record Sight(int part, int value) {}

    PartKind kind(Part part) {
        return kinds.get(part.kind());
    }

    String label() {
        return name + " " + size;
    }
}
