package arcomat.symbols.names;

import arcomat.source.Span;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Unit;

/** A type that a class diagram defines. */
public sealed interface DefinedType extends TypeSymbol permits EnumSymbol, ClassSymbol {
    Unit unit();

    ClassDiagram.TypeDefinition node();

    /** {@code package.Diagram.Type}. */
    String qualifiedName();

    @Override
    default String text() {
        return node().name().text();
    }

    /** Where its name is declared. */
    default Span nameSpan() {
        return node().name().span();
    }
}
