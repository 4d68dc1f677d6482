package arcomat.check.facts;

import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Node;

import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Pieces of sentences that several messages share. */
public final class Wording {
    private static final int LONGEST = 40;
    private static final Set<BuiltinType> SMALL =
            EnumSet.of(BuiltinType.BYTE, BuiltinType.SHORT, BuiltinType.CHARACTER);

    private Wording() {}

    /** {@code 1 cell}, {@code 2 cells}. */
    public static String count(int number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }

    /** {@code 'a', 'b', 'c'}. */
    public static String quoted(Collection<String> names) {
        return names.stream().map(name -> "'" + name + "'").collect(Collectors.joining(", "));
    }

    /** {@code a, b, and 3 more}: the first ones, and how many are left. */
    public static String firstOf(List<String> names, int most) {
        String shown = String.join(", ", names.subList(0, Math.min(most, names.size())));
        int more = names.size() - most;
        return more <= 0 ? shown : shown + ", and " + more + " more";
    }

    /** {@code out Boolean drive}. */
    public static String declaration(PortSymbol port) {
        return (port.isInput() ? "in " : "out ") + port.type().text() + " " + port.name();
    }

    /** The name of a type; with its package where another type of the message has the same. */
    public static String distinct(TypeSymbol type, TypeSymbol other) {
        boolean same = type.text().equals(other.text());
        if (same && type instanceof JavaType java) {
            return java.qualifiedName();
        }
        return same && type instanceof DefinedType defined ? defined.qualifiedName() : type.text();
    }

    /** {@code Integer, but '"slow"' is of type String}. */
    public static String mismatch(TypeSymbol wanted, Typed typed) {
        return "%s, but '%s' is of type %s%s"
                .formatted(
                        distinct(wanted, typed.type()),
                        shortened(typed.expression().node()),
                        distinct(typed.type(), wanted),
                        narrowing(wanted, typed));
    }

    /** What to do where a number may be too large for Java's small types. */
    private static String narrowing(TypeSymbol wanted, Typed typed) {
        if (!(wanted.base() instanceof BuiltinType small)
                || !SMALL.contains(small)
                || !typed.type().isIntegral()) {
            return "";
        }
        return ConstantFolding.computed(typed.expression())
                .filter(number -> number < small.low() || small.high() < number)
                .map(
                        number ->
                                "; %s holds numbers from %d to %d"
                                        .formatted(small, small.low(), small.high()))
                .orElse("; a value is cut off only where you write (%s)".formatted(small));
    }

    /** The text of a node, cut where it would burst the sentence. */
    public static String shortened(Node node) {
        String text = node.span().text().strip().replaceAll("\\s+", " ");
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 2) + "..";
    }
}
