package arcomat.symbols.names;

import arcomat.tree.Component.TypeParameter;

/** A type parameter of a component, inside the component. */
public final class TypeVariable implements TypeSymbol {
    private final TypeParameter node;

    TypeVariable(TypeParameter node) {
        this.node = node;
    }

    public TypeParameter node() {
        return node;
    }

    @Override
    public String text() {
        return node.name().text();
    }

    @Override
    public String toString() {
        return text();
    }
}
