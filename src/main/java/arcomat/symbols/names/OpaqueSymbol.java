package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Unit;

/**
 * A type of a class diagram of which nothing is known: {@code type Name;}, or an interface. Its
 * messages are passed on and compared, and nobody looks into them. They are told apart by a text.
 */
public final class OpaqueSymbol extends DefinedType {
    /** What tells messages apart in stream tests, {@code Order("first")}, and in what runs. */
    public static final String NAME = "name";

    private final ClassDiagram.NamedType node;

    public OpaqueSymbol(Unit unit, ClassDiagram.NamedType node, String qualifiedName) {
        super(unit, qualifiedName);
        this.node = node;
    }

    @Override
    public ClassDiagram.NamedType node() {
        return node;
    }

    @Override
    public boolean isObject() {
        return true;
    }
}
