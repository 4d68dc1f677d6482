package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;

import java.util.List;
import java.util.Optional;

/**
 * A port of a component, or an input or output of a bare automaton.
 *
 * @param typeNode its type as written
 * @param implicit whether it is named after its type
 * @param stereotypes its own and those of the declaration it stands in, own ones first
 * @param defaultDelay what the timing of the component says about outputs
 */
public record PortSymbol(
        String name,
        Span nameSpan,
        boolean implicit,
        Element.Direction direction,
        TypeReference typeNode,
        Resolution<TypeSymbol> typeResolution,
        List<Stereotype> stereotypes,
        int defaultDelay)
        implements ValueSymbol {
    public PortSymbol {
        stereotypes = List.copyOf(stereotypes);
    }

    @Override
    public TypeSymbol type() {
        return typeResolution.found().orElse(UnknownType.UNKNOWN);
    }

    public boolean isInput() {
        return direction == Element.Direction.IN;
    }

    public boolean isOutput() {
        return direction == Element.Direction.OUT;
    }

    /** Whether it carries a message in every slice. */
    public boolean isTotal() {
        return Stereotype.find(stereotypes, "total").isPresent();
    }

    /** Event-driven: whether it holds a value that guards may read and that triggers nothing. */
    public boolean isLatched() {
        return Stereotype.find(stereotypes, "state").isPresent();
    }

    /** What it holds before its first message, as it is written there. */
    public Optional<Name> first() {
        return Stereotype.find(stereotypes, "state").flatMap(Stereotype::value);
    }

    /** The value of its stereotype {@code delay}, whatever is written there. */
    public Optional<Stereotype> delayStereotype() {
        return Stereotype.find(stereotypes, "delay");
    }

    /**
     * Slices between reaction and message, 0 or 1; 0 for inputs. What a composite declares here is
     * what automata on it ask for; when its parts send is the effective delay in {@code Delays}.
     */
    public int delay() {
        if (isInput()) {
            return 0;
        }
        String written = delayStereotype().flatMap(Stereotype::value).map(Name::text).orElse("");
        return switch (written) {
            case "0" -> 0;
            case "1" -> 1;
            default -> defaultDelay;
        };
    }

    /** The same port seen through type arguments. */
    public PortSymbol with(TypeSubstitution substitution) {
        return changed(name, typeResolution.map(substitution::apply), defaultDelay);
    }

    /** The same port as the whole sees it, {@code part.port}. */
    public PortSymbol ofPart(String part) {
        return changed(part + "." + name, typeResolution, defaultDelay);
    }

    /** The same port in a component that inherits it. */
    public PortSymbol inherited(TypeSubstitution substitution, int delayOfHeir) {
        return changed(name, typeResolution.map(substitution::apply), delayOfHeir);
    }

    private PortSymbol changed(String newName, Resolution<TypeSymbol> type, int delay) {
        return new PortSymbol(
                newName, nameSpan, implicit, direction, typeNode, type, stereotypes, delay);
    }

    @Override
    public TypedExpression read(Expression.Reference node) {
        return new TypedExpression.PortRead(node, this);
    }

    /** Ports are the same when the same text declares them, whatever their types are seen as. */
    @Override
    public boolean equals(Object other) {
        return other instanceof PortSymbol port
                && port.nameSpan.equals(nameSpan)
                && port.name.equals(name);
    }

    @Override
    public int hashCode() {
        return name.hashCode() * 31 + nameSpan.start();
    }

    @Override
    public String toString() {
        return name;
    }
}
