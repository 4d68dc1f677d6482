package arcomat.editor.answer.completion;

import arcomat.source.ArrayNames;
import arcomat.source.Fix.TextEdit;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A name that fits.
 *
 * @param label the name
 * @param kind for the picture that is put before it
 * @param detail what it is, in a few words
 * @param needed edits elsewhere that it needs: an import
 */
public record Proposal(String label, Kind kind, String detail, List<TextEdit> needed) {
    /** What a name stands for. */
    public enum Kind {
        COMPONENT,
        PART,
        PORT,
        VARIABLE,
        STATE,
        FEATURE,
        TYPE,
        BUILTIN_TYPE,
        CONSTANT,
        TRUTH
    }

    static Proposal of(String label, Kind kind, String detail) {
        return new Proposal(label, kind, detail, List.of());
    }

    static Proposal of(PortSymbol port) {
        String direction = port.isInput() ? "in " : "out ";
        return of(port.name(), Kind.PORT, direction + port.type().text());
    }

    static Proposal of(ValueSymbol value) {
        return value instanceof PortSymbol port
                ? of(port)
                : of(value.name(), Kind.VARIABLE, value.type().text());
    }

    /**
     * Whole arrays, each with the number of its elements.
     *
     * @param all what fits: of an array all elements have to
     * @param names those of all that is declared
     */
    static <T> List<Proposal> arrays(
            Stream<T> all,
            Collection<String> names,
            Function<T, String> name,
            Function<T, Proposal> proposal) {
        Map<String, List<T>> arrays =
                all.filter(each -> ArrayNames.isElement(name.apply(each)))
                        .collect(
                                Collectors.groupingBy(
                                        each -> ArrayNames.array(name.apply(each)),
                                        LinkedHashMap::new,
                                        Collectors.toList()));
        return arrays.entrySet().stream()
                .filter(each -> ArrayNames.size(each.getKey(), names) == each.getValue().size())
                .map(each -> whole(each.getKey(), each.getValue(), proposal))
                .toList();
    }

    private static <T> Proposal whole(
            String array, List<T> elements, Function<T, Proposal> proposal) {
        Proposal one = proposal.apply(elements.get(0));
        return of(array, one.kind(), "%s [%d]".formatted(one.detail(), elements.size()));
    }

    static Proposal of(InstanceSymbol part) {
        String component = part.component().map(each -> each.qualifiedName()).orElse("");
        return of(part.name(), Kind.PART, component);
    }
}
