package arcomat.editor.answer.completion;

import arcomat.editor.answer.completion.Proposal.Kind;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The names that fit where the grammar lets a name stand.
 *
 * @param place what is around the place
 */
record KnownNames(WritingPlace place) {

    /**
     * @param all rules of the grammar around the name, innermost first
     */
    List<Proposal> at(List<String> all) {
        List<String> rules = withoutPlaces(all);
        String inner = rules.isEmpty() ? "" : rules.get(0);
        String outer = rules.size() < 2 ? "" : rules.get(1);
        KnownFeatures features = new KnownFeatures(place);
        if (features.areMeant(rules)) {
            return features.proposals();
        }
        return switch (inner) {
            case "automatonElement" -> states();
            case "item" -> new KnownValues(place).targets(place.says("/"));
            case "statement" -> new KnownValues(place).targets(true);
            case "primary", "suffix" -> new KnownValues(place).values();
            case "tableInputs" -> ports(PortSymbol::isInput);
            case "tableOutputs" -> ports(PortSymbol::isOutput);
            case "qualifiedName" -> qualified(outer, rules);
            case "plainType", "plainName", "objectType", "instanceType" ->
                    new KnownDefinitions(place).types();
            default -> List.of();
        };
    }

    /** A place is a name with a number at most, a path of them one with dots. */
    private static List<String> withoutPlaces(List<String> rules) {
        return rules.stream()
                .filter(rule -> !rule.equals("place"))
                .map(rule -> rule.equals("qualifiedPlace") ? "qualifiedName" : rule)
                .toList();
    }

    private List<Proposal> qualified(String outer, List<String> rules) {
        return switch (outer) {
            case "connector", "simpleConnector" -> new KnownEnds(place).ends();
            case "type" -> type(rules.subList(2, rules.size()));
            case "component", "testSuite" -> new KnownDefinitions(place).components();
            case "portStream", "eventStream" -> streams();
            case "message" -> new KnownValues(place).messages();
            case "objectType" -> new KnownDefinitions(place).types();
            default -> List.of();
        };
    }

    /** The grammar writes types of parts, of ancestors and of messages alike. */
    private List<Proposal> type(List<String> around) {
        String outer = around.isEmpty() ? "" : around.get(0);
        KnownDefinitions definitions = new KnownDefinitions(place);
        if (outer.equals("domain")) {
            return Stream.concat(
                            new KnownValues(place).arrays().stream(), definitions.types().stream())
                    .toList();
        }
        return outer.equals("subcomponent") || outer.equals("component")
                ? definitions.components()
                : definitions.types();
    }

    private List<Proposal> states() {
        return place.automaton().stream()
                .flatMap(automaton -> automaton.states().stream())
                .map(StateSymbol::name)
                .distinct()
                .map(name -> Proposal.of(name, Kind.STATE, "state"))
                .toList();
    }

    private List<Proposal> ports(Predicate<PortSymbol> wanted) {
        return place.component().stream()
                .flatMap(component -> component.ports().stream())
                .filter(wanted)
                .map(port -> Proposal.of(port))
                .toList();
    }

    /** What is driven gets messages on its inputs, what is expected comes from its outputs. */
    private List<Proposal> streams() {
        List<List<String>> around = place.caret().around();
        String part = around.isEmpty() ? "" : around.get(around.size() - 1).get(0);
        Stream<PortSymbol> ports =
                place.testSuite().stream()
                        .map(TestSuiteSymbol::component)
                        .flatMap(component -> component.found().stream())
                        .map(ComponentSymbol::ports)
                        .flatMap(List::stream);
        return ports.filter(port -> part.equals("events") || port.isInput() == part.equals("input"))
                .map(port -> Proposal.of(port))
                .toList();
    }
}
