package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.tree.AutomatonElement;

/** A state; {@code index} counts the declarations from 0. */
public record StateSymbol(AutomatonElement.State node, int index) {
    public String name() {
        return node.name().text();
    }

    public Span nameSpan() {
        return node.name().span();
    }
}
