package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Lazy;
import arcomat.tree.Element;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * An invariant of a component. It may be of any language; it has a meaning where it is an
 * expression about what can be seen in a slice.
 */
public final class InvariantSymbol {
    private static final String LANGUAGE = "ocl";

    private final Element.Invariant node;
    private final ComponentSymbol declaring;
    private final ComponentSymbol component;
    private final int number;
    private final Lazy<Optional<Typed>> typed = new Lazy<>(this::makeTyped);

    /**
     * @param declaring where it is written
     * @param component that it is about: the same, or an heir of it
     * @param number among those of its name in the declaring component, from 1
     */
    InvariantSymbol(
            Element.Invariant node,
            ComponentSymbol declaring,
            ComponentSymbol component,
            int number) {
        this.node = node;
        this.declaring = declaring;
        this.component = component;
        this.number = number;
    }

    public Element.Invariant node() {
        return node;
    }

    public String name() {
        return node.name().text();
    }

    /** What tells it from others: its name, with a number from the second of that name on. */
    public String title() {
        return number == 1 ? name() : name() + "#" + number;
    }

    public Span nameSpan() {
        return node.name().span();
    }

    /** What it says; empty where it has no meaning here. */
    public Optional<Typed> condition() {
        return obstacle().isPresent() ? Optional.empty() : typed.get().filter(this::isTruth);
    }

    /** Its text with what the names in it stand for, also where it has no meaning here. */
    public Optional<Typed> typed() {
        return typed.get();
    }

    private boolean isTruth(Typed condition) {
        return condition.problems().isEmpty() && condition.type().isBoolean();
    }

    /**
     * Why it has no meaning, as the end of a sentence; empty also where that comes from what is
     * reported elsewhere.
     */
    public Optional<String> obstacle() {
        String kind = node.kind().map(Name::text).orElse(LANGUAGE);
        if (!kind.equals(LANGUAGE)) {
            return Optional.of("it is written in '" + kind + "'");
        }
        if (typed.get().isEmpty()) {
            return Optional.of("it is not an expression of models");
        }
        if (component.isPlatform()) {
            return Optional.of("a platform component has no behaviour in the model");
        }
        if (component.isEventDriven()) {
            return Optional.of("it is a law about slices, and the component handles events");
        }
        return mistake(typed.get().get());
    }

    private Optional<String> mistake(Typed condition) {
        for (String name : ambiguous()) {
            if (Pattern.compile("\\b" + Pattern.quote(name) + "\\b").matcher(node.text()).find()) {
                return Optional.of("several automata have a variable '" + name + "'");
            }
        }
        Optional<String> hidden = component.isDecomposed() ? changing(condition) : Optional.empty();
        if (hidden.isPresent()) {
            return hidden.map(name -> "'" + name + "' changes in an automaton that does not run");
        }
        if (!condition.problems().isEmpty()) {
            return hasUnknownParts()
                    ? Optional.empty()
                    : Optional.of(condition.problems().get(0).message());
        }
        boolean isNoTruth = !condition.type().isErroneous() && !condition.type().isBoolean();
        return isNoTruth
                ? Optional.of("it has type " + condition.type().text() + ", not Boolean")
                : Optional.empty();
    }

    /** A variable of the component in it that is no constant. */
    private Optional<String> changing(Typed condition) {
        Set<String> read =
                condition.variablesRead().stream()
                        .map(each -> each.variable().name())
                        .collect(Collectors.toSet());
        return component.fields().stream()
                .map(VariableSymbol::name)
                .filter(read::contains)
                .findFirst();
    }

    /** Then names may be those of what did not parse, or was reported elsewhere. */
    private boolean hasUnknownParts() {
        return component.instances().stream().anyMatch(each -> each.component().isEmpty())
                || component.lineage().stream()
                        .flatMap(each -> each.signature().superComponent().stream())
                        .anyMatch(each -> each.component().isEmpty());
    }

    private Optional<Typed> makeTyped() {
        return node.condition()
                .map(text -> ExpressionTyping.type(text, scope(), BuiltinType.BOOLEAN));
    }

    /** Of a decomposed component what its parts send can be seen, and no variables. */
    private ValueScope scope() {
        ValueScope constants =
                declaring
                        .signature()
                        .emptyScope()
                        .with(component.parameters())
                        .with(component.signature().variables());
        return component.isDecomposed()
                ? constants.with(sentByParts()).with(component.ports())
                : constants.with(variables()).with(component.ports());
    }

    private List<PortSymbol> sentByParts() {
        List<PortSymbol> ports = new ArrayList<>();
        for (InstanceSymbol instance : component.instances()) {
            instance.ports().stream()
                    .filter(PortSymbol::isOutput)
                    .map(port -> port.ofPart(instance.name()))
                    .forEach(ports::add);
        }
        return ports;
    }

    private List<VariableSymbol> variables() {
        return component.automata().stream().flatMap(each -> each.variables().stream()).toList();
    }

    private List<String> ambiguous() {
        Set<String> seen = new HashSet<>();
        return component.isDecomposed()
                ? List.of()
                : variables().stream()
                        .map(VariableSymbol::name)
                        .filter(name -> !seen.add(name))
                        .toList();
    }
}
