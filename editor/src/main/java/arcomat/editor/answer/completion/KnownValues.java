package arcomat.editor.answer.completion;

import arcomat.editor.answer.completion.Proposal.Kind;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.TypeSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The values that an automaton, a table or a test can read or write.
 *
 * @param place what is around the place
 */
record KnownValues(WritingPlace place) {
    private static final Set<String> GIVERS = Set.of("forall", "exists", "let");
    private static final Set<String> COMPARISONS = Set.of("==", "!=", "=", "<", "<=", ">", ">=");

    /**
     * What an item of a block can be about.
     *
     * @param writes whether outputs are written there, or inputs read
     */
    List<Proposal> targets(boolean writes) {
        return all().filter(
                        value -> !(value instanceof PortSymbol port) || port.isOutput() == writes)
                .map(value -> Proposal.of(value))
                .toList();
    }

    /** Behind a comparison the constants of its type come first, and only values of that type. */
    List<Proposal> values() {
        Optional<TypeSymbol> type = comparedType();
        List<Proposal> proposals = new ArrayList<>(bound());
        type.ifPresent(compared -> constants(compared).forEach(proposals::add));
        all().filter(value -> !(value instanceof PortSymbol port) || port.isInput())
                .filter(value -> type.isEmpty() || value.type().base().equals(type.get().base()))
                .map(value -> Proposal.of(value))
                .forEach(proposals::add);
        return proposals;
    }

    /** Names that the expression has given so far. */
    private List<Proposal> bound() {
        List<String> words = place.caret().statement();
        return IntStream.range(1, words.size() - 1)
                .filter(each -> GIVERS.contains(words.get(each - 1)))
                .filter(each -> Set.of("in", "=").contains(words.get(each + 1)))
                .mapToObj(words::get)
                .map(name -> Proposal.of(name, Kind.TRUTH, "value"))
                .toList();
    }

    /** What a quantifier may be about, beside types. */
    List<Proposal> arrays() {
        List<ValueSymbol> values =
                all().filter(value -> !(value instanceof PortSymbol port) || port.isInput())
                        .toList();
        return Proposal.arrays(
                values.stream(),
                values.stream().map(ValueSymbol::name).toList(),
                ValueSymbol::name,
                value -> Proposal.of(value));
    }

    /** Messages of a stream: constants of the port's type. */
    List<Proposal> messages() {
        List<String> words = place.caret().statement();
        int colon = words.indexOf(":");
        return place.testSuite().stream()
                .map(TestSuiteSymbol::component)
                .flatMap(component -> component.found().stream())
                .flatMap(component -> port(component, colon < 1 ? "" : words.get(colon - 1)))
                .flatMap(port -> constants(port.type()))
                .toList();
    }

    private static Stream<PortSymbol> port(ComponentSymbol component, String name) {
        return component.port(name).stream();
    }

    private Optional<TypeSymbol> comparedType() {
        if (!COMPARISONS.contains(place.word(1))) {
            return Optional.empty();
        }
        String compared = place.name(2);
        return all().filter(value -> value.name().equals(compared))
                .map(ValueSymbol::type)
                .findFirst();
    }

    private static Stream<Proposal> constants(TypeSymbol type) {
        if (type instanceof EnumSymbol symbol) {
            return symbol.constants().stream()
                    .map(name -> Proposal.of(name, Kind.CONSTANT, symbol.text()));
        }
        return type.isBoolean()
                ? Stream.of("true", "false").map(name -> Proposal.of(name, Kind.TRUTH, type.text()))
                : Stream.empty();
    }

    private Stream<ValueSymbol> all() {
        Optional<AutomatonSymbol> automaton = place.automaton();
        Optional<ComponentSymbol> component = place.component();
        Stream<ValueSymbol> inside =
                automaton.stream()
                        .flatMap(
                                each ->
                                        Stream.concat(
                                                each.ports().stream(), each.variables().stream()));
        Stream<ValueSymbol> around =
                component.stream()
                        .flatMap(
                                each ->
                                        Stream.concat(
                                                automaton.isEmpty()
                                                        ? each.ports().stream()
                                                        : Stream.empty(),
                                                Stream.concat(
                                                        each.parameters().stream(),
                                                        each.signature().variables().stream())));
        return Stream.concat(inside, around);
    }
}
