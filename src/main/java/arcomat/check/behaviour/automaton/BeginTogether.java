package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.TypedExpression;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * ARC0356: the automata of a component can begin together. A component does what all of them allow;
 * where two begin with different messages on a port, it has no run, and all that is said of its
 * runs holds.
 */
public final class BeginTogether implements Check.OnComponent {
    private static final Object SILENCE = new Object();

    /** Two initial outputs of which only one can be sent. */
    private record Clash(ItemSymbol one, ItemSymbol other) {}

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.isEventDriven()) {
            return;
        }
        List<AutomatonSymbol> automata = component.ownAutomata();
        for (int later = 1; later < automata.size(); later++) {
            for (int first = 0; first < later; first++) {
                clash(automata.get(first), automata.get(later))
                        .ifPresent(clash -> report(clash, findings));
            }
        }
    }

    private static void report(Clash clash, Findings findings) {
        findings.report(
                        clash.other().node(),
                        "another automaton of this component begins with another message on '%s',"
                                + " so there is no run that both allow; let them begin alike",
                        clash.other().target().found().orElseThrow().name())
                .related(clash.one().node(), "the other one begins so");
    }

    /** The first two that exclude each other, where each two starts of both have such ones. */
    private static Optional<Clash> clash(AutomatonSymbol one, AutomatonSymbol other) {
        List<Clash> clashes = new ArrayList<>();
        for (InitialSymbol start : one.initials()) {
            for (InitialSymbol beginning : other.initials()) {
                Optional<Clash> clash = clash(sent(start), sent(beginning));
                if (clash.isEmpty()) {
                    return Optional.empty();
                }
                clashes.add(clash.get());
            }
        }
        return clashes.stream().findFirst();
    }

    private static Optional<Clash> clash(
            Map<String, ItemSymbol> some, Map<String, ItemSymbol> others) {
        for (Map.Entry<String, ItemSymbol> each : some.entrySet()) {
            ItemSymbol other = others.get(each.getKey());
            if (other != null && differ(known(each.getValue().value()), known(other.value()))) {
                return Optional.of(new Clash(each.getValue(), other));
            }
        }
        return Optional.empty();
    }

    /** Two messages of one port, as far as the text says which they are. */
    private static boolean differ(Optional<Object> one, Optional<Object> other) {
        return one.isPresent() && other.isPresent() && !one.equals(other);
    }

    /** What is sent last on each port with a first message. */
    private static Map<String, ItemSymbol> sent(InitialSymbol initial) {
        Map<String, ItemSymbol> sent = new LinkedHashMap<>();
        for (ItemSymbol item : initial.items()) {
            Items.port(item)
                    .filter(port -> port.isOutput() && port.delay() > 0)
                    .ifPresent(port -> sent.put(port.name(), item));
        }
        return sent;
    }

    /** A message that needs no run to be known; empty for numbers with a fraction, and names. */
    private static Optional<Object> known(ItemValue value) {
        if (Items.isSilence(value)) {
            return Optional.of(SILENCE);
        }
        return value instanceof ItemValue.Single single
                ? known(single.expression().expression())
                : Optional.empty();
    }

    private static Optional<Object> known(TypedExpression expression) {
        Optional<Object> number = ConstantFolding.computed(expression).map(Object.class::cast);
        if (number.isPresent()) {
            return number;
        }
        if (expression instanceof TypedExpression.Constant constant) {
            return Optional.of(List.of(constant.type().qualifiedName(), constant.ordinal()));
        }
        return expression instanceof TypedExpression.Literal literal
                ? Optional.of(literal.value()).filter(each -> !(each instanceof Double))
                : Optional.empty();
    }
}
