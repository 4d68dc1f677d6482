package arcomat.symbols.names;

import arcomat.source.Span;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Unit;

/** A type that a class diagram defines. */
public abstract sealed class DefinedType implements TypeSymbol
        permits EnumSymbol, ClassSymbol, OpaqueSymbol {
    private final Unit unit;
    private final String qualifiedName;

    DefinedType(Unit unit, String qualifiedName) {
        this.unit = unit;
        this.qualifiedName = qualifiedName;
    }

    public final Unit unit() {
        return unit;
    }

    public abstract ClassDiagram.TypeDefinition node();

    /** {@code package.Diagram.Type}. */
    public final String qualifiedName() {
        return qualifiedName;
    }

    /** {@code package.Type}, as for a class of Java. */
    final String shortName() {
        return Names.join(unit.packageText(), text());
    }

    @Override
    public final String text() {
        return node().name().text();
    }

    /** Where its name is declared. */
    public final Span nameSpan() {
        return node().name().span();
    }

    @Override
    public final String toString() {
        return text();
    }
}
