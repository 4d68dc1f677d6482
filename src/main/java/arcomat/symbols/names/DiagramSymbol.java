package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Unit;

import java.util.List;

/** A class diagram with its types in text order. */
public record DiagramSymbol(
        Unit unit, ClassDiagram node, String qualifiedName, List<DefinedType> types) {
    public DiagramSymbol {
        types = List.copyOf(types);
    }
}
