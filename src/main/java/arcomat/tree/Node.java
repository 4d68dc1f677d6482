package arcomat.tree;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** A piece of a tree with the text it came from. */
public interface Node {
    Span span();

    /** Those of one kind, in their order. */
    static <E> List<E> ofKind(Class<E> kind, List<? extends Node> nodes) {
        List<E> found = new ArrayList<>();
        for (Node each : nodes) { // no stream: this is asked again and again
            if (kind.isInstance(each)) {
                found.add(kind.cast(each));
            }
        }
        return Collections.unmodifiableList(found);
    }
}
